#pragma once
// The fundamental solution of the Riemann-Hilbert problem in periodic contact, on the circle of circumference L,
//
//   Y(z) = prod_j sin(pi (z - e_j)/L)^{p_j},   e_0 < e_1 < ... < e_n < e_0 + L,   sum of p_j an integer m.
//
// Arc k lies between e_k and the next point; the last one, between e_n and e_0 + L, is the gap between two contacts. With
// X = tan(pi x/L), sin(pi (x - e)/L) = (X - X_e) cos(pi x/L) cos(pi e/L): it is the half-plane's Y(X) cos(pi x/L)^m times
// a constant.

#include <vector>

#include "numeric/number/power.hpp"

namespace steadyslide::numeric {

template <Real R>
class PeriodicFundamentalSolution {
 public:
  /// Takes the lengths of the arcs, from e_0 on, as accurate as possible, and one power for each point.
  PeriodicFundamentalSolution(const R& first, std::vector<R> arcs, std::vector<Power<R>> powers);

  /// The number of points, and of arcs.
  std::size_t size() const { return arcs_.size(); }
  const R& arc(std::size_t k) const { return arcs_[k]; }
  const R& point(std::size_t j) const { return points_[j]; }
  const Power<R>& power(std::size_t j) const { return powers_[j % size()]; }
  const R& period() const { return period_; }
  /// pi/L
  const R& wave_number() const { return wave_number_; }

  /// Returns |Y| at a place of arc k, given by its distances from the ends of the arc, divided by the powers of these
  /// distances if `without_left`, `without_right`. Such a distance may be 0.
  R modulus(std::size_t k, const R& from_left, const R& from_right, bool without_left = false,
            bool without_right = false) const;
  /// Returns the amplitude of |x - e_j|^{p_j} at e_j.
  R amplitude(std::size_t j) const { return modulus(j, R(0), arcs_[j], true); }

 private:
  /// Returns sin(pi d/L)/d.
  R ratio(const R& distance) const;

  std::vector<R> arcs_;
  std::vector<R> points_;
  std::vector<Power<R>> powers_;
  R period_ = 0;
  R wave_number_;
};

}  // namespace steadyslide::numeric
