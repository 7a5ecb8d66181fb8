#pragma once
// The panels of a segment seen from afar, all at once. With y_i the nodes' places and D the distance of a place, both from the
// segment's middle, l the segment's length:
//
//   sum_i w_i p(y_i)/(D +- y_i) = sum_{k<K} (-+1)^k m_k/D^(k+1) + R,   m_k = sum_i w_i p(y_i) y_i^k,
//   |R| <= (sum_i |w_i p(y_i)|) r^K/(D (1 - r)),   r = l/(2 D).
//
// The moments of the weights alone serve all polynomials p. As many terms are summed as show, each with the bits that show.

#include "enclosure/contact/contact_panel.hpp"
#include "enclosure/number/ball_polynomial.hpp"

namespace steadyslide::enclosure {

class SegmentMoments {
 public:
  /// Moments of the panels' weights: sum_i w_i y_i^k for k below terms(bits) + degree + 1.
  static std::vector<Ball> of_weights(const ContactSet& set, std::size_t segment,
                                      const std::vector<ContactPanel>& panels, int degree);

  /// `polynomial` of xi, of that degree at most. `sizes`: what bounds it in each panel's far ellipse.
  SegmentMoments(const ContactSet& set, std::size_t segment, const std::vector<ContactPanel>& panels,
                 const std::vector<Ball>& moments_of_weights, const BallPolynomial& polynomial,
                 const std::vector<Ball>& sizes);

  /// The sum for a place at the distance `distance` from the segment's point on the side `facing`, with the rules' remainders;
  /// nothing where that is too near or too wide for it to be worth the while.
  std::optional<Ball> seen_from(const Ball& distance, Side facing) const;

 private:
  Bits bits_;
  Ball half_length_;
  std::size_t nodes_;  ///< terms that cost more are not summed
  std::vector<Ball> moments_;
  Ball size_;       ///< sum |w p|, at least
  Ball remainder_;  ///< of the rules, |1/(D +- y)| <= 1
  Ball reach_;      ///< of the panels' far ellipses beyond the segment, at most
};

}  // namespace steadyslide::enclosure
