#pragma once
// The indenter's shape psi(x) on its support, upwards = away from the body: -z = psi(x). Piecewise polynomial; where
// two pieces meet the slope may jump (a wedge) and the value may jump (a step). [Bal16, section 2]

#include <vector>

#include "model/direction.hpp"
#include "model/polynomial.hpp"

namespace steadyslide {

class Indenter {
 public:
  /// The profile on ]previous `to`, `to`[; the first piece starts at the support's left end.
  struct Piece {
    Rational to;
    Polynomial profile;
    friend bool operator==(const Piece&, const Piece&) = default;
  };

  /// Throws InvalidData unless left < first `to` < second `to` < ...; the last `to` is the support's right end.
  Indenter(const Rational& left, std::vector<Piece> pieces);

  const Rational& left() const { return left_; }
  const Rational& right() const { return pieces_.back().to; }
  const std::vector<Piece>& pieces() const { return pieces_; }
  /// psi around x as one polynomial; where pieces meet, that on the side. Beyond the support, that of its last piece.
  const Polynomial& profile(const Rational& x, Side side) const;

  /// What happens where piece k meets piece k + 1: value and slope on the right minus those on the left.
  struct Break {
    Rational x;
    Rational step;
    Rational wedge;
  };
  std::vector<Break> breaks() const;
  /// Neither wedge nor step.
  bool is_smooth() const;

  /// The same heights in the coordinate y = scale x + shift, scale != 0: a negative scale mirrors.
  Indenter moved(const Rational& scale, const Rational& shift) const;
  /// psi times `factor`.
  Indenter scaled(const Rational& factor) const;
  friend bool operator==(const Indenter&, const Indenter&) = default;

 private:
  Rational left_;
  std::vector<Piece> pieces_;
};

}  // namespace steadyslide
