#include "enclosure/contact/reduced_problem.hpp"

#include "model/invalid_data.hpp"

namespace steadyslide::enclosure {

ReducedProblem::ReducedProblem(const ContactProblem& problem, const Frame& frame)
    : frame(frame), load(problem.load() / frame.unit) {
  const auto reduced = [&](const Rational& x) -> Rational { return (x - frame.origin) / frame.unit; };
  const Rational height = problem.elasticity().compliance() * frame.unit;
  const std::vector<Indenter::Piece>& profile = problem.indenter().pieces();
  const std::vector<ContactProblem::Piece> pieces = problem.pieces();
  anchors.push_back({reduced(pieces.front().left), 0});
  for (const ContactProblem::Piece& piece : pieces) {
    intervals.push_back({profile[piece.profile].profile.composed(frame.unit, frame.origin).derivative() *
                             Polynomial::constant(1 / height),
                         problem.coupled_friction(piece.friction)});
    anchors.push_back({reduced(piece.right), 0});
  }
  for (const Indenter::Break& at : problem.indenter().breaks()) {
    for (Anchor& anchor : anchors) {
      if (anchor.x == reduced(at.x)) anchor.step = at.step / height;
    }
  }
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

}  // namespace steadyslide::enclosure
