#include "enclosure/contact/punch_core.hpp"

#include <algorithm>

namespace steadyslide::enclosure {

std::optional<PunchCore> punch_core(const ContactProblem& problem, Bits bits) {
  const Indenter& punch = problem.indenter();
  const auto is_flat = [&](const Indenter::Piece& piece) {
    return piece.profile == punch.pieces().front().profile && piece.profile.degree() <= 0;
  };
  if (!problem.body().is_half_plane()) return std::nullopt;
  if (problem.elasticity().indenter() || !std::ranges::all_of(punch.pieces(), is_flat)) return std::nullopt;

  const Rational centre = (punch.left() + punch.right()) / 2;
  const Rational half_length = (punch.right() - punch.left()) / 2;
  // Computes 1 - M_0 as int (1/2 - alpha), because for large friction the difference would cancel; similarly -M_1 as
  // int y (1/2 - alpha).
  Ball below(0, bits), above(0, bits), below_moment(0, bits), above_moment(0, bits);
  for (const ContactProblem::Piece& piece : problem.pieces()) {
    const Exponent alpha = Exponent::angle(problem.coupled_friction(piece.friction));
    const Ball length((piece.right - piece.left) / half_length, bits);
    const Ball middle(((piece.left + piece.right) / 2 - centre) / half_length, bits);
    const Ball below_part = Ball(half - alpha, bits) * length;
    const Ball above_part = Ball(half + alpha, bits) * length;
    below += below_part;
    above += above_part;
    below_moment += below_part * middle;
    above_moment += above_part * middle;
  }
  const Ball two(2, bits);
  const auto in_users_x = [&](const Ball& y) { return Ball(centre, bits) + Ball(half_length, bits) * y; };
  return PunchCore{in_users_x(above_moment / above - above / two), in_users_x(below_moment / below + below / two)};
}

}  // namespace steadyslide::enclosure
