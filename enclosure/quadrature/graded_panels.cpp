#include "enclosure/quadrature/graded_panels.hpp"

#include <algorithm>
#include <optional>
#include <utility>

namespace steadyslide::enclosure {
namespace {

struct PanelSpan {
  Ball from_left;
  Ball from_right;
  Ball length;
};

class Grading {
 public:
  Grading(const Ball& left, const Ball& right, const std::vector<OutsidePoint>& outside, double clearance)
      : left_{left, {}}, right_{right, {}}, outside_(outside), clearance_(Ball::exactly(clearance * 0.9375, 64)) {
    for (const OutsidePoint& point : outside) {
      std::optional<Ball>& nearest = (point.side == Side::left ? left_ : right_).nearest;
      if (!nearest || point.distance.midpoint() < *nearest) nearest = point.distance.midpoint();
    }
  }

  /// True if the part is far enough from all places. This is only a choice, so it uses midpoints; equality up to
  /// rounding is sufficient.
  bool is_clear(const PanelSpan& part) const {
    return is_far(left_, part.from_left, part.length) && is_far(right_, part.from_right, part.length);
  }

  GradedPanel panel(PanelSpan part) const {
    std::vector<OutsidePoint> outside;
    for (const OutsidePoint& point : outside_) {
      const Ball& to_end = point.side == Side::left ? part.from_left : part.from_right;
      outside.push_back({point.side, point.distance + to_end, point.power});
    }
    const auto own_power = [&](const Surroundings& end, const Ball& to_end, Side side) {
      if (to_end.is_zero()) return end.power;
      if (!end.power.is_zero()) outside.push_back({side, to_end, end.power});
      return Ball(0);
    };
    const Ball left = own_power(left_, part.from_left, Side::left);
    const Ball right = own_power(right_, part.from_right, Side::right);
    return {std::move(part.from_left), std::move(part.from_right), std::move(part.length), left, right,
            std::move(outside)};
  }

 private:
  struct Surroundings {
    Ball power;
    std::optional<Ball> nearest;
  };

  bool is_far(const Surroundings& end, const Ball& to_end, const Ball& length) const {
    Ball distance = to_end.midpoint();
    if (to_end.is_zero() || end.power.is_zero()) {
      if (!end.nearest) return true;
      distance += *end.nearest;
    }
    return clearance_ * length.midpoint() < distance;
  }

  Surroundings left_;
  Surroundings right_;
  const std::vector<OutsidePoint>& outside_;
  Ball clearance_;
};

}  // namespace

std::vector<GradedPanel> graded(const Ball& length, const Ball& left, const Ball& right,
                                const std::vector<OutsidePoint>& outside, double clearance) {
  const Grading grading(left, right, outside, clearance);
  const bool decided = length.is_finite() && length.is_positive() &&
                       std::all_of(outside.begin(), outside.end(), [](const OutsidePoint& point) {
                         return point.distance.is_finite() && point.distance.is_positive();
                       });
  std::vector<GradedPanel> panels;
  std::vector<PanelSpan> waiting{{Ball(0, length.bits()), Ball(0, length.bits()), length}};
  while (!waiting.empty()) {
    PanelSpan part = std::move(waiting.back());
    waiting.pop_back();
    if (!decided || grading.is_clear(part)) {
      panels.push_back(grading.panel(std::move(part)));
      continue;
    }
    const Ball half = made_by(arb_mul_2exp_si, part.length.bits(), part.length.get(), -1);
    waiting.push_back({part.from_left + half, part.from_right, half});
    waiting.push_back({part.from_left, part.from_right + half, half});
  }
  return panels;
}

}  // namespace steadyslide::enclosure
