#pragma once
// The contact set: the points of the support from its left to its right end (anchors of the reduced problem and free
// ends of contact), with the length between neighbours. The lengths are the primary data. So the distance between close
// ends, or between an end and an anchor, has full relative precision.

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

#include "model/contact_topology.hpp"
#include "numeric/riemann_hilbert/rounded_problem.hpp"
#include "numeric/solution/contact_interval.hpp"

namespace steadyslide::numeric {

/// The errors of free ends.
template <Real R>
struct EndErrors {
  R distance;  ///< absolute error in xi,
  R part = 1;  ///< but at most this fraction of the length beside the end
  R length;    ///< relative error of a length that counts by its order of magnitude
};

/// The errors of a solution on its contact set (contact_newton.hpp).
template <Real R>
struct StateErrors {
  EndErrors<R> ends;
  R tilt = 0;                      ///< in units of c
  std::vector<R> polynomial = {};  ///< of the coefficients of r; with pivots, of dtheta_i/pi for each pole; empty: 0
};

template <Real R>
class ContactSet {
 public:
  using Kind = ContactTopology::Kind;

  struct Point {
    std::optional<std::size_t> anchor;
    Kind kind = Kind::interior;
    bool vanishes = false;  ///< an end where the traction vanishes

    bool is_end() const { return kind != Kind::interior; }
    bool is_free() const { return is_end() && vanishes; }
    /// True for a free end that is not at an anchor.
    bool is_movable() const { return is_free() && !anchor; }
  };

  /// A set without contact.
  explicit ContactSet(const RoundedProblem<R>& problem);
  /// Takes zones in xi. An end with `left_at_edge` or `right_at_edge` lies at the nearest anchor. If rounding cannot
  /// tell anchors apart, it lies at one where an edge is possible.
  ContactSet(const RoundedProblem<R>& problem, const std::vector<ContactInterval>& zones);
  /// Takes the same set in another number type. `problem` is the same problem in the new type.
  template <Real Other>
  static ContactSet converted(const RoundedProblem<R>& problem, const ContactSet<Other>& other);

  const std::vector<Point>& points() const { return points_; }
  const Point& point(std::size_t j) const { return points_[j]; }
  /// Returns the index of the point at anchor k.
  std::size_t point_of(std::size_t anchor) const;
  /// For the end j: the side on which contact lies, the segment in contact, and the point at the other end of this
  /// segment.
  Side contact_side(std::size_t j) const { return points_[j].kind == Kind::begins ? Side::right : Side::left; }
  std::size_t inside(std::size_t j) const { return contact_side(j) == Side::right ? j : j - 1; }
  std::size_t neighbour(std::size_t j) const { return contact_side(j) == Side::right ? j + 1 : j - 1; }
  /// Returns the data of the anchor at point j; null if there is none.
  const typename RoundedProblem<R>::Anchor* anchor_at(std::size_t j) const {
    return points_[j].anchor ? &problem_->anchors()[*points_[j].anchor] : nullptr;
  }
  bool is_at_step(std::size_t j) const { return points_[j].anchor && anchor_at(j)->step_sign != 0; }
  /// Returns the length of segment k, between points k and k + 1.
  const R& length(std::size_t k) const { return lengths_[k]; }
  std::size_t segments() const { return lengths_.size(); }
  bool in_contact(std::size_t k) const { return contact_[k]; }
  /// The anchor interval that contains segment k.
  std::size_t interval(std::size_t k) const { return intervals_[k]; }
  /// Returns xi of point j.
  const R& x(std::size_t j) const { return x_[j]; }
  Panel<R> panel(std::size_t k) const { return {x_[k], x_[k + 1], lengths_[k]}; }
  std::vector<Panel<R>> panels() const;

  /// Returns the runs of neighbouring segments that are all in contact or all without contact: first segment and the
  /// one after the last.
  std::vector<std::pair<std::size_t, std::size_t>> runs() const;
  std::size_t components() const { return all(Kind::begins).size(); }
  /// Returns the segments in contact, from left to right.
  const std::vector<std::size_t>& contact_segments() const { return contact_segments_; }
  /// Returns the points where contact begins, or ends, from left to right.
  std::vector<std::size_t> all(Kind kind) const;
  /// Returns both, from left to right.
  const std::vector<std::size_t>& ends() const { return ends_; }
  /// Returns the movable ends.
  const std::vector<std::size_t>& movable() const { return movable_; }
  /// Returns `start` plus the lengths of the segments first..end-1; many segments are summed in blocks.
  R sum_of_lengths(std::size_t first, std::size_t end, R start) const;
  /// True if contact begins and ends alternately, at least once, and all lengths between points are > 0.
  bool is_consistent() const;
  /// Returns the distance from the first to the last end of contact.
  const R& span_length() const { return span_length_; }
  /// True if segment k is half of a short gap over a notch (a wedge with D < 0) with two free ends. Such a gap prevents
  /// tension in the corner, where the traction would be like d^beta or log d. Its length counts by its order of
  /// magnitude.
  bool is_over_notch(std::size_t k) const;
  /// True if contact at the free end j reaches just beyond a break of the profile. The length l of that piece counts by
  /// its order of magnitude, because it carries a load like l^(1 - p), and p may be near 1.
  bool is_beside_break(std::size_t j) const;
  /// Returns the segment of the gap beside the free end j.
  std::size_t outside(std::size_t j) const { return contact_side(j) == Side::right ? j - 1 : j; }
  /// True if a short gap separates the free end j from contact at a step. The height of that gap at its far end is that
  /// of the step. Its length counts by its order of magnitude, for any height of the step.
  bool is_beside_step(std::size_t j) const;
  /// True if the shorter length beside the free end j counts by its order of magnitude.
  bool counts_by_order(std::size_t j) const {
    return is_over_notch(outside(j)) || is_beside_break(j) || is_beside_step(j);
  }
  /// Returns the error of the position of the free end j.
  R displacement(std::size_t j, const EndErrors<R>& errors) const;

  /// Moves the movable ends by steps[i] (in the order of movable()).
  void move(const std::vector<R>& steps);

  // Changes of the set's topology. Indices of points change.
  /// Moves the free end j to the other side of its neighbour, an anchor that is not an end, at most `distance` away
  /// from it.
  void cross_anchor(std::size_t j, Side towards, const R& distance);
  /// Moves the free end j to its neighbour, an anchor. It becomes an edge, or a free end if `vanishes`.
  void attach_to_anchor(std::size_t j, Side towards, bool vanishes);
  /// Makes the end j (of any kind) a free end at the given distance from the left end of a segment.
  void move_end(std::size_t j, std::size_t segment, const R& from_left);
  /// Removes the gap that begins at point j (an end of contact), or the component that begins there.
  void remove_interval(std::size_t j);
  /// A place in a segment, given by its distances from both ends.
  struct SegmentPlace {
    std::size_t segment;
    R from_left;
    R from_right;
  };
  /// Adds free ends at two places: a gap between them if they are in contact, otherwise a component.
  void open(const SegmentPlace& from, const SegmentPlace& to);

 private:
  void refresh();
  void place_points();
  void insert(std::size_t segment, const R& from_left, Point point);
  void insert(std::size_t segment, const R& from_left, const R& from_right, const R& x, Point point);
  void erase(std::size_t j);

  const RoundedProblem<R>* problem_;
  std::vector<Point> points_;
  std::vector<R> lengths_;
  std::vector<char> contact_;
  std::vector<std::size_t> contact_segments_;
  std::vector<std::size_t> intervals_;
  std::vector<std::size_t> ends_;
  std::vector<std::size_t> movable_;
  std::vector<R> x_;
  R span_length_ = 0;
  std::vector<R> blocks_;  ///< lengths of `block` segments each
  static constexpr std::size_t block = 64;

  template <Real>
  friend class ContactSet;
};

template <Real R>
template <Real Other>
ContactSet<R> ContactSet<R>::converted(const RoundedProblem<R>& problem, const ContactSet<Other>& other) {
  ContactSet result(problem);
  result.points_.clear();
  result.lengths_.clear();
  result.x_.clear();
  for (const auto& p : other.points_) {
    result.points_.push_back({p.anchor, p.kind, p.vanishes});
  }
  for (const Other& length : other.lengths_) result.lengths_.push_back(static_cast<R>(length));
  for (const Other& x : other.x_) result.x_.push_back(static_cast<R>(x));
  result.refresh();
  return result;
}

/// A point of the surface: in a segment of the contact set, or at the distance `from_right` to the left of the support
/// (segment -1), or at the distance `from_left` to the right of it (segment = number of segments).
template <Real R>
struct SurfacePoint {
  std::ptrdiff_t segment;
  Node<R> node;
};

/// True if the point lies on the support.
template <Real R>
bool in_support(const ContactSet<R>& set, const SurfacePoint<R>& at) {
  return at.segment >= 0 && at.segment < static_cast<std::ptrdiff_t>(set.segments());
}

template <Real R>
bool in_contact(const ContactSet<R>& set, const SurfacePoint<R>& at) {
  return in_support(set, at) && set.in_contact(static_cast<std::size_t>(at.segment));
}

/// Returns a point in a segment, with its place computed from the nearer end.
template <Real R>
SurfacePoint<R> surface_point(const ContactSet<R>& set, std::size_t segment, const R& from_left, const R& from_right) {
  const R x = from_left < from_right ? set.x(segment) + from_left : set.x(segment + 1) - from_right;
  return {static_cast<std::ptrdiff_t>(segment), {x, from_left, from_right}};
}

/// Returns the point at the distance d from point j of the set, on that side. Beyond the support the other distance is
/// infinite.
template <Real R>
SurfacePoint<R> beside(const ContactSet<R>& set, std::size_t j, Side side, const R& d) {
  const bool left = side == Side::left;
  const std::ptrdiff_t segment = static_cast<std::ptrdiff_t>(j) - (left ? 1 : 0);
  const bool in_support = segment >= 0 && segment < static_cast<std::ptrdiff_t>(set.segments());
  const R rest = in_support ? set.length(static_cast<std::size_t>(segment)) - d : infinity<R>();
  return {segment, left ? Node<R>{set.x(j) - d, rest, d} : Node<R>{set.x(j) + d, d, rest}};
}

}  // namespace steadyslide::numeric
