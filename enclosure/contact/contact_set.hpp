#pragma once
// The contact set for all values of the free ends in a box: the points from the support's left end to its right end,
// anchors and free ends. A free end is an anchor plus or minus an offset h > 0, and the unknown is log h. So the
// distance between close ends, or between an end and an anchor, has full relative precision.
//
// Powers of the fundamental solution Y = prod (z - e_j)^{p_j} [Bal16, theorem 36]: at an end of contact the power of an
// edge or of a free end, inside the contact the power of the friction jump, otherwise 0.

#include <algorithm>
#include <vector>

#include "enclosure/number/ball.hpp"
#include "model/contact_topology.hpp"

namespace steadyslide::enclosure {

/// A point of the surface: in segment k of the contact set, with its distances from both points, which may be wide
/// balls. Outside the support it belongs to the outermost segment, with a negative distance from the support's end.
struct SurfacePoint {
  std::size_t segment;
  Ball from_left;
  Ball from_right;
};

class ContactSet {
 public:
  /// Takes `log_offsets` in the order of movable(). The topology must have no fault.
  ContactSet(const ReducedProblem& problem, ContactTopology topology, const std::vector<Ball>& log_offsets, Bits bits);

  const ReducedProblem& problem() const { return *problem_; }
  const ContactTopology& topology() const { return topology_; }
  Bits bits() const { return bits_; }
  std::size_t points() const { return topology_.points.size(); }
  const ContactTopology::Point& point(std::size_t j) const { return topology_.points[j]; }
  std::size_t segments() const { return points() - 1; }
  /// For segment k, between points k and k + 1.
  bool in_contact(std::size_t k) const { return contact_[k]; }
  std::ptrdiff_t segments_in_contact() const { return std::count(contact_.begin(), contact_.end(), 1); }
  const ReducedProblem::Interval& interval(std::size_t k) const { return problem_->intervals[intervals_[k]]; }
  /// Returns a ball with all loads of the problem.
  Ball loads() const { return Ball::plus_or_minus(Ball(problem_->load, bits_), Ball(problem_->load_radius, bits_)); }
  const Ball& length(std::size_t k) const { return lengths_[k]; }
  /// Returns xi of point j.
  const Ball& x(std::size_t j) const { return x_[j]; }
  /// Returns the derivative of end j with respect to the logarithm of its offset: -h or +h.
  Ball velocity(std::size_t j) const;
  /// Returns the distance from point i to point j > i.
  Ball distance(std::size_t i, std::size_t j) const;
  /// Returns the profile's step at point j, from left to right; 0 at a free end.
  Ball step(std::size_t j) const;
  /// Return the point on that side of a segment, and a place at a distance from it.
  static std::size_t point_of(std::size_t segment, Side side) { return side == Side::left ? segment : segment + 1; }
  SurfacePoint place(std::size_t segment, Side from, const Ball& distance) const;
  /// Returns point j as a place of a segment that it bounds.
  SurfacePoint place_of(std::size_t j, std::size_t segment) const {
    return place(segment, j == segment ? Side::left : Side::right, Ball(0, bits_));
  }
  /// True if the points are in this order for all values in the box.
  bool is_ordered() const;

  const Exponent& exponent(std::size_t j) const { return exponents_[j]; }
  const Ball& power(std::size_t j) const { return powers_[j]; }
  /// True if p is exactly 0: Y is analytic there.
  bool is_regular(std::size_t j) const { return regular_[j]; }
  int degree_at_infinity() const { return degree_; }
  /// Returns, on a segment in contact, eps = +-1 from Y+ = eps |Y|/((s+i) cos(pi alpha)); otherwise the sign of Y.
  int sign(std::size_t k) const { return signs_[k]; }
  /// Returns cos(pi alpha) = 1/sqrt(1 + s^2) on a segment.
  const Ball& cos_alpha(std::size_t k) const { return cosines_[k]; }

  /// The first and the last segment of a component, of a part of the support outside the contact, or of a gap between
  /// two components.
  struct Run {
    std::size_t first;
    std::size_t last;
  };
  std::vector<Run> components() const { return runs(true); }
  std::vector<Run> off_contact() const { return runs(false); }
  std::vector<Run> gaps() const;

 private:
  std::vector<Run> runs(bool contact) const;

  const ReducedProblem* problem_;
  ContactTopology topology_;
  Bits bits_;
  std::vector<Ball> offsets_;  ///< signed offset of every point from its anchor; 0 for the anchor
  std::vector<char> contact_;
  std::vector<std::size_t> intervals_;
  std::vector<Ball> x_;
  std::vector<Ball> lengths_;
  std::vector<Exponent> exponents_;
  std::vector<Ball> powers_;
  std::vector<char> regular_;
  std::vector<int> signs_;
  std::vector<Ball> cosines_;
  int degree_;
};

}  // namespace steadyslide::enclosure
