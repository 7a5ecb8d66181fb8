#pragma once
// Where there is contact: the support's line of points from its left to its right end (anchors of the reduced problem
// and free ends of contact), with the length between neighbours. Lengths are what is known: ends that come close to
// each other or to an anchor keep their distance to full relative precision.

#include <algorithm>
#include <optional>
#include <vector>

#include "numeric/riemann_hilbert/reduced_problem.hpp"
#include "numeric/solution/contact_interval.hpp"

namespace steadyslide::numeric {

template <Real R>
class ContactSet {
 public:
  enum class Kind { passed, begins, ends };  ///< contact begins or ends here, from left to right

  struct Point {
    std::optional<std::size_t> anchor;
    Kind kind = Kind::passed;
    bool vanishes = false;  ///< an end where the traction vanishes

    bool is_end() const { return kind != Kind::passed; }
    bool is_free() const { return is_end() && vanishes; }
  };

  /// No contact yet.
  explicit ContactSet(const ReducedProblem<R>& problem);
  /// Zones in xi; an end `at_edge` lies at the anchor next to it.
  ContactSet(const ReducedProblem<R>& problem, const std::vector<ContactInterval>& zones);
  /// The same set in another type of number; `problem` is the same one in it.
  template <Real Other>
  static ContactSet converted(const ReducedProblem<R>& problem, const ContactSet<Other>& other);

  const std::vector<Point>& points() const { return points_; }
  const Point& point(std::size_t j) const { return points_[j]; }
  /// The point where anchor k is.
  std::size_t point_of(std::size_t anchor) const;
  /// Of segment k, between points k and k + 1.
  const R& length(std::size_t k) const { return lengths_[k]; }
  std::size_t segments() const { return lengths_.size(); }
  bool in_contact(std::size_t k) const { return contact_[k]; }
  /// The anchor interval that contains segment k.
  std::size_t interval(std::size_t k) const { return intervals_[k]; }
  /// xi of the points.
  const R& x(std::size_t j) const { return x_[j]; }
  std::vector<Panel<R>> panels() const;

  std::size_t components() const;
  /// The points where contact begins, or ends, left to right.
  std::vector<std::size_t> all(Kind kind) const;
  /// Indices of the free ends that are not at an anchor.
  std::vector<std::size_t> movable() const;
  /// Does contact begin and end in turns, at least once, with lengths > 0 between all points?
  bool is_consistent() const;
  /// From the first end to the last one.
  R span_length() const;
  /// Is segment k half of a short gap over a notch, a wedge with D < 0, both ends free? Such a gap keeps a traction
  /// like d^beta, or like log d, from pulling in the corner: its length counts by its order of magnitude, which may be
  /// any.
  bool is_over_notch(std::size_t k) const;

  /// Moves the movable ends by steps[i] (in the order of movable()).
  void move(const std::vector<R>& steps);

  // Changes of the set's topology. Indices of points change.
  /// The free end j goes to the other side of its neighbour, an anchor that is no end, at most `distance` away from it.
  void cross_anchor(std::size_t j, Side towards, const R& distance);
  /// The free end j reaches its neighbour, an anchor, and stays there: an edge, or a free end if `vanishes`.
  void attach_to_anchor(std::size_t j, Side towards, bool vanishes);
  /// The end j, of whatever kind, becomes a free end at the distance given from the left end of a segment.
  void move_end(std::size_t j, std::size_t segment, const R& from_left);
  /// Removes the gap that begins at point j (an end of contact), or the component that begins there.
  void remove_interval(std::size_t j);
  /// A place in a segment, by its distances from both ends.
  struct SegmentPlace {
    std::size_t segment;
    R from_left;
    R from_right;
  };
  /// New free ends at two places: a gap between them if they are in contact, a component if not. Anchors between them
  /// are passed.
  void open(const SegmentPlace& from, const SegmentPlace& to);

 private:
  void refresh();
  void place_points();
  std::size_t insert(std::size_t segment, const R& from_left, Point point);
  std::size_t insert(std::size_t segment, const R& from_left, const R& from_right, const R& x, Point point);
  void erase(std::size_t j);

  const ReducedProblem<R>* problem_;
  std::vector<Point> points_;
  std::vector<R> lengths_;
  std::vector<char> contact_;
  std::vector<std::size_t> intervals_;
  std::vector<R> x_;

  template <Real>
  friend class ContactSet;
};

template <Real R>
template <Real Other>
ContactSet<R> ContactSet<R>::converted(const ReducedProblem<R>& problem, const ContactSet<Other>& other) {
  ContactSet result(problem);
  result.points_.clear();
  result.lengths_.clear();
  result.x_.clear();
  for (const auto& p : other.points_) {
    result.points_.push_back({p.anchor, static_cast<Kind>(static_cast<int>(p.kind)), p.vanishes});
  }
  for (const Other& length : other.lengths_) result.lengths_.push_back(static_cast<R>(length));
  for (const Other& x : other.x_) result.x_.push_back(static_cast<R>(x));
  result.refresh();
  return result;
}

}  // namespace steadyslide::numeric
