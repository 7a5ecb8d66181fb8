#include "numeric/riemann_hilbert/contact_newton.hpp"

#include <cmath>

#include "numeric/riemann_hilbert/contact_equations.hpp"

namespace steadyslide::numeric {
namespace {

template <Real R>
bool is_finite(const std::vector<R>& values) {
  for (const R& v : values) {
    if (!(abs(v) < infinity<R>())) return false;
  }
  return true;
}

/// The iteration on one kind of contact set.
template <Real R>
class Newton {
 public:
  using Status = typename NewtonResult<R>::Status;

  Newton(const RoundedProblem<R>& problem, ContactState<R> state, const std::vector<R>& limits, JacobiRules<R>& rules)
      : problem_(problem), state_(std::move(state)), limits_(limits), rules_(rules) {}

  NewtonResult<R> run() {
    constexpr int max_steps = 100;
    // Below this fraction of the hull, after quadratic convergence, only rounding errors remain.
    const R rounding = 8 * epsilon<R>();
    const R lengths_rounding = R(1e4) * epsilon<R>();
    R previous = infinity<R>();
    R previous_beside = infinity<R>();
    for (int iteration = 0; iteration < max_steps; ++iteration) {
      const TractionRepresentation<R> form(problem_, state_.set, state_.q, state_.tilt, rules_);
      ContactEquations<R> linear(form);
      if (!linear.solve()) break;
      std::vector<R> ends = linear.end_steps();
      const R tilt_step = linear.tilt_step();
      if (!is_finite(ends) || !(abs(tilt_step) < infinity<R>())) break;

      free_ = state_.set.movable();
      R largest = 0;
      for (const R& step : ends) largest = std::max(largest, abs(step));
      const R hull = state_.set.span_length();
      const R beside_wedges = follow_lengths(ends);
      const auto [part, tightest] = admissible_part(ends);
      const bool moves = largest > rounding * hull || limit(tightest) == problem_.shortest_gap();
      if (goes_in_circles(beside_wedges)) break;
      if (part < 1 && state_.set.length(tightest) < limit(tightest) && moves) {
        return {std::move(state_), Status::collapse, tightest, std::nullopt, largest};
      }
      for (R& step : ends) step *= part;
      const std::vector<R> q_step = linear.q_step(ends, part);
      state_.set.move(ends);
      for (std::size_t k = 0; k < q_step.size(); ++k) state_.q[k] += q_step[k];
      state_.tilt += part * tilt_step;

      const R movement = std::max({largest / hull, relative_change(q_step, state_.q) / part,
                                   abs(tilt_step) / std::max(abs(state_.tilt), R(1))});
      if (!(movement < infinity<R>())) break;
      const bool lengths_settled = beside_wedges <= lengths_rounding;
      // With quadratic convergence, a movement m after m_0 is followed by one like m^3/m_0^2; here the limit is a
      // thousand times that. In higher precision than double, where a step is most of the work, no further step is made
      // to check this.
      const auto next = [](const R& now, const R& before) {
        return now == 0 ? R(0) : R(1000 * now * (now * now / (before * before)));
      };
      const R left = next(movement, previous);
      const R left_beside = next(beside_wedges, previous_beside);
      const bool is_quadratic = !std::same_as<R, double> && part == 1 && std::max(previous, previous_beside) < R(1e-6);
      const bool follows = is_quadratic && left <= rounding && left_beside <= rounding;
      const bool settled = follows || (movement <= rounding && lengths_settled);
      // Rounding may keep the last steps above this limit: they are small and no longer decrease.
      const bool at_rounding_level = movement < sqrt(epsilon<R>()) && movement >= previous / 2 &&
                                     beside_wedges <= R(1e-3) &&
                                     (lengths_settled || beside_wedges >= previous_beside / 2);
      // If only rounding moves an end across an anchor, the step would be shortened forever. The end is at its place.
      if (settled || (part == 1 && at_rounding_level)) {
        if (!linear.is_complete()) break;
        StateErrors<R> rounding = linear.rounding();
        return {std::move(state_),
                Status::converged,
                0,
                std::nullopt,
                (follows ? left : movement) * hull,
                follows ? left_beside : beside_wedges,
                std::move(rounding)};
      }
      previous = part == 1 ? movement : infinity<R>();
      // If orders of magnitude oscillate, the steps must be shorter.
      damping_ = beside_wedges > R(0.5) && beside_wedges > previous_beside / 2 ? damping_ * 0.7
                                                                               : std::min(1.5 * damping_, R(1));
      previous_beside = beside_wedges;
    }
    return {std::move(state_), Status::stalled, 0, restless_};
  }

 private:
  R limit(std::size_t k) const { return state_.set.is_over_notch(k) ? problem_.shortest_gap() : limits_[k]; }

  /// Returns the change of the logarithm of a gap's length, for its linear step `growth`. A quantity that is like
  /// length^power is linear; the logarithm is not.
  static R logarithmic_step(const R& growth, const R& power) {
    const R part = std::max(power * growth, R(-0.9999));
    return std::clamp(power == 0 ? growth : log1p(part) / power, R(-30), R(6));
  }

  /// Computes the steps of both ends of a gap over a notch, from linear steps of its halves. The logarithm of its
  /// length follows logarithmic_step, because the traction beside the gap is like length^-beta. The ratio of its halves
  /// depends on the corner and changes little. Returns the larger of both changes.
  R follow_gap(std::size_t end, R& left_step, R& right_step) const {
    const R& left = state_.set.length(end);
    const R& right = state_.set.length(end + 1);
    const R length = left + right;
    const R& beta = problem_.jump(*state_.set.point(end + 1).anchor).power.value;
    const R growth = (right_step - left_step) / length;
    const R part = left / length;
    const R shift = -left_step / length - part * growth;
    const R rise = expm1(damping_ * logarithmic_step(growth, -beta));
    const R moved = std::clamp(damping_ * shift, R(-part / 2), R((1 - part) / 2)) * (1 + rise);
    left_step = -left * rise - moved * length;
    right_step = right * rise - moved * length;
    return std::max(abs(growth), R(abs(shift) / std::min(part, R(1 - part))));
  }

  /// True if the length of the gap beside the free end j counts, because a step of the profile is beyond that gap. If
  /// contact also ends just beyond a break, the shorter of both lengths counts.
  bool follows_gap_beside_step(std::size_t j) const {
    const auto& set = state_.set;
    const bool is_shorter = set.length(set.outside(j)) < set.length(set.inside(j));
    return set.is_beside_step(j) && (is_shorter || !set.is_beside_break(j));
  }

  /// Computes the step of the free end j beside a step of the profile. The logarithm of the gap's length l follows
  /// logarithmic_step: beyond the gap the traction is like r^beta, so the height over l is like l^(1+beta). Returns the
  /// linear relative change of l.
  R follow_gap_beside_step(std::size_t j, const R& outwards, R& end_step) const {
    const R& length = state_.set.length(state_.set.outside(j));
    const std::size_t step = outwards < 0 ? j - 1 : j + 1;
    const R& beta = problem_.jump(*state_.set.point(step).anchor).power.value;
    const R growth = -outwards * end_step / length;
    end_step = -outwards * length * expm1(logarithmic_step(growth, 1 + beta));
    return abs(growth);
  }

  /// Steps of ends just beyond a break, of gaps over notches and of gaps beside steps are steps of log l. Returns the
  /// largest of these steps, and of the relative changes that other ends cause in such lengths.
  R follow_lengths(std::vector<R>& ends) {
    R largest = 0;
    R others = 0;
    restless_.reset();
    for (std::size_t f = 0; f < free_.size(); ++f) {
      const std::size_t j = free_[f];
      const bool begins = state_.set.contact_side(j) == Side::right;
      if (!begins && state_.set.is_over_notch(j)) {
        largest = std::max(largest, follow_gap(j, ends[f], ends[f + 1]));
        for (const std::size_t i : {f, f + 1}) {
          if (!state_.set.is_beside_break(free_[i])) continue;
          others = std::max(others, R(abs(ends[i]) / state_.set.length(state_.set.inside(free_[i]))));
        }
        ++f;
        continue;
      }
      const R outwards = begins ? R(-1) : R(1);
      if (follows_gap_beside_step(j)) {
        others = std::max(others, follow_gap_beside_step(j, outwards, ends[f]));
        continue;
      }
      if (!state_.set.is_beside_break(j)) continue;
      const R& length = state_.set.length(state_.set.inside(j));
      const R growth = outwards * ends[f] / length;
      if (abs(growth) > largest) restless_ = j;
      largest = std::max(largest, abs(growth));
      ends[f] = outwards * length * expm1(std::clamp(growth, R(-7), R(3)));
    }
    return std::max(largest, others);
  }

  /// True if one end has moved most for many steps, and is now near its earlier position.
  bool goes_in_circles(const R& beside_wedges) {
    constexpr int many_steps = 24;
    if (!restless_ || beside_wedges < R(0.1)) {
      watched_.reset();
      return false;
    }
    const R& length = state_.set.length(state_.set.inside(*restless_));
    if (watched_ != restless_) {
      watched_ = restless_;
      watched_length_ = length;
      watched_steps_ = 0;
    }
    return ++watched_steps_ > many_steps && abs(log(length / watched_length_)) < 3;
  }

  /// Returns the largest part of the step that leaves every segment at least a tenth of its length, and the segment
  /// that limits it. A length beyond a break does not limit the step until it is below its limit.
  std::pair<R, std::size_t> admissible_part(const std::vector<R>& ends) const {
    std::vector<R> change(state_.set.segments(), R(0));
    for (std::size_t f = 0; f < free_.size(); ++f) {
      change[free_[f] - 1] += ends[f];
      change[free_[f]] -= ends[f];
    }
    std::vector<char> by_order(state_.set.segments(), 0);
    for (const std::size_t j : free_) {
      const bool is_gap = follows_gap_beside_step(j);
      const std::size_t k = is_gap ? state_.set.outside(j) : state_.set.inside(j);
      by_order[k] = (is_gap || state_.set.is_beside_break(j)) && state_.set.length(k) >= limits_[k];
    }
    for (std::size_t k = 0; k < change.size(); ++k) {
      if (state_.set.is_over_notch(k)) by_order[k] = state_.set.length(k) >= limit(k);
    }
    R part = 1;
    std::size_t tightest = 0;
    for (std::size_t k = 0; k < change.size(); ++k) {
      // Both ends together may shorten the segment by more than its length.
      if (!(change[k] < 0) || (by_order[k] && -change[k] < state_.set.length(k))) continue;
      const R allowed = -R(0.9) * state_.set.length(k) / change[k];
      if (allowed < part) {
        part = allowed;
        tightest = k;
      }
    }
    return {part, tightest};
  }

  R relative_change(const std::vector<R>& step, const std::vector<R>& q) const {
    R change = 0;
    R size = problem_.load();
    for (const R& c : step) change = std::max(change, abs(c));
    for (const R& c : q) size = std::max(size, abs(c));
    return change / size;
  }

  const RoundedProblem<R>& problem_;
  ContactState<R> state_;
  const std::vector<R>& limits_;
  JacobiRules<R>& rules_;
  std::vector<std::size_t> free_;
  std::optional<std::size_t> restless_;
  std::optional<std::size_t> watched_;  ///< the end that has moved most for several steps
  R watched_length_ = 0;                ///< its length when that began
  int watched_steps_ = 0;
  R damping_ = 1;  ///< factor of steps over notches
};

}  // namespace

template <Real R>
ContactState<R> ContactState<R>::initial(const RoundedProblem<R>& problem, ContactSet<R> set, const R& tilt) {
  if (set.components() > problem.most_coupled()) {
    std::vector<R> theta;
    R poles = 0;
    for (const std::size_t begin : set.all(ContactSet<R>::Kind::begins)) {
      std::size_t end = begin + 1;
      while (!set.point(end).is_end()) ++end;
      theta.push_back(set.point(begin).vanishes || set.point(end).vanishes ? 0 : 1);
      poles += theta.back();
    }
    for (R& t : theta) t *= problem.load() / std::max(poles, R(1));
    return {std::move(set), std::move(theta), tilt};
  }
  int degree = -static_cast<int>(set.components());
  for (const auto& point : set.points()) degree += point.is_free() ? 1 : 0;
  std::vector<R> q(static_cast<std::size_t>(std::max(-degree, 0)), R(0));
  if (!q.empty()) q.back() = problem.load();
  return {std::move(set), std::move(q), tilt};
}

template <Real R>
NewtonResult<R> solve_newton(const RoundedProblem<R>& problem, ContactState<R> state, const std::vector<R>& limits,
                             JacobiRules<R>& rules) {
  return Newton<R>(problem, std::move(state), limits, rules).run();
}

#define STEADYSLIDE_INSTANTIATE(R)                                                                        \
  template struct ContactState<R>;                                                                        \
  template NewtonResult<R> solve_newton(const RoundedProblem<R>&, ContactState<R>, const std::vector<R>&, \
                                        JacobiRules<R>&);
STEADYSLIDE_FOR_EACH_REAL(STEADYSLIDE_INSTANTIATE)
#undef STEADYSLIDE_INSTANTIATE

}  // namespace steadyslide::numeric
