#pragma once
// The indenter's shape psi(x) on its support, positive upwards, away from the body: -z = psi(x). It is piecewise
// polynomial. Where two pieces meet, the slope may jump (a wedge) and the value may jump (a step). [Bal16, section 2]

#include <memory>
#include <vector>

#include "model/direction.hpp"
#include "model/polynomial.hpp"

namespace steadyslide {

/// A term  cosine cos(2 pi n (x - origin)/L) + sine sin(2 pi n (x - origin)/L)  of a profile with the period L.
struct Harmonic {
  int n;
  Rational cosine;
  Rational sine;
  friend bool operator==(const Harmonic&, const Harmonic&) = default;
};

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
  /// Returns psi around x as one polynomial. Where two pieces meet, `side` selects one. Beyond the support it is the
  /// polynomial of the first or the last piece.
  const Polynomial& profile(const Rational& x, Side side) const;

  /// The jumps of value and slope at a place: right minus left.
  struct Break {
    Rational x;
    Rational step = 0;
    Rational wedge = 0;

    /// Returns the order of the lowest derivative of the profile that jumps, 1 for the slope; 0 if none does.
    int derivative() const { return wedge != 0 ? 1 : 0; }
    /// Returns the break in the coordinate (x - origin)/unit, for heights psi/(compliance unit).
    Break reduced(const Rational& origin, const Rational& unit, const Rational& compliance) const;
  };
  /// Returns the jumps at x; all are 0 at the ends of the support and where no pieces meet.
  Break break_at(const Rational& x) const;
  /// Returns the places where two pieces meet, from left to right.
  const std::vector<Break>& breaks() const { return *breaks_; }
  /// Returns the indenter with these terms added to psi. Pieces and profile() do not contain them. Throws InvalidData
  /// unless every n is positive.
  Indenter with_harmonics(std::vector<Harmonic> terms, const Rational& origin = 0) const;
  const std::vector<Harmonic>& harmonics() const { return harmonics_; }
  const Rational& origin_of_harmonics() const { return origin_of_harmonics_; }
  /// True if the profile has neither a wedge nor a step.
  bool is_smooth() const;

  /// Returns the indenter with the same heights in the coordinate y = scale x + shift, scale != 0. A negative scale
  /// mirrors it.
  Indenter moved(const Rational& scale, const Rational& shift) const;
  /// psi times `factor`.
  Indenter scaled(const Rational& factor) const;
  friend bool operator==(const Indenter& a, const Indenter& b) {
    return a.left_ == b.left_ && a.pieces_ == b.pieces_ && a.harmonics_ == b.harmonics_ &&
           a.origin_of_harmonics_ == b.origin_of_harmonics_;
  }

 private:
  Rational left_;
  std::vector<Piece> pieces_;
  std::shared_ptr<const std::vector<Break>> breaks_;  ///< copies of a long trace share them
  std::vector<Harmonic> harmonics_;
  Rational origin_of_harmonics_ = 0;
};

}  // namespace steadyslide
