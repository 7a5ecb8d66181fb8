#include "numeric/riemann_hilbert/gap_integral.hpp"

#include <cmath>
#include <stdexcept>

#include "numeric/number/compensated_sum.hpp"

namespace steadyslide::numeric {

template <Real R>
R GapIntegral<R>::step(std::size_t j) const {
  const auto* anchor = set().anchor_at(j);
  return anchor ? anchor->step : R(0);
}

template <Real R>
std::size_t GapIntegral<R>::slope_on(std::size_t segment, bool left_half) const {
  // Next to an end at a break, B_k is smooth if k is that of the contact.
  const bool left = set().point(segment).is_end();
  const bool right = set().point(segment + 1).is_end();
  if (left && (left_half || !right)) return form_->slope_at(segment - 1);
  if (right) return form_->slope_at(segment + 1);
  return form_->slope_at(segment);
}

template <Real R>
bool GapIntegral<R>::is_uniform(std::size_t segment) const {
  const auto component = [&](Side end) {
    return form_->y().component_at(beside(set(), end == Side::left ? segment : segment + 1, opposite(end), R(0)));
  };
  return slope_on(segment, true) == slope_on(segment, false) && component(Side::left) == component(Side::right);
}

template <Real R>
void GapIntegral<R>::add_nodes(const SegmentPart<R>& part, std::vector<GapNode<R>>& nodes) const {
  const R middle = set().length(part.segment) / 2;
  const bool right_half = part.from_left >= middle;
  const std::size_t left = slope_on(part.segment, true);
  const std::size_t right = slope_on(part.segment, false);
  if (is_uniform(part.segment) || right_half || part.from_right >= middle) {
    add_nodes(part, right_half ? right : left, nodes);
    return;
  }
  add_nodes({part.segment, part.from_left, middle - part.from_left, middle}, left, nodes);
  add_nodes({part.segment, middle, middle - part.from_right, part.from_right}, right, nodes);
}

template <Real R>
void GapIntegral<R>::add_nodes(const SegmentPart<R>& part, std::size_t slope, std::vector<GapNode<R>>& nodes) const {
  const SignedFundamentalSolution<R>& y = form_->y();
  const auto power_at = [this, &y](std::size_t j) {
    const Power<R>& p = y.power(j);
    return set().point(j).vanishes ? Power<R>{p.value - 1, p.value} : p;
  };
  for (const JacobiPanel<R>& panel : form_->panels(part, power_at)) {
    for (std::size_t i = 0; i < panel.rule->size(); ++i) {
      const SurfacePoint<R> at = panel.node(set(), i);
      nodes.push_back({at, slope, panel.node_weight(i), y.sign(at.segment) * y.common_modulus(at), y.to_pivot(at)});
    }
  }
}

template <Real R>
Estimate<R> GapIntegral<R>::slope_difference(const SegmentPart<R>& part) const {
  // In a segment with contact at both ends, the nodes change their k in the middle.
  const RoundedProblem<R>& problem = form_->problem();
  const std::size_t segment = part.segment;
  const std::size_t own = form_->slope_at(segment);
  const R middle = set().length(segment) / 2;
  const bool in_left_half = part.from_right >= middle;
  const bool in_right_half = part.from_left >= middle;
  Estimate<R> sum;
  const auto add = [&](std::size_t k, const R& from_left, const R& length) {
    if (k == own || !(length > 0)) return;
    const auto place = [&](const R& d) { return surface_point(set(), segment, d, set().length(segment) - d).node.x; };
    const R left = place(from_left);
    const R right = place(from_left + length);
    for (const auto& [index, sign] : {std::pair(own, 1), {k, -1}}) {
      const R rise = problem.profile_increment(index, left, length);
      const R size = problem.slope_estimate(index, left).error + problem.slope_estimate(index, right).error;
      sum += Estimate<R>{sign * rise, size * length};
    }
  };
  if (!in_right_half)
    add(slope_on(segment, true), part.from_left, in_left_half ? part.length : R(middle - part.from_left));
  if (!in_left_half) {
    add(slope_on(segment, false), std::max(part.from_left, middle),
        in_right_half ? part.length : R(middle - part.from_right));
  }
  return sum;
}

template <Real R>
std::vector<GapNode<R>> GapIntegral<R>::rule() const {
  std::vector<GapNode<R>> nodes;
  for (std::size_t k = end_; k < set().segments() && !set().in_contact(k); ++k) {
    add_nodes(whole_segment(set(), k), nodes);
  }
  return nodes;
}

template <Real R>
Estimate<R> GapIntegral<R>::closure_error(const std::vector<GapNode<R>>& rule) const {
  EstimateSum<R> sum;
  const auto add_step = [&](std::size_t j) { sum.add(Estimate<R>{step(j), R(0)}.widened(epsilon<R>())); };
  std::size_t k = end_;
  for (; k < set().segments() && !set().in_contact(k); ++k) {
    add_step(k);
    sum.add(slope_difference(whole_segment(set(), k)));
  }
  add_step(k);
  const SignedFundamentalSolution<R>& y = form_->y();
  for (const GapNode<R>& node : rule) {
    Estimate<R> b = form_->regular_factor(node.slope, node.at);
    // B itself, with its value at the pivot, which is not 0 until the ends are found.
    if (!y.pivots().empty()) b = node.to_pivot * b + form_->pivot_moment(y.component_at(node.at));
    sum.add(node.term(b));
  }
  return sum.value();
}

template <Real R>
Estimate<R> GapIntegral<R>::rise(const SegmentPart<R>& part, bool rightwards) const {
  const R height = step(rightwards ? part.segment : part.segment + 1);
  EstimateSum<R> sum(Estimate<R>{height, R(0)}.widened(epsilon<R>()) + slope_difference(part));
  std::vector<GapNode<R>> nodes;
  add_nodes(part, nodes);
  for (const GapNode<R>& node : nodes) {
    sum.add(node.term(node.to_pivot * form_->regular_factor(node.slope, node.at)));
  }
  Estimate<R> result = sum.value();
  if (errors_) {
    // Twice, because q and the tilt depend on the ends.
    result.error += 2 * form_->integral_of_error(part, [this](const SurfacePoint<R>& at) {
      return R(form_->modulus(at) * form_->error_of_state(at, *errors_));
    });
  }
  return rightwards ? result : -result;
}

template <Real R>
Estimate<R> GapIntegral<R>::reduced_gap(const SurfacePoint<R>& at) const {
  if (!in_support(set(), at)) {
    throw std::domain_error("a gap off the support: there is no indenter");
  }
  const auto segment = static_cast<std::size_t>(at.segment);
  const bool rightwards = is_rightwards(at);
  const std::size_t whole = rightwards ? segment - end_ : end_ - 1 - segment;
  while (rises_.size() < whole) {
    const std::size_t k = rightwards ? end_ + rises_.size() : end_ - 1 - rises_.size();
    const Estimate<R> more = rise(whole_segment(set(), k), rightwards);
    rises_.push_back(rises_.empty() ? more : rises_.back() + more);
  }
  const auto& [x, from_left, from_right] = at.node;
  const SegmentPart<R> part = rightwards ? SegmentPart<R>{segment, R(0), from_left, from_right}
                                         : SegmentPart<R>{segment, from_left, from_right, R(0)};
  const Estimate<R> last = rise(part, rightwards);
  return whole == 0 ? last : rises_[whole - 1] + last;
}

template <Real R>
R GapIntegral<R>::profile_increment(const SurfacePoint<R>& at) const {
  const RoundedProblem<R>& problem = form_->problem();
  const auto segment = static_cast<std::size_t>(at.segment);
  const bool rightwards = is_rightwards(at);
  const auto rise = [&](std::size_t k, const R& from, const R& length) -> R {
    const R height = problem.profile_increment(form_->slope_at(k), from, length);
    return rightwards ? step(k) + height : -(step(k + 1) + height);
  };
  const std::size_t whole = rightwards ? segment - end_ : end_ - 1 - segment;
  while (profile_rises_.size() < whole) {
    const std::size_t k = rightwards ? end_ + profile_rises_.size() : end_ - 1 - profile_rises_.size();
    const R more = rise(k, set().x(k), set().length(k));
    profile_rises_.push_back(profile_rises_.empty() ? more : R(profile_rises_.back() + more));
  }
  const R last =
      rightwards ? rise(segment, set().x(segment), at.node.from_left) : rise(segment, at.node.x, at.node.from_right);
  return form_->tilt() * form_->distance(at, end_) + (whole == 0 ? last : R(profile_rises_[whole - 1] + last));
}

STEADYSLIDE_INSTANTIATE_CLASS(GapIntegral)

}  // namespace steadyslide::numeric
