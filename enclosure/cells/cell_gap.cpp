#include "enclosure/cells/cell_gap.hpp"

#include <algorithm>

namespace steadyslide::enclosure {
namespace {

/// Returns z rounded down, or up, to a multiple of 2^-20.
double rounded(const Rational& z, bool up) {
  const Rational scaled = z * (1 << 20);
  Integer whole = numerator(scaled) / denominator(scaled);  // z >= 0
  if (up && whole != scaled) ++whole;
  return static_cast<double>(static_cast<long>(whole)) / (1 << 20);
}

}  // namespace

CellGap::CellGap(const ContactProblem& problem, const CellPressures& pressures, Bits bits)
    : pressures_(pressures), bits_(bits), potential_(pressures, bits) {
  const Ball total(Rational(pressures.total()), bits);
  per_pi_ = Ball(1, bits) / (Ball::pi(bits) * total);
  const Rational left = problem.indenter().left();
  const Rational unit = problem.indenter().right() - left;
  const Rational cells(pressures.size());
  const Polynomial per_height = Polynomial::constant(1 / (problem.elasticity().compliance() * problem.load()));
  Rational constant = 0;
  for (const ContactProblem::Piece& piece : problem.pieces()) {
    const Rational from = (piece.left - left) / unit * cells;
    const Rational to = (piece.right - left) / unit * cells;
    const Rational s = problem.coupled_friction(piece.friction);
    if (piece.friction > 0 && piece.left == problem.friction().jumps()[piece.friction - 1]) {
      constant -= (s - problem.coupled_friction(piece.friction - 1)) * pressures.load_before(from);
    }
    const Polynomial& profile = problem.indenter().pieces()[piece.profile].profile;
    pieces_.push_back({from, to, in_balls(per_height * profile.composed(unit, (piece.left + piece.right) / 2), bits),
                       (from + to) / 2, Ball(s, bits) / total, Ball(constant, bits) / total});
  }
}

std::vector<CellGap::Piece>::const_iterator CellGap::first_piece(std::size_t i) const {
  const Rational y(i);
  return std::partition_point(pieces_.begin(), pieces_.end() - 1, [&](const Piece& piece) { return piece.right <= y; });
}

BallPolynomial CellGap::given(const Piece& piece, std::size_t i) const {
  const Rational cells(size());
  BallPolynomial result = shifted(piece.profile, Ball((Rational(i) - piece.middle) / cells, bits_));
  const Ball h(1 / cells, bits_);
  Ball power(1, bits_);
  for (Ball& coefficient : result) {
    coefficient *= power;
    power *= h;
  }
  result.resize(std::max<std::size_t>(result.size(), 4), Ball(0, bits_));
  result[0] += piece.constant + piece.friction * Ball(Rational(pressures_.before(i)), bits_);
  result[1] += piece.friction * Ball(Rational(pressures_.weights()[i]), bits_);
  return result;
}

std::vector<GapPart> CellGap::parts(std::size_t i) const {
  const Ball& bend = potential_.bend[i];
  const Ball& skew = potential_.skew[i];
  // (1-z) V(i) + z V(i+1) - z(1-z) (A + B (z - 1/2)).
  const Ball potential[4] = {
      potential_.nodes[i],
      potential_.nodes[i + 1] - potential_.nodes[i] - bend + skew / Ball(2),
      bend - Ball(3) * skew / Ball(2),
      skew,
  };
  std::vector<GapPart> result;
  for (auto piece = first_piece(i); piece != pieces_.end() && piece->left < Rational(i + 1); ++piece) {
    GapPart part{given(*piece, i), {}, {}, potential_.rest[i] * per_pi_ / Ball(4)};
    for (std::size_t k = 0; k < near; ++k) {
      if (k <= i) part.a[k] = Ball(Rational(potential_.rises[i - k]), bits_) * per_pi_;
      if (i + 1 + k <= size()) part.b[k] = Ball(Rational(potential_.rises[i + 1 + k]), bits_) * per_pi_;
    }
    for (std::size_t k = 0; k < 4; ++k) part.q[k] -= potential[k] * per_pi_;
    part.from = rounded(std::clamp<Rational>(piece->left - Rational(i), 0, 1), false);
    part.to = rounded(std::clamp<Rational>(piece->right - Rational(i), 0, 1), true);
    result.push_back(std::move(part));
  }
  return result;
}

Ball CellGap::mean(std::size_t i) const {
  Ball sum = -potential_.means[i] * per_pi_;
  for (auto piece = first_piece(i); piece != pieces_.end() && piece->left < Rational(i + 1); ++piece) {
    const Rational from = std::clamp<Rational>(piece->left - Rational(i), 0, 1);
    const Rational to = std::clamp<Rational>(piece->right - Rational(i), 0, 1);
    sum += integral_over(given(*piece, i), Ball(from, bits_), Ball(Rational(to - from), bits_));
  }
  return sum;
}

}  // namespace steadyslide::enclosure
