#include "numeric/interior/interior_stress.hpp"

#include <stdexcept>

namespace steadyslide::numeric {

template <Real R>
InteriorStress<R>::InteriorStress(PiecewiseTraction<R> traction)
    : law_(traction.elasticity()), meshes_(nested_sums<R, StressKernel<R>>(std::move(traction), R(1))) {}

template <Real R>
StressState<R> InteriorStress<R>::at(const SurfacePlace<R>& x, const R& z, std::span<const Mesh> meshes,
                                     TractionNodes<R>& nodes) const {
  if (!reaches(z)) {
    const Estimate<R> unknown{R(std::numeric_limits<double>::quiet_NaN()), infinity<R>()};
    return law_.completed(unknown, unknown, unknown, unknown);
  }
  const auto on_mesh = [&](const Mesh& mesh) {
    const ForceSums<R> sums = mesh.at(x, z, nodes);
    const auto normal = [&](std::size_t j) { return Estimate<R>{sums.normal[j], sums.normal_error[j]}; };
    const auto tangential = [&](std::size_t j) { return Estimate<R>{sums.tangential[j], sums.tangential_error[j]}; };
    const R factor = 2 / pi<R>();
    return std::array<Estimate<R>, 4>{factor * (normal(2) - tangential(3)), factor * (normal(0) - tangential(1)),
                                      factor * (normal(1) - tangential(2)),
                                      normal(1) + normal(3) + tangential(0) + tangential(2)};
  };
  // Cells do not resolve the stress at depths like their length.
  const bool is_deep = traction().panels().empty() || z >= 2 * traction().panels().front().length;
  const auto [xx, zz, xz, pi_w] = on_nested_meshes(meshes, on_mesh, is_deep ? traction().mesh_rates().rate : 1);
  return law_.completed(xx, zz, xz, pi_w);
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
