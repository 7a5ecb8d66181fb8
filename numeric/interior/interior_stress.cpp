#include "numeric/interior/interior_stress.hpp"

#include <stdexcept>

#include "numeric/solution/gathered_forces.hpp"

namespace steadyslide::numeric {

template <Real R>
InteriorStress<R>::InteriorStress(PiecewiseTraction<R> traction)
    : laws_{HookesLaw<R>(traction.elasticity())}, meshes_(nested_sums<R, StressKernel<R>>(std::move(traction), R(1))) {}

template <Real R>
InteriorStress<R>::InteriorStress(const ContactProblem& problem, const ContactSolution<R>& solution)
    : InteriorStress(solution) {
  const Body& body = problem.body();
  if (body.is_half_plane()) return;
  if (body.period()) {
    images_ = std::make_shared<PeriodicImages>(
        problem, gathered_on_meshes(this->traction(), PeriodicImages::longest_part(body)));
    return;
  }
  if (body.layers().empty()) throw std::invalid_argument("given symbols do not tell stresses below the surface");
  layers_ = std::make_shared<LayerField>(problem, gathered_on_meshes(this->traction(), LayerField::longest_part(body)));
  const auto add = [&](const Solid& solid) { laws_.emplace_back(Elasticity(solid, problem.elasticity().plane())); };
  for (std::size_t n = 1; n < body.layers().size(); ++n) add(body.layers()[n].solid);
  if (body.base()) add(*body.base());
}

template <Real R>
StressState<R> InteriorStress<R>::at(const SurfacePlace<R>& x, const R& z, std::span<const Mesh> meshes,
                                     TractionNodes<R>& nodes) const {
  const std::size_t layer = layers_ ? layers_->layer_at(static_cast<double>(z)) : 0;
  if (!reaches(z) || layer >= laws_.size()) {
    const Estimate<R> unknown{R(std::numeric_limits<double>::quiet_NaN()), infinity<R>()};
    return laws_.front().completed(unknown, unknown, unknown, unknown);
  }
  const R period = images_ ? to_real<R>(images_->period()) : R(0);
  const SurfacePlace<R> place = images_ ? x.moved(-period * images_->periods_away(static_cast<double>(x.high))) : x;
  const auto on_mesh = [&](const Mesh& mesh) {
    std::array<Estimate<R>, 4> stress;
    const auto add_half_plane = [&](const SurfacePlace<R>& there) {
      const ForceSums<R> sums = mesh.at(there, z, nodes);
      const auto normal = [&](std::size_t j) { return Estimate<R>{sums.normal[j], sums.normal_error[j]}; };
      const auto tangential = [&](std::size_t j) { return Estimate<R>{sums.tangential[j], sums.tangential_error[j]}; };
      const R factor = 2 / pi<R>();
      stress[0] += factor * (normal(2) - tangential(3));
      stress[1] += factor * (normal(0) - tangential(1));
      stress[2] += factor * (normal(1) - tangential(2));
      stress[3] += normal(1) + normal(3) + tangential(0) + tangential(2);
    };
    if (layer == 0) add_half_plane(place);
    if (images_) {
      for (const int side : {-1, 1}) add_half_plane(place.moved(side * period));
    }
    if (!layers_ && !images_) return stress;
    const auto index = static_cast<std::size_t>(&mesh - meshes_.data());
    const auto at_x = static_cast<double>(place.high), at_z = static_cast<double>(z);
    const auto smooth = layers_ ? layers_->at(index, at_x, at_z) : images_->at(index, at_x, at_z);
    for (std::size_t j = 0; j < 4; ++j)
      stress[j] += (j == 3 ? pi<R>() : R(1)) * Estimate<R>{R(smooth[j].value), R(smooth[j].error)};
    return stress;
  };
  // Cells do not resolve the stress at depths like their length.
  const bool is_deep = traction().panels().empty() || z >= 2 * traction().panels().front().length;
  const auto [xx, zz, xz, pi_w] = on_nested_meshes(meshes, on_mesh, is_deep ? traction().mesh_rates().rate : 1);
  return laws_[layer].completed(xx, zz, xz, pi_w);
}

template <Real R>
StressState<R> InteriorStress<R>::at(const Rational& x, const Rational& z) const {
  if (!(z > 0)) throw std::invalid_argument(below);
  TractionNodes<R> nodes;
  return at(SurfacePlace<R>::of(x), to_real<R>(z), std::span(meshes_), nodes);
}

template <Real R>
void InteriorStress<R>::at(std::span<const R> x, std::span<const R> z, std::span<StressState<R>> states) const {
  TractionNodes<R> nodes;
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (!(z[i] > 0)) throw std::invalid_argument(below);
    states[i] = at({x[i], R(0)}, z[i], std::span(meshes_), nodes);
  }
}

template <Real R>
StressState<R> InteriorStress<R>::on_finest_mesh(const R& x, const R& z) const {
  TractionNodes<R> nodes;
  return at({x, R(0)}, z, std::span(meshes_).first(1), nodes);
}

STEADYSLIDE_INSTANTIATE_CLASS(InteriorStress)

}  // namespace steadyslide::numeric
