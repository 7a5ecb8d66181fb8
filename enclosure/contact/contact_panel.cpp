#include "enclosure/contact/contact_panel.hpp"

#include <algorithm>

namespace steadyslide::enclosure {

ContactPanel::ContactPanel(const ContactSet& set, Interval part, int n, std::optional<std::size_t> lowered, int count,
                           JacobiRules& rules)
    : part_(std::move(part)), power_(0, set.bits()) {
  const std::size_t k = part_.segment;
  const auto power = [&](std::size_t j) {
    return (n > 0 ? set.power(j) : -set.power(j)) - Ball(lowered == j ? 1 : 0, set.bits());
  };
  std::optional<std::size_t> touched;
  if (part_.touches) touched = *part_.touches == Side::left ? k : k + 1;
  if (touched) power_ = power(*touched);

  // For the bounds: distances of other points from the panel's nearer end.
  constexpr Bits few = 64;
  struct Outside {
    Ball distance;
    Ball power;
  };
  std::vector<Outside> outside;
  struct Factor {
    std::size_t j;
    Ball to_left;  ///< distance of the segment's nearer point from point j
  };
  // Points with the same power share a logarithm.
  std::vector<std::pair<Ball, std::vector<Factor>>> factors;
  for (std::size_t j = 0; j < set.points(); ++j) {
    if (touched == j || (set.is_regular(j) && lowered != j)) continue;
    const bool left = j <= k;
    const Ball p = power(j);
    Factor factor{j, left ? set.distance(j, k) : set.distance(k + 1, j)};
    outside.push_back({(factor.to_left + (left ? part_.from_left : part_.from_right)).at(few), p.at(few)});
    auto same = std::ranges::find_if(factors, [&](const auto& other) { return arb_equal(other.first.get(), p.get()); });
    if (same == factors.end()) same = factors.insert(same, {p, {}});
    same->second.push_back(std::move(factor));
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
    for (const auto& [p, points] : factors) {
      Ball product(1, set.bits());
      for (const Factor& point : points) product *= point.to_left + (point.j <= k ? from_left : from_right);
      sum += p * log(product);
    }
    const Ball weight = rule.weights[i] * scale;
    nodes_.push_back({from_left, from_right, weight * exp(sum), weight});
  }

  const Ball length = part_.length.at(few);
  for (std::size_t i = 0; i < bounds_.size(); ++i) {
    const Ball rho = ContactPanel::rho(static_cast<Ellipse>(i));
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

Ball ContactPanel::largest(const BallPolynomial& polynomial, Ellipse ellipse) const {
  const Ball r = farthest_ + reach(ellipse);
  return bound_within(polynomial, r);
}

std::vector<ContactPanel::Interval> ContactPanel::outward(const ContactSet& set, std::size_t segment, Side from,
                                                          const DistanceRange& range, std::optional<Ball> first) {
  constexpr std::size_t most_panels = 4096;  // sufficient for a distance of 1e-1200 of the contact
  const bool left = from == Side::left;
  const Ball& whole = set.length(segment);
  if (const bool at_margin = left ? segment == 0 : segment + 1 == set.segments(); !at_margin) {
    const Ball& neighbour = set.length(left ? segment - 1 : segment + 1);
    first = first ? min(*first, neighbour) : neighbour;
  }
  std::vector<Interval> result;
  Ball at = range.from;
  const Ball hair = Ball(1) + enclosure::power(Ball(2, set.bits()), 16 - static_cast<int>(set.bits()));
  for (bool more = true; more;) {
    const bool touches = at.is_zero();
    Ball length = (whole - at) / Ball(2);
    if (!touches) length = min(length, at);
    if (touches && first) length = min(length, *first);
    // The places can be chosen freely: use midpoints of balls, so that only the last length contains the box's width.
    length = length.lower();
    const Ball left_over = range.to - at;
    // If points are out of order, or closer than in any solution, use one panel, whose bounds are not finite.
    if (!length.is_positive() || result.size() == most_panels) length = left_over;
    // A rest of the size of rounding makes no panel. A rest of the box's width makes one, because otherwise it would
    // widen every node.
    more = length * hair < left_over;
    if (!more || Ball(2) * length > left_over) length = more ? (left_over / Ball(2)).lower() : left_over;
    const Ball to = at + length;
    const Ball rest = whole - to;
    Interval part{segment, left ? at : rest, left ? rest : at, length, {}};
    if (touches) part.touches = from;
    result.push_back(std::move(part));
    at = to;
  }
  if (!left) std::reverse(result.begin(), result.end());
  return result;
}

std::vector<ContactPanel::Interval> ContactPanel::divided(Interval part,
                                                          const std::function<Ball(const Interval&)>& longest) {
  if (!longest || part.length.midpoint() <= longest(part).midpoint()) return {std::move(part)};
  const Ball half = (part.length / Ball(2)).midpoint();
  const Ball rest = part.length - half;
  Interval left{part.segment, part.from_left, part.from_right + rest, half, {}};
  Interval right{part.segment, part.from_left + half, part.from_right, rest, {}};
  if (part.touches) (*part.touches == Side::left ? left : right).touches = part.touches;
  std::vector<Interval> result = divided(std::move(left), longest);
  for (Interval& piece : divided(std::move(right), longest)) result.push_back(std::move(piece));
  return result;
}

std::vector<ContactPanel::Interval> ContactPanel::graded(const ContactSet& set, std::size_t segment, Extent extent) {
  const DistanceRange half{Ball(0, set.bits()), set.length(segment) / Ball(2)};
  std::vector<Interval> result;
  if (extent != Extent::right_half) result = outward(set, segment, Side::left, half);
  if (extent != Extent::left_half) {
    for (Interval& part : outward(set, segment, Side::right, half)) result.push_back(std::move(part));
  }
  return result;
}

Ball pole_bound(const Ball& distance) {
  return distance.is_positive() ? Ball(1) / distance : Ball::unknown(distance.bits());
}

}  // namespace steadyslide::enclosure
