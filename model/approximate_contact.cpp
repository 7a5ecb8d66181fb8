#include "model/approximate_contact.hpp"

namespace steadyslide {

ApproximateContact::End ApproximateContact::free_end(const ContactProblem& problem, const Rational& x) {
  End nearest;
  bool any = false;
  const auto consider = [&](const Rational& anchor) {
    const Rational offset = abs(x - anchor);
    if (any && offset >= nearest.offset) return;
    any = true;
    nearest = {anchor, x < anchor ? Side::left : Side::right, offset, true};
  };
  consider(problem.indenter().left());
  for (const ContactProblem::Piece& piece : problem.pieces()) consider(piece.right);
  return nearest;
}

}  // namespace steadyslide
