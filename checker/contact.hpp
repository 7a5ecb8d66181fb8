#pragma once
// The numbers of a contact set, for all positions of its free ends in a box: distances, the fundamental function
//
//   Y(z) = prod_j (z - e_j)^(p_j),   p = -(1/2 +- alpha) at edges (+ at a left end), 1/2 -+ alpha at free ends,
//   alpha(c-) - alpha(c+) at jumps inside the contact, tan(pi alpha) = s on the side of the contact, 0 elsewhere,
//
// and its expansion at infinity. Inside the contact t = eps cos(pi alpha) |Y| B; outside Y is real. Both signs follow
// from sigma(x) = sum_{e_j > x} p_j: outside the contact it is an integer n, Y = (-1)^n |Y|; inside it is
// alpha + m + 1/2, eps = (-1)^(m+1).

#include <cstddef>
#include <vector>

#include "checker/certificate.hpp"

namespace steadyslide::checker {

/// A place between two points, given by its distances from both. Distances to all other points are sums.
struct SurfacePoint {
  std::size_t left;   ///< the point on the left
  std::size_t right;  ///< the point on the right
  Ball from_left;
  Ball from_right;
};

class Contact {
 public:
  /// `log_offsets` belong to the free ends, from left to right.
  Contact(const ReducedProblem& problem, const Layout& layout, const std::vector<Ball>& log_offsets, slong precision);

  const ReducedProblem& problem() const { return *problem_; }
  const Layout& layout() const { return *layout_; }
  slong precision() const { return precision_; }
  std::size_t points() const { return offset_.size(); }
  std::size_t segments() const { return points() - 1; }
  bool in_contact(std::size_t segment) const { return layout_->in_contact[segment]; }
  /// Returns the index of the problem's slope g on a segment.
  std::size_t slope_of(std::size_t segment) const { return problem_->slope_of[layout_->intervals[segment]]; }
  const Rational& s(std::size_t segment) const { return problem_->s[layout_->intervals[segment]]; }
  /// True if point j is an anchor inside the contact at which the polynomial changes.
  bool changes_slope(std::size_t j) const {
    return layout_->points[j].contact == LayoutPoint::Contact::interior && slope_of(j - 1) != slope_of(j);
  }

  const Ball& xi(std::size_t j) const { return xi_[j]; }
  /// Returns the signed offset of a free end from its anchor.
  const Ball& offset(std::size_t j) const { return offset_[j]; }
  const Ball& power_at(std::size_t j) const { return power_[j]; }
  /// Returns the points with a power other than 0, grouped by power.
  const std::vector<std::vector<std::size_t>>& alike() const { return alike_; }
  /// Returns the distance from point i to point j >= i.
  Ball distance(std::size_t i, std::size_t j) const;
  Ball length(std::size_t segment) const { return distance(segment, segment + 1); }
  Ball xi(const SurfacePoint& at) const { return xi_[at.left] + at.from_left; }
  Ball distance(const SurfacePoint& at, std::size_t j) const {
    return j <= at.left ? distance(j, at.left) + at.from_left : distance(at.right, j) + at.from_right;
  }
  Ball cosine(std::size_t segment) const { return cosine_[segment]; }
  /// Returns eps in contact, and the sign of Y outside.
  int sign(std::size_t segment) const { return sign_[segment]; }
  /// Returns |Y| without the factor of point `but` (with all factors if `but` is not a point).
  Ball modulus(const SurfacePoint& at, std::size_t but) const;

  int degree_at_infinity() const { return degree_; }
  /// Returns y_n in Y = z^S (y_0 + y_1/z + ...); 0 for n < 0.
  Ball series(int n) const { return n < 0 ? Ball() : series_.at(static_cast<std::size_t>(n)); }
  /// Returns the coefficient of z^k in g/Y for a polynomial g.
  Ball coefficient(const std::vector<Ball>& g, int k) const;

 private:
  void place_points(const std::vector<Ball>& log_offsets);
  void find_powers();
  /// True if the powers of two points are equal by definition.
  bool same_power(std::size_t i, std::size_t j) const;
  void expand();

  const ReducedProblem* problem_;
  const Layout* layout_;
  slong precision_;
  std::vector<Ball> offset_;
  std::vector<Ball> xi_;
  std::vector<Ball> power_;
  std::vector<std::vector<std::size_t>> alike_;
  std::vector<Ball> cosine_;
  std::vector<int> sign_;
  int degree_;
  std::vector<Ball> series_;
  std::vector<Ball> inverse_series_;  ///< 1/Y = z^-S (1 + ...)
};

}  // namespace steadyslide::checker
