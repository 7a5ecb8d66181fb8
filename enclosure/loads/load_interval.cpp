#include "enclosure/loads/load_interval.hpp"

#include <algorithm>

#include "enclosure/loads/contact_anchors.hpp"

namespace steadyslide::enclosure {
namespace {

/// Returns a box around two boxes, with each interval longer by an eighth.
ContactBox around(const ContactBox& a, const ContactBox& b) {
  std::vector<Ball> both = a.unknowns();
  std::ranges::transform(both, b.unknowns(), both.begin(), [](const Ball& x, const Ball& y) {
    const Ball hull = Ball::hull(x, y);
    return Ball::plus_or_minus(hull, hull.radius() / 8);
  });
  return a.with(both);
}

bool contains(const ContactBox& wide, const ContactBox& thin) {
  return std::ranges::equal(wide.unknowns(), thin.unknowns(),
                            [](const Ball& a, const Ball& b) { return a.contains(b); });
}

}  // namespace

LoadInterval prove_loads(const ReducedProblem& problem, const Rational& from, const Rational& to,
                         const ContactBox& guess, JacobiRules& rules, WorkBudget& work) {
  const ReducedProblem all = problem.for_loads(from, to);
  LoadInterval result{from, to, {}, {}, guess, {false, false, {}, {}, all, guess, rules.bits()}};
  const std::optional<ContactBox> first = box_for_loads(all, guess, rules, work);
  if (!first) {
    result.proof.reason = work.is_spent() ? "the budget of work is spent" : "Newton's method does not converge";
    return result;
  }
  result.box = *first;
  KrawczykResult zero = prove_zero(all, result.box, rules, work);
  // The excess of K(V) is of second order in the interval's length. If V has grown a few times, the interval is too
  // long.
  constexpr int most_boxes = 5;
  for (int i = 1; i < most_boxes && !zero.proved; ++i) {
    if (contains(result.box, zero.box)) break;  // K(V) does not make V larger
    result.box = around(result.box, zero.box);
    zero = prove_zero(all, result.box, rules, work);
  }
  result.at_from = zero.at_smallest;
  result.at_to = zero.at_largest;
  result.proof = prove_signs(all, std::move(zero), rules, work);
  return result;
}

LoadInterval prove_loads(const ContactProblem& problem, const ApproximateContact& contact, const Rational& from,
                         const Rational& to, Bits bits) {
  const ReducedProblem reduced = ReducedProblem(problem, frame_of(problem, contact)).for_loads(from, to);
  const ContactStart start(reduced, contact);
  if (std::string fault = start.topology.fault(reduced); !fault.empty()) {
    return {from, to, {}, {}, {}, {false, false, std::move(fault), {}, reduced, {}, bits}};
  }
  JacobiRules rules(bits);
  WorkBudget work;
  return prove_loads(reduced, from, to, start.box(bits), rules, work);
}

bool are_joined(const LoadInterval& left, const LoadInterval& right, JacobiRules& rules, WorkBudget& work) {
  const ReducedProblem& problem = left.proof.problem;
  const auto holds = [&](const LoadInterval& interval, const ContactBox& zero) {
    const std::optional<ContactBox> seen = with_anchors_of(problem, zero, interval.box.topology);
    return seen && contains(interval.box, *seen);
  };
  if (holds(right, left.at_to) || holds(left, right.at_from)) return true;
  if (!with_anchors_of(problem, left.at_to, right.box.topology)) return false;
  const KrawczykResult zero = enclose_zero(problem.for_loads(left.to, left.to), left.at_to, rules, work);
  return zero.proved && holds(left, zero.box) && holds(right, zero.box);
}

}  // namespace steadyslide::enclosure
