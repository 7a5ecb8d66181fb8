#include "enclosure/contact/reduced_problem.hpp"

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

}  // namespace steadyslide::enclosure
