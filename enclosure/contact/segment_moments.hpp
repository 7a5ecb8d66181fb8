#pragma once
// The sum over all panels of a segment for a far place. With the nodes' places y_i and the distance D of the place,
// both from the segment's middle, and the segment's length l:
//
//   sum_i w_i p(y_i)/(D +- y_i) = sum_{k<K} (-+1)^k m_k/D^(k+1) + R,   m_k = sum_i w_i p(y_i) y_i^k,
//   |R| <= (sum_i |w_i p(y_i)|) r^K/(D (1 - r)),   r = l/(2 D).
//
// The moments of the weights are the same for all polynomials p. Only significant terms are summed, with their
// significant bits.

#include "enclosure/contact/contact_panel.hpp"
#include "enclosure/number/ball_polynomial.hpp"

namespace steadyslide::enclosure {

class SegmentMoments {
 public:
  /// Returns the moments of the panels' weights: sum_i w_i y_i^k for k below terms(bits) + degree + 1.
  static std::vector<Ball> of_weights(const ContactSet& set, std::size_t segment,
                                      const std::vector<ContactPanel>& panels, int degree);

  /// `polynomial` is in xi, with at most that degree. `sizes` are its bounds in each panel's far ellipse. Sums have the
  /// set's precision and are cut at about 2^-bits; at most set.bits().
  SegmentMoments(const ContactSet& set, std::size_t segment, const std::vector<ContactPanel>& panels,
                 const std::vector<Ball>& moments_of_weights, const BallPolynomial& polynomial,
                 const std::vector<Ball>& sizes, Bits bits);

  /// Returns the sum for a place at `distance` from the segment's point on the side `facing`, with the rules'
  /// remainders. Absent if the distance is too small or too wide for moments to pay off.
  std::optional<Ball> seen_from(const Ball& distance, Side facing) const;

 private:
  Bits bits_;
  Ball half_length_;
  std::size_t nodes_ = 0;  ///< number of nodes; sums that would cost more are not made
  std::vector<Ball> moments_;
  Ball size_;       ///< at least sum |w p|
  Ball remainder_;  ///< remainder of the rules for |1/(D +- y)| <= 1
  Ball reach_;      ///< largest reach of the panels' far ellipses beyond the segment
};

}  // namespace steadyslide::enclosure
