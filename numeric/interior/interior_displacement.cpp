#include "numeric/interior/interior_displacement.hpp"

#include <stdexcept>

namespace steadyslide::numeric {

template <Real R>
InteriorDisplacement<R>::InteriorDisplacement(PiecewiseTraction<R> traction, const Rational& origin) {
  const Elasticity elasticity = traction.elasticity();
  if (!elasticity.half_space()) throw std::invalid_argument("a displacement needs elastic constants");
  const Rational kolosov = elasticity.half_space()->kolosov(elasticity.plane());
  half_sum_ = to_real<R>((kolosov + 1) / 2);
  half_difference_ = to_real<R>((kolosov - 1) / 2);
  scale_ = 1 / (2 * pi<R>() * to_real<R>(elasticity.half_space()->shear_modulus()));
  const R width = traction.width();
  meshes_ = nested_sums<R, PotentialKernel<R>>(std::move(traction), width);
  at_origin_ = unscaled(origin, 0);
}

template <Real R>
std::vector<std::array<Estimate<R>, 2>> InteriorDisplacement<R>::unscaled(const Rational& x, const Rational& z) const {
  const SurfacePlace<R> place = SurfacePlace<R>::of(x);
  TractionNodes<R> nodes;
  std::vector<std::array<Estimate<R>, 2>> result;
  for (const BodySums<R, PotentialKernel<R>>& mesh : meshes_) {
    const ForceSums<R> sums = mesh.at(place, to_real<R>(z), nodes);
    const auto normal = [&](std::size_t j) { return Estimate<R>{sums.normal[j], sums.normal_error[j]}; };
    const auto tangential = [&](std::size_t j) { return Estimate<R>{sums.tangential[j], sums.tangential_error[j]}; };
    result.push_back({half_difference_ * normal(0) - normal(2) - half_sum_ * tangential(1) - tangential(3),
                      half_sum_ * normal(1) - normal(3) + half_difference_ * tangential(0) + tangential(2)});
  }
  return result;
}

template <Real R>
Displacement<R> InteriorDisplacement<R>::at(const Rational& x, const Rational& z) const {
  if (z < 0) throw std::invalid_argument("the depth of a point in the body is at least 0");
  std::vector<std::array<Estimate<R>, 2>> there = unscaled(x, z);
  for (std::size_t k = 0; k < there.size(); ++k) {
    for (std::size_t i = 0; i < 2; ++i) there[k][i] = scale_ * (there[k][i] - at_origin_[k][i]);
  }
  using Both = std::array<Estimate<R>, 2>;
  const auto [along, down] = on_nested_meshes(
      std::span<const Both>(there), [](const Both& mesh) { return mesh; },
      meshes_.front().traction().mesh_rates().rate);
  return {along, down};
}

STEADYSLIDE_INSTANTIATE_CLASS(InteriorDisplacement)

}  // namespace steadyslide::numeric
