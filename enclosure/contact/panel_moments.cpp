#include "enclosure/contact/panel_moments.hpp"

#include <algorithm>

#include "enclosure/number/ball_polynomial.hpp"

namespace steadyslide::enclosure {

PanelMoments::PanelMoments(const std::vector<ContactPanel>& panels, const std::vector<std::vector<Ball>>& values,
                           const std::vector<Ball>& sizes, Side c, Bits bits)
    : bits_(bits) {
  const std::size_t count = panels.size();
  const std::size_t terms = static_cast<std::size_t>(bits) / 2 + 4;
  const bool left = c == Side::left;
  const auto at = [&](std::size_t n) { return left ? n : count - 1 - n; };
  const auto y_of = [&](const ContactPanel::Node& node) -> const Ball& {
    return left ? node.from_left : node.from_right;
  };
  for (std::size_t n = 0; n < count; ++n) {
    const ContactPanel::Part& part = panels[at(n)].part();
    const Ball& start = left ? part.from_left : part.from_right;
    starts_.push_back(start.at(64));
    ends_.push_back((start + part.length).at(64));
  }
  const Sums nothing{std::vector<Ball>(terms, Ball(0, bits)), Ball(0, 64), Ball(0, 64)};
  up_to_.assign(count + 1, nothing);
  from_.assign(count + 1, nothing);
  const auto rule_error = [&](std::size_t n) { return panels[at(n)].remainder(sizes[at(n)], Ellipse::far); };
  const auto add = [](Sums& sums, const std::vector<Ball>& weights, const std::vector<Ball>& points) {
    for (const Ball& weight : weights) sums.size += abs(weight).upper().at(64);
    add_moments(sums.moments, weights, points);
  };
  for (std::size_t n = 0; n < count; ++n) {
    Sums& sums = up_to_[n + 1] = up_to_[n];
    std::vector<Ball> points;
    for (const ContactPanel::Node& node : panels[at(n)].nodes()) points.push_back(y_of(node));
    add(sums, values[at(n)], points);
    sums.remainder += rule_error(n);
  }
  for (std::size_t n = count; n-- > 1;) {  // the first one touches c
    Sums& sums = from_[n] = from_[n + 1];
    std::vector<Ball> weights, inverses;
    for (std::size_t i = 0; i < panels[at(n)].nodes().size(); ++i) {
      inverses.push_back(Ball(1) / y_of(panels[at(n)].nodes()[i]));
      weights.push_back(values[at(n)][i] * inverses.back());
    }
    add(sums, weights, inverses);
    sums.remainder += rule_error(n) * pole_bound((starts_[n] - panels[at(n)].reach(Ellipse::far)).at(64));
  }
}

PanelMoments::Rest PanelMoments::seen_from(const Ball& distance) const {
  const std::size_t count = starts_.size();
  const Ball least = distance.at(64) / Ball(4);
  const Ball most = distance.at(64) * Ball(4);
  const auto is_near = [&](const Ball& end) { return end <= least; };
  const auto is_not_far = [&](const Ball& start) { return !(start >= most); };
  Rest rest{Ball(0, bits_), 0, 0};
  rest.first = static_cast<std::size_t>(std::partition_point(ends_.begin(), ends_.end(), is_near) - ends_.begin());
  // The panel that touches c is in no sum of those from it on.
  const auto after = starts_.begin() + static_cast<std::ptrdiff_t>(std::max<std::size_t>(rest.first, 1));
  rest.last = static_cast<std::size_t>(std::partition_point(after, starts_.end(), is_not_far) - starts_.begin());
  const Ball cut = power(Ball(2, 64), -2 * static_cast<int>(up_to_[0].moments.size()));
  if (rest.first > 0) {
    const Sums& near = up_to_[rest.first];
    const Ball inverse = Ball(-1) / distance;
    Ball sum = value_at(near.moments, inverse);
    // -sum/D * (-1): 1/(D + y) = -(sum_k y^k (-1/D)^k) (-1/D).
    sum *= -inverse;
    rest.sum += Ball::plus_or_minus(sum, (near.size * cut + near.remainder * Ball(5)) * pole_bound(distance.at(64)));
  }
  if (rest.last < count) {
    const Sums& beyond = from_[rest.last];
    const Ball sum = value_at(beyond.moments, -distance);
    rest.sum += Ball::plus_or_minus(sum, beyond.size * cut + beyond.remainder);
  }
  return rest;
}

}  // namespace steadyslide::enclosure
