#include "numeric/interior/average_stress.hpp"

#include <stdexcept>

namespace steadyslide::numeric {

template <Real R>
AverageStress<R>::AverageStress(PiecewiseTraction<R> traction, const R& length)
    : length_(length), law_(traction.elasticity()) {
  if (!(length > 0)) throw std::invalid_argument("length of a window");
  const R width = traction.width();
  meshes_ = nested_sums<R, PotentialKernel<R>>(std::move(traction), width);
}

template <Real R>
StressState<R> AverageStress<R>::at(const R& x, const R& z, std::span<const Mesh> meshes,
                                    TractionNodes<R>& nodes) const {
  if (!(z >= 0)) throw std::invalid_argument("the depth of a point in the body is at least 0");
  const SurfacePlace<R> middle{x, R(0)}, begin = middle.moved(-length_ / 2), end = middle.moved(length_ / 2);
  const auto on_mesh = [&](const Mesh& mesh) {
    const ForceSums<R> before = mesh.at(begin, z, nodes), after = mesh.at(end, z, nodes);
    const auto mean = [&](const R& from, const R& to, const R& from_error, const R& to_error) {
      return Estimate<R>{(to - from) / length_, (to_error + from_error) / length_};
    };
    const auto normal = [&](std::size_t j) {
      return mean(before.normal[j], after.normal[j], before.normal_error[j], after.normal_error[j]);
    };
    const auto tangential = [&](std::size_t j) {
      return mean(before.tangential[j], after.tangential[j], before.tangential_error[j], after.tangential_error[j]);
    };
    const R factor = 1 / pi<R>();
    return std::array<Estimate<R>, 4>{factor * (normal(0) - normal(2) - R(2) * tangential(1) - tangential(3)),
                                      factor * (normal(0) + normal(2) + tangential(3)),
                                      factor * (tangential(2) - tangential(0) - normal(3)), normal(1) + tangential(0)};
  };
  const auto [xx, zz, xz, pi_w] = on_nested_meshes(meshes, on_mesh, traction().mesh_rates().surface_rate);
  return law_.completed(xx, zz, xz, pi_w);
}

template <Real R>
void AverageStress<R>::at(std::span<const R> x, std::span<const R> z, std::span<StressState<R>> states) const {
  TractionNodes<R> nodes;
  for (std::size_t i = 0; i < x.size(); ++i) states[i] = at(x[i], z[i], std::span(meshes_), nodes);
}

template <Real R>
StressState<R> AverageStress<R>::on_finest_mesh(const R& x, const R& z) const {
  TractionNodes<R> nodes;
  return at(x, z, std::span(meshes_).first(1), nodes);
}

STEADYSLIDE_INSTANTIATE_CLASS(AverageStress)

}  // namespace steadyslide::numeric
