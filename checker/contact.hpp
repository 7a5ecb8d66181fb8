#pragma once
// A contact set in numbers, for all positions of its free ends at once: distances, the fundamental function
//
//   Y(z) = prod_j (z - e_j)^(p_j),   p = -(1/2 +- alpha) at edges (+ at a left end), 1/2 -+ alpha at free ends,
//   alpha(c-) - alpha(c+) at jumps inside the contact, tan(pi alpha) = s on the side of the contact, 0 elsewhere,
//
// and its expansion at infinity. Inside the contact t = eps cos(pi alpha) |Y| B; off it Y is real. Both signs follow from
// sigma(x) = sum_{e_j > x} p_j: an integer n off the contact, Y = (-1)^n |Y|; alpha + m + 1/2 inside, eps = (-1)^(m+1).

#include <cstddef>
#include <vector>

#include "checker/certificate.hpp"

namespace steadyslide::checker {

/// A place between two points, by its distances from both; distances to all others are sums.
struct Place {
  std::size_t left;   ///< the point on the left
  std::size_t right;  ///< the point on the right
  Ball from_left;
  Ball from_right;
};

class Contact {
 public:
  /// `log_offsets`: of the free ends, left to right.
  Contact(const ReducedProblem& problem, const Layout& layout, const std::vector<Ball>& log_offsets, slong precision);

  const ReducedProblem& problem() const { return *problem_; }
  const Layout& layout() const { return *layout_; }
  slong precision() const { return precision_; }
  std::size_t points() const { return offset_.size(); }
  std::size_t segments() const { return points() - 1; }
  bool in_contact(std::size_t segment) const { return layout_->in_contact[segment]; }
  /// Which of the problem's slopes g holds on a segment.
  std::size_t slope_of(std::size_t segment) const { return problem_->slope_of[layout_->intervals[segment]]; }
  const Rational& s(std::size_t segment) const { return problem_->s[layout_->intervals[segment]]; }
  /// Is point j an anchor inside the contact where the polynomial changes?
  bool changes_slope(std::size_t j) const {
    return layout_->points[j].contact == Point::Contact::interior && slope_of(j - 1) != slope_of(j);
  }

  const Ball& xi(std::size_t j) const { return xi_[j]; }
  /// Signed, of a free end from its anchor.
  const Ball& offset(std::size_t j) const { return offset_[j]; }
  const Ball& power_at(std::size_t j) const { return power_[j]; }
  /// The points with a power other than 0, those of one power together.
  const std::vector<std::vector<std::size_t>>& alike() const { return alike_; }
  /// From point i to point j >= i.
  Ball distance(std::size_t i, std::size_t j) const;
  Ball length(std::size_t segment) const { return distance(segment, segment + 1); }
  Ball xi(const Place& at) const { return xi_[at.left] + at.from_left; }
  Ball distance(const Place& at, std::size_t j) const {
    return j <= at.left ? distance(j, at.left) + at.from_left : distance(at.right, j) + at.from_right;
  }
  Ball cosine(std::size_t segment) const { return cosine_[segment]; }
  /// eps in contact, the sign of Y off it.
  int sign(std::size_t segment) const { return sign_[segment]; }
  /// |Y| without the factor of point `but` (none if it is no point).
  Ball modulus(const Place& at, std::size_t but) const;

  int degree_at_infinity() const { return degree_; }
  /// Y = z^S (y_0 + y_1/z + ...): y_n, 0 for n < 0.
  Ball series(int n) const { return n < 0 ? Ball() : series_.at(static_cast<std::size_t>(n)); }
  /// The coefficient of z^k in g/Y, g a polynomial.
  Ball coefficient(const std::vector<Ball>& g, int k) const;

 private:
  void place_points(const std::vector<Ball>& log_offsets);
  void find_powers();
  /// True if the powers of two points are one number, by their definition.
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
