#include "model/reduced_problem.hpp"

#include <map>

#include "model/invalid_data.hpp"

namespace steadyslide {

ReducedProblem::ReducedProblem(const ContactProblem& problem, const Frame& frame)
    : frame(frame), load(problem.load() / frame.unit) {
  const auto reduced = [&](const Rational& x) -> Rational { return (x - frame.origin) / frame.unit; };
  const Rational c = problem.elasticity().compliance();

  // Pieces with the same polynomial share one slope.
  const auto is_before = [](const Polynomial& a, const Polynomial& b) { return a.coefficients() < b.coefficients(); };
  std::map<Polynomial, std::size_t, decltype(is_before)> known(is_before);
  std::vector<std::size_t> slope_of_profile;
  for (const Indenter::Piece& piece : problem.indenter().pieces()) {
    const Polynomial slope = piece.profile.derivative();
    const auto [found, is_new] = known.emplace(slope, slopes.size());
    slope_of_profile.push_back(found->second);
    if (is_new) slopes.push_back(slope.composed(frame.unit, frame.origin) * Polynomial::constant(1 / c));
  }

  for (const ContactProblem::Piece& piece : problem.pieces()) {
    anchors.push_back(problem.indenter().break_at(piece.left).reduced(frame.origin, frame.unit, c));
    intervals.push_back({slope_of_profile[piece.profile], piece.friction, problem.coupled_friction(piece.friction)});
  }
  anchors.push_back({reduced(problem.indenter().right())});
  if (problem.load_at()) load_at = reduced(*problem.load_at());
}

ReducedProblem ReducedProblem::for_loads(const Rational& from, const Rational& to) const {
  if (from <= 0 || to < from) {
    throw InvalidData("load", "these are no loads from the smaller to the larger", "0 < from <= to",
                      "from " + to_string(from) + " to " + to_string(to));
  }
  ReducedProblem result = *this;
  result.load = (from + to) / 2 / frame.unit;
  result.load_radius = (to - from) / 2 / frame.unit;
  return result;
}

}  // namespace steadyslide
