#include "numeric/solution/gathered_forces.hpp"

#include <array>
#include <utility>

namespace steadyslide::numeric {

template <Real R>
SurfaceForces gathered_forces(const PiecewiseTraction<R>& traction, double longest) {
  constexpr std::size_t order = SurfaceForces::order;
  SurfaceForces result;
  const std::vector<TractionPanel<R>>& panels = traction.panels();
  if (panels.empty()) return result;
  const auto width = static_cast<double>(traction.width());
  const double parts = std::ceil(width / longest);
  result.first = static_cast<double>(panels.front().left.high);
  result.length = width / parts;
  struct Moments {
    std::array<double, order> normal{}, tangential{};
  };
  std::vector<Moments> moments(static_cast<std::size_t>(parts));
  TractionNodes<R> nodes;
  for (const TractionPanel<R>& panel : panels) {
    nodes.clear();
    traction.append_nodes(panel, nodes);
    const auto ratio = static_cast<double>(panel.shear_ratio);
    for (std::size_t i = 0; i < nodes.forces.size(); ++i) {
      const auto force = static_cast<double>(nodes.forces[i]);
      const double place =
          (static_cast<double>(panel.left.moved(nodes.from_left[i]).high) - result.first) / result.length;
      const double part = std::clamp(std::floor(place), 0.0, parts - 1);
      const double y = 2 * (place - part) - 1;
      Moments& of_part = moments[static_cast<std::size_t>(part)];
      double before = y, chebyshev = 1;
      for (std::size_t k = 0; k < order; ++k) {
        of_part.normal[k] += chebyshev * force;
        of_part.tangential[k] += chebyshev * ratio * force;
        before = std::exchange(chebyshev, 2 * y * chebyshev - before);
      }
      auto error = static_cast<double>(panel.error);
      if (panel.end_error > 0) {
        const PanelPart<R> whole{R(0), panel.length, R(0)};
        error += static_cast<double>(panel.displaced(whole, nodes.from_left[i], nodes.from_right[i], R(result.length)));
      }
      result.normal_error += error * std::abs(force);
      result.tangential_error += error * std::abs(ratio * force);
    }
  }
  for (const Moments& of_part : moments) {
    for (std::size_t j = 0; j < order; ++j) {
      const double angle = std::numbers::pi * (static_cast<double>(j) + 0.5) / order;
      double normal = of_part.normal[0] / 2, tangential = of_part.tangential[0] / 2;
      for (std::size_t k = 1; k < order; ++k) {
        normal += of_part.normal[k] * std::cos(static_cast<double>(k) * angle);
        tangential += of_part.tangential[k] * std::cos(static_cast<double>(k) * angle);
      }
      result.normal.push_back(2 * normal / order);
      result.tangential.push_back(2 * tangential / order);
    }
  }
  return result;
}

template <Real R>
std::vector<SurfaceForces> gathered_on_meshes(const PiecewiseTraction<R>& traction, double longest) {
  std::vector<SurfaceForces> result{gathered_forces(traction, longest)};
  for (const PiecewiseTraction<R>& coarser : traction.coarser()) result.push_back(gathered_forces(coarser, longest));
  return result;
}

#define STEADYSLIDE_INSTANTIATE(R)                                             \
  template SurfaceForces gathered_forces(const PiecewiseTraction<R>&, double); \
  template std::vector<SurfaceForces> gathered_on_meshes(const PiecewiseTraction<R>&, double);
STEADYSLIDE_FOR_EACH_REAL(STEADYSLIDE_INSTANTIATE)
#undef STEADYSLIDE_INSTANTIATE

}  // namespace steadyslide::numeric
