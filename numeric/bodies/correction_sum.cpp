#include "numeric/bodies/correction_sum.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace steadyslide::numeric {

CorrectionSum::CorrectionSum(std::shared_ptr<const SurfaceCorrection<double>> correction,
                             const PiecewiseTraction<double>& traction)
    : correction_(std::move(correction)) {
  const std::vector<TractionPanel<double>>& panels = traction.panels();
  if (panels.empty()) return;
  // N and T are analytic at least a part's length around it: their series converge like 4.2^-n.
  constexpr std::size_t order = 26;
  const double first = panels.front().left.high, width = traction.width();
  const double parts = std::ceil(width / correction_->radius(0));
  const double length = width / parts;
  struct Moments {
    std::array<double, order> all{}, sliding{};
  };
  std::vector<Moments> moments(static_cast<std::size_t>(parts));
  TractionNodes<double> nodes;
  for (const TractionPanel<double>& panel : panels) {
    nodes.clear();
    traction.append_nodes(panel, nodes);
    for (std::size_t i = 0; i < nodes.forces.size(); ++i) {
      const double place = (panel.left.moved(nodes.from_left[i]).high - first) / length;
      const double part = std::clamp(std::floor(place), 0.0, parts - 1);
      const double y = 2 * (place - part) - 1;
      double before = y, chebyshev = 1;
      for (std::size_t k = 0; k < order; ++k) {
        Moments& of_part = moments[static_cast<std::size_t>(part)];
        of_part.all[k] += chebyshev * nodes.forces[i];
        of_part.sliding[k] -= chebyshev * panel.shear_ratio * nodes.forces[i];
        before = std::exchange(chebyshev, 2 * y * chebyshev - before);
      }
    }
  }
  for (std::size_t part = 0; part < moments.size(); ++part) {
    for (std::size_t j = 0; j < order; ++j) {
      const double angle = std::numbers::pi * (static_cast<double>(j) + 0.5) / order;
      double all = moments[part].all[0] / 2, sliding = moments[part].sliding[0] / 2;
      for (std::size_t k = 1; k < order; ++k) {
        all += moments[part].all[k] * std::cos(static_cast<double>(k) * angle);
        sliding += moments[part].sliding[k] * std::cos(static_cast<double>(k) * angle);
      }
      places_.push_back(first + length * (static_cast<double>(part) + (1 + std::cos(angle)) / 2));
      forces_.push_back(2 * all / order);
      sliding_forces_.push_back(2 * sliding / order);
    }
  }
}

double CorrectionSum::slope(double x) const {
  double sum = 0;
  for (std::size_t i = 0; i < places_.size(); ++i) {
    const double y = places_[i] - x;
    sum += forces_[i] * correction_->normal_slope(y);
    if (sliding_forces_[i] != 0) sum += sliding_forces_[i] * correction_->coupling_slope(y);
  }
  return sum / std::numbers::pi;
}

double CorrectionSum::height(double x) const {
  double sum = 0;
  for (std::size_t i = 0; i < places_.size(); ++i) {
    const double y = places_[i] - x;
    sum -= forces_[i] * correction_->normal(y) + sliding_forces_[i] * correction_->coupling(y);
  }
  return sum / std::numbers::pi;
}

}  // namespace steadyslide::numeric
