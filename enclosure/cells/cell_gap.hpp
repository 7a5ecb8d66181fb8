#pragma once
// The gap under pressures p_h on equal cells, in units of c P, up to a constant, at every place y of the support (in
// units of cells, cell_pressures.hpp):
//
//   H = psi - u(p_h) = psi/(c P) - V/(pi S) + F/S,   F(y) = int_0^y s n dy'.
//
// For t = -p_h, c A t = u' gives u/c = (1/pi) int p_h log|x - x'| dx' - int_left^x s p_h, up to a constant. A cell has
// p_h dx' = P n_j dy'/S, and log h is part of the constant. With T(y) = int_0^y n, linear in every cell, F = F_k + s_k
// T where s = s_k, and F_k - F_{k-1} = -(s_k - s_{k-1}) T(c_k) at a friction jump. This is exact for any position of
// the jump in a cell.

#include "enclosure/cells/cell_potential.hpp"
#include "enclosure/cells/gap_part.hpp"

namespace steadyslide::enclosure {

class CellGap {
 public:
  /// Both arguments must outlive this object.
  CellGap(const ContactProblem& problem, const CellPressures& pressures, Bits bits);

  Bits bits() const { return bits_; }
  std::size_t size() const { return pressures_.size(); }
  /// Returns the parts of cell i between its ends and the places of the data inside it, from left to right.
  std::vector<GapPart> parts(std::size_t i) const;
  /// Returns the mean of H over cell i.
  Ball mean(std::size_t i) const;

 private:
  /// A piece of the support with one polynomial and one friction value.
  struct Piece {
    Rational left;  ///< y
    Rational right;
    BallPolynomial profile;  ///< psi/(c P), a polynomial in (y - middle)/N
    Rational middle;
    Ball friction;  ///< s/S
    Ball constant;  ///< F_k/S
  };
  /// Returns psi/(c P) + F/S in cell i, as a polynomial in z.
  BallPolynomial given(const Piece& piece, std::size_t i) const;
  /// Returns the first piece that ends beyond y = i.
  std::vector<Piece>::const_iterator first_piece(std::size_t i) const;

  const CellPressures& pressures_;
  Bits bits_;
  CellPotential potential_;
  Ball per_pi_;  ///< 1/(pi S)
  std::vector<Piece> pieces_;
};

}  // namespace steadyslide::enclosure
