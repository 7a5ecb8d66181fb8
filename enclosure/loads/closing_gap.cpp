#include "enclosure/loads/closing_gap.hpp"

#include <algorithm>

namespace steadyslide::enclosure {

using Kind = ContactTopology::Kind;

std::optional<ContactBox> closed_gap(const ReducedProblem& problem, const ContactBox& box) {
  const std::vector<ContactTopology::Point>& points = box.topology.points;
  const std::vector<std::size_t> movable = box.topology.movable();
  if (problem.load_at || movable.size() != 2 || movable[1] != movable[0] + 2) return std::nullopt;
  const auto ends = std::count_if(points.begin(), points.end(), [](const auto& point) { return point.is_end(); });
  const auto is_edge = [](const auto& point) { return point.is_end() && !point.vanishes; };
  if (ends != 4 || !is_edge(points.front()) || !is_edge(points.back())) return std::nullopt;
  // Two of the four ends are ends of the support; the others are the ends of the gap.
  const std::size_t j = movable[0] + 1;
  const std::size_t c = points[j].anchor;
  if (points[j].is_end() || problem.anchors[c].step != 0) return std::nullopt;

  const Bits bits = box.log_offsets.front().bits();
  const ContactSet set(problem, box.topology, box.log_offsets, bits);
  for (const std::size_t flank : {j - 1, j}) {
    const Polynomial& slope = problem.slopes[problem.intervals[flank < j ? c - 1 : c].slope];
    const Ball bend = value_at(in_balls(slope.derivative(), bits), Ball::hull(set.x(flank), set.x(flank + 1)));
    if (!(bend >= Ball(0))) return std::nullopt;
  }
  ContactBox full{box.topology, {}, {}, box.tilt};
  full.topology.points.erase(full.topology.points.begin() + static_cast<std::ptrdiff_t>(j) + 1);
  full.topology.points.erase(full.topology.points.begin() + static_cast<std::ptrdiff_t>(j) - 1);
  return full;
}

std::optional<FullContactFrom> full_contact_from(const ReducedProblem& problem, const ContactBox& full,
                                                 const Rational& from, const Rational& to, const Rational& width,
                                                 JacobiRules& rules, WorkBudget& work) {
  const auto proof_at = [&](const Rational& load) {
    const ReducedProblem at_load = problem.for_loads(load, load);
    return prove_signs(at_load, prove_zero(at_load, full, rules, work), rules, work);
  };
  if (!proof_at(from).refuted) return std::nullopt;
  if (proof_at(to).refuted) return FullContactFrom{to, std::nullopt};
  FullContactFrom result{from, std::nullopt};
  // Bisection. It stops at undecided loads, which are as close to the closing load as the precision allows.
  constexpr int most_halves = 64;
  Rational open = to;
  for (int i = 0; i < most_halves; ++i) {
    if (result.proved && result.refuted != from && open - result.refuted <= width * open) break;
    const Rational middle = (result.refuted + open) / 2;
    const ContactProof proof = proof_at(middle);
    if (!proof.proved && !proof.refuted) break;
    if (proof.refuted) {
      result.refuted = middle;
    } else {
      result.proved = open = middle;
    }
  }
  return result;
}

}  // namespace steadyslide::enclosure
