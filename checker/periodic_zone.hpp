#pragma once
// The zone of periodic contact for given ends, its expansions at +i oo and its integrals (checker/periodic.hpp).

#include <optional>
#include <vector>

#include "checker/complex.hpp"
#include "checker/periodic.hpp"

namespace steadyslide::checker {

/// The function T: its coefficients in the order of Periodic::traction.
using Wave = std::vector<Ball>;

class PeriodicZone {
 public:
  /// `free_ends` in xi, from left to right. Throws Unproved if an end may lie at a friction jump or beyond the support.
  PeriodicZone(const Periodic& claim, const std::vector<Ball>& free_ends, slong precision);

  std::size_t arcs() const { return pieces_.size(); }
  /// Returns the friction piece on an arc.
  std::size_t piece(std::size_t arc) const { return pieces_[arc]; }
  const Ball& cosine(std::size_t arc) const { return cosines_[arc]; }
  /// Returns the point at the left end of an arc, or for arc = arcs() the right end of the contact.
  Ball point(std::size_t arc) const { return arc < points_.size() ? points_[arc] : points_[0] + Ball(1); }
  /// Returns the index of the point of a free end.
  std::size_t free_point(std::size_t end) const { return end == 0 ? 0 : arcs(); }

  /// Returns, for n = N, ..., 0, the coefficient of q^(-2n) in phase Y T, for T with each coefficient alone. With
  /// `moved`, its derivative with respect to that point.
  std::vector<std::vector<Complex>> expansion(std::optional<std::size_t> moved) const;

  /// The function under an integral over distances from a point: |Y| T, times xi or differentiated with respect to a point.
  struct Integrand {
    const Wave* wave;
    bool times_place = false;
    std::optional<std::size_t> moved{};
  };
  Ball over_arc(std::size_t arc, const Integrand& integrand, slong bits) const;
  /// Returns the integral from point `corner` to the distance `length` to the left (-1) or right (1).
  Ball integral(std::size_t corner, int direction, const Ball& length, const Integrand& integrand, slong bits) const;
  /// Returns |Y| T at distances d > 0 from a point.
  Ball value(std::size_t corner, int direction, const Ball& d, const Wave& wave) const;
  Complex wave(const Complex& xi, const Wave& wave) const;

 private:
  struct Sum;
  /// Returns the integrand without the power of d.
  Complex smooth(std::size_t corner, int direction, const Complex& d, const Integrand& integrand) const;

  const Periodic* claim_;
  slong precision_;
  std::vector<Ball> points_;
  std::vector<Ball> powers_;
  std::vector<std::size_t> pieces_;
  std::vector<Ball> cosines_;
};

}  // namespace steadyslide::checker
