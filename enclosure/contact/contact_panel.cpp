#include "enclosure/contact/contact_panel.hpp"

#include <algorithm>

namespace steadyslide::enclosure {

ContactPanel::ContactPanel(const ContactSet& set, Part part, int n, std::optional<std::size_t> lowered, int count,
                           JacobiRules& rules)
    : part_(std::move(part)), power_(0, set.bits()) {
  const std::size_t k = part_.segment;
  const auto power = [&](std::size_t j) {
    return (n > 0 ? set.power(j) : -set.power(j)) - Ball(lowered == j ? 1 : 0, set.bits());
  };
  std::optional<std::size_t> touched;
  if (part_.touches) touched = *part_.touches == Side::left ? k : k + 1;
  if (touched) power_ = power(*touched);

  // For the bounds: distances of the other points from the panel's nearer end.
  constexpr Bits few = 64;
  struct Outside {
    Ball distance;
    Ball power;
  };
  std::vector<Outside> outside;
  struct Factor {
    std::size_t j;
    Ball power;
    Ball to_left;  ///< of the segment's nearer point from point j
  };
  std::vector<Factor> factors;
  for (std::size_t j = 0; j < set.points(); ++j) {
    if (touched == j || (set.is_regular(j) && lowered != j)) continue;
    const bool left = j <= k;
    Factor factor{j, power(j), left ? set.distance(j, k) : set.distance(k + 1, j)};
    outside.push_back({(factor.to_left + (left ? part_.from_left : part_.from_right)).at(few), factor.power.at(few)});
    factors.push_back(std::move(factor));
  }

  const Ball zero(0, set.bits());
  const bool at_right = part_.touches == Side::right;
  const JacobiRule& rule = rules(count, at_right ? zero : power_, at_right ? power_ : zero);
  const Ball half_length = part_.length / Ball(2);
  const Ball scale = enclosure::power(half_length, power_ + Ball(1));
  for (std::size_t i = 0; i < rule.size(); ++i) {
    const Ball from_left = part_.from_left + half_length * rule.from_left[i];
    const Ball from_right = part_.from_right + half_length * rule.from_right[i];
    Ball sum(0, set.bits());
    for (const Factor& factor : factors) {
      sum += factor.power * log(factor.to_left + (factor.j <= k ? from_left : from_right));
    }
    const Ball weight = rule.weights[i] * scale;
    nodes_.push_back({from_left, from_right, weight * exp(sum), weight});
  }

  const Ball length = part_.length.at(few);
  for (std::size_t i = 0; i < bounds_.size(); ++i) {
    const Ball rho(std::array{Rational(16, 5), Rational(23, 5), Rational(5)}[i], few);
    const Ball reach = ((rho + Ball(1) / rho) / Ball(2) - Ball(1)) * length / Ball(2);
    Ball sum(0, few);
    bool clear = true;
    for (const Outside& point : outside) {
      const Ball nearest = point.distance - reach;
      clear = clear && nearest.is_positive();
      sum += max(point.power * log(nearest), point.power * log(point.distance + length + reach));
    }
    const Ball end = rule.remainder(Ball(1, few), rho).at(few) * scale.at(few);
    const Ball product = clear ? exp(sum) : Ball::unknown(few);
    bounds_[i] = {reach, product, end * product, end};
  }
  farthest_ = max(abs(set.x(k) + part_.from_left), abs(set.x(k + 1) - part_.from_right)).at(few);
}

Ball ContactPanel::largest(const std::vector<Ball>& polynomial, Ellipse ellipse) const {
  const Ball r = farthest_ + reach(ellipse);
  Ball value(0, r.bits());
  for (std::size_t i = polynomial.size(); i-- > 0;) value = value * r + abs(polynomial[i].at(r.bits()));
  return value;
}

std::vector<ContactPanel::Part> ContactPanel::graded(const ContactSet& set, std::size_t segment, Extent extent) {
  const Ball half = set.length(segment) / Ball(2);
  std::vector<Part> result;
  // Outwards from one of the segment's points to its middle, each panel as long as what lies behind it.
  const auto fill = [&](Side side) {
    const bool left = side == Side::left;
    const std::size_t point = left ? segment : segment + 1;
    const bool at_margin = left ? point == 0 : point + 1 == set.points();
    Ball from(0, set.bits());
    bool touches = true;
    for (bool more = true; more;) {
      // Places are our choice: midpoints of balls, so that only the last length carries the box's width.
      Ball length = touches ? (at_margin ? half : set.length(left ? segment - 1 : segment + 1)) : from;
      length = length.lower();
      more = length < half - from;
      if (!more || Ball(2) * length > half - from) length = more ? ((half - from) / Ball(2)).lower() : half - from;
      Ball to = from + length;
      const Ball rest = set.length(segment) - to;
      Part part{segment, left ? from : rest, left ? rest : from, length, {}};
      if (touches) part.touches = side;
      result.push_back(std::move(part));
      from = to;
      touches = false;
    }
  };
  if (extent != Extent::right_half) fill(Side::left);
  const auto middle = static_cast<std::ptrdiff_t>(result.size());
  if (extent != Extent::left_half) fill(Side::right);
  std::reverse(result.begin() + middle, result.end());
  return result;
}

Ball pole_bound(const Ball& distance) {
  return distance.is_positive() ? Ball(1) / distance : Ball::unknown(distance.bits());
}

}  // namespace steadyslide::enclosure
