#include "numeric/riemann_hilbert/contact_set.hpp"

#include <algorithm>
#include <cmath>

namespace steadyslide::numeric {

template <Real R>
ContactSet<R>::ContactSet(const RoundedProblem<R>& problem) : problem_(&problem) {
  const std::size_t count = problem.anchors().size();
  for (std::size_t k = 0; k < count; ++k) {
    points_.push_back({k, Kind::interior, false});
    x_.push_back(problem.anchors()[k].x);
    if (k + 1 < count) lengths_.push_back(problem.spacing(k));
  }
  refresh();
}

template <Real R>
ContactSet<R>::ContactSet(const RoundedProblem<R>& problem, const std::vector<ContactInterval>& zones)
    : ContactSet(problem) {
  // Ends must be in order: if rounding has put a guess before the last end, it comes after it.
  std::size_t last = 0;
  const auto edge_next_to = [&](double x, Kind kind, double width) {
    const End end = kind == Kind::begins ? End::left : End::right;
    std::optional<std::size_t> best;
    R least = infinity<R>();
    for (std::size_t j = last; j < points_.size(); ++j) {
      if (!points_[j].anchor || points_[j].is_end()) continue;
      // If rounding cannot tell two anchors apart, the edge is at the one where it is possible.
      const bool possible = problem.edge_possible(end, *points_[j].anchor);
      const R distance = abs(x_[j] - R(x)) + (possible ? R(0) : R(1e-9 * width));
      if (distance < least) {
        least = distance;
        best = j;
      }
    }
    return best;
  };
  const auto add = [&](double x, bool at_edge, Kind kind, double width) {
    const std::optional<std::size_t> edge = at_edge ? edge_next_to(x, kind, width) : std::nullopt;
    if (edge) {
      points_[*edge].kind = kind;
      last = *edge;
      return;
    }
    // A guess at an anchor is moved off it, into the contact. The search decides on which side the end lies.
    std::size_t k = std::min(last, segments() - 1);
    const R place = R(x);
    while (k + 1 < segments() && place >= x_[k + 1]) ++k;
    R from_left = place - x_[k];
    if (kind == Kind::ends && from_left <= R(1e-9 * width) && k > last && !points_[k].is_end()) {
      --k;
      from_left = lengths_[k];
    }
    const R margin = std::min(R(0.02 * width), lengths_[k] / 8);
    const bool moved = from_left < margin || from_left > lengths_[k] - margin;
    from_left = std::clamp(from_left, margin, lengths_[k] - margin);
    if (moved) {
      insert(k, from_left, {std::nullopt, kind, true});
    } else {
      insert(k, from_left, x_[k + 1] - place, place, {std::nullopt, kind, true});
    }
    last = k + 1;
    refresh();
  };
  for (const ContactInterval& zone : zones) {
    add(zone.left, zone.left_at_edge, Kind::begins, zone.right - zone.left);
    add(zone.right, zone.right_at_edge, Kind::ends, zone.right - zone.left);
  }
  refresh();
}

template <Real R>
void ContactSet<R>::refresh() {
  // Between two anchors the sum of the lengths must be the exact distance. The longest length takes the rounding error.
  std::size_t first = 0;
  for (std::size_t j = 1; j < points_.size(); ++j) {
    if (!points_[j].anchor) continue;
    std::size_t longest = first;
    for (std::size_t k = first; k < j; ++k) {
      if (lengths_[k] > lengths_[longest]) longest = k;
    }
    R rest = problem_->spacing(*points_[first].anchor);
    for (std::size_t k = first; k < j; ++k) {
      if (k != longest) rest -= lengths_[k];
    }
    lengths_[longest] = rest;
    first = j;
  }

  contact_.assign(lengths_.size(), 0);
  contact_segments_.clear();
  intervals_.assign(lengths_.size(), 0);
  bool contact = false;
  for (std::size_t j = 0; j < lengths_.size(); ++j) {
    if (points_[j].kind == Kind::begins) contact = true;
    if (points_[j].kind == Kind::ends) contact = false;
    contact_[j] = contact;
    if (contact) contact_segments_.push_back(j);
    intervals_[j] = points_[j].anchor ? *points_[j].anchor : intervals_[j - 1];
  }
  ends_.clear();
  movable_.clear();
  for (std::size_t j = 0; j < points_.size(); ++j) {
    if (points_[j].is_end()) ends_.push_back(j);
    if (points_[j].is_movable()) movable_.push_back(j);
  }
  place_points();
  const std::vector<std::size_t> begins = all(Kind::begins);
  const std::vector<std::size_t> ends = all(Kind::ends);
  span_length_ = 0;
  for (std::size_t k = begins.empty() ? lengths_.size() : begins.front(); !ends.empty() && k < ends.back(); ++k)
    span_length_ += lengths_[k];
  blocks_.clear();
  if (lengths_.size() < 4 * block) return;
  for (std::size_t k = 0; k < lengths_.size(); ++k) {
    if (k % block == 0) blocks_.push_back(R(0));
    blocks_.back() += lengths_[k];
  }
}

template <Real R>
void ContactSet<R>::place_points() {
  // A place is computed from the nearer anchor and the lengths in between. If both anchors are far away, the place is
  // kept, and the places of the points beside it follow from it.
  // A contact that fits its frame has a length of about 1. A longer length reaches to something far away, and a place
  // computed from there would lose digits in the long sum.
  const R longest_local = 4;
  const std::size_t count = points_.size();
  std::vector<R> from_left(count, infinity<R>());
  std::vector<R> from_right(count, infinity<R>());
  for (std::size_t j = 0; j < count; ++j) {
    if (points_[j].anchor) {
      x_[j] = anchor_at(j)->x;
      from_left[j] = from_right[j] = 0;
    } else if (lengths_[j - 1] <= longest_local) {
      from_left[j] = from_left[j - 1] + lengths_[j - 1];
    }
  }
  for (std::size_t j = count - 1; j-- > 0;) {
    if (!points_[j].anchor && lengths_[j] <= longest_local) from_right[j] = from_right[j + 1] + lengths_[j];
  }
  const auto is_known = [&](std::size_t j) { return std::min(from_left[j], from_right[j]) < infinity<R>(); };
  for (std::size_t j = 1; j < count; ++j) {
    if (points_[j].anchor) continue;
    if (is_known(j) ? from_left[j] <= from_right[j] : lengths_[j - 1] <= longest_local)
      x_[j] = x_[j - 1] + lengths_[j - 1];
  }
  for (std::size_t j = count - 1; j-- > 0;) {
    if (!points_[j].anchor && from_right[j] < from_left[j]) x_[j] = x_[j + 1] - lengths_[j];
  }
  // A long length follows from its places.
  for (std::size_t k = 0; k < lengths_.size(); ++k) {
    if (lengths_[k] > longest_local && !(points_[k].anchor && points_[k + 1].anchor)) lengths_[k] = x_[k + 1] - x_[k];
  }
}

template <Real R>
std::vector<Panel<R>> ContactSet<R>::panels() const {
  std::vector<Panel<R>> result;
  result.reserve(segments());
  for (std::size_t k = 0; k < segments(); ++k) result.push_back(panel(k));
  return result;
}

template <Real R>
std::size_t ContactSet<R>::point_of(std::size_t anchor) const {
  std::size_t j = 0;
  while (points_[j].anchor != anchor) ++j;
  return j;
}

template <Real R>
std::vector<std::pair<std::size_t, std::size_t>> ContactSet<R>::runs() const {
  std::vector<std::pair<std::size_t, std::size_t>> result;
  for (std::size_t k = 0; k < segments(); ++k) {
    if (k == 0 || contact_[k] != contact_[k - 1]) result.emplace_back(k, k);
    result.back().second = k + 1;
  }
  return result;
}

template <Real R>
std::vector<std::size_t> ContactSet<R>::all(Kind kind) const {
  std::vector<std::size_t> result;
  for (std::size_t j = 0; j < points_.size(); ++j) {
    if (points_[j].kind == kind) result.push_back(j);
  }
  return result;
}

template <Real R>
R ContactSet<R>::sum_of_lengths(std::size_t first, std::size_t end, R start) const {
  while (first < end) {
    const bool whole = first % block == 0 && first + block <= end && blocks_.size() > 1;
    start += whole ? blocks_[first / block] : lengths_[first];
    first += whole ? block : 1;
  }
  return start;
}

template <Real R>
bool ContactSet<R>::is_consistent() const {
  bool contact = false;
  for (const Point& point : points_) {
    if (!point.is_end()) continue;
    if ((point.kind == Kind::ends) != contact) return false;
    contact = !contact;
  }
  const bool positive = std::all_of(lengths_.begin(), lengths_.end(), [](const R& length) { return length > 0; });
  return !contact && positive && components() > 0;
}

template <Real R>
bool ContactSet<R>::is_over_notch(std::size_t k) const {
  if (contact_[k]) return false;
  const std::size_t middle = points_[k].is_end() ? k + 1 : k;
  if (middle == 0 || middle == segments() || contact_[middle - 1] || contact_[middle]) return false;
  return points_[middle].anchor && anchor_at(middle)->exact.wedge < 0 && !is_at_step(middle) &&
         points_[middle - 1].is_movable() && points_[middle + 1].is_movable() &&
         lengths_[middle - 1] + lengths_[middle] < R(0.05) * span_length();
}

template <Real R>
bool ContactSet<R>::is_beside_break(std::size_t j) const {
  const auto* anchor = anchor_at(neighbour(j));
  return anchor && anchor->is_break && length(inside(j)) < R(0.05) * span_length();
}

template <Real R>
bool ContactSet<R>::is_beside_step(std::size_t j) const {
  const std::size_t far = contact_side(j) == Side::right ? j - 1 : j + 1;
  return is_at_step(far) && points_[far].is_end() && length(outside(j)) < R(0.05) * span_length();
}

template <Real R>
R ContactSet<R>::displacement(std::size_t j, const EndErrors<R>& errors) const {
  // Over a notch both ends move together: the error is that of the logarithm of the gap.
  const R part = counts_by_order(j) ? std::min(errors.part, errors.length) : errors.part;
  return std::min(errors.distance, R(part * std::min(length(j - 1), length(j))));
}

template <Real R>
void ContactSet<R>::move(const std::vector<R>& steps) {
  const std::vector<std::size_t> free = movable();
  for (std::size_t i = 0; i < free.size(); ++i) {
    lengths_[free[i] - 1] += steps[i];
    lengths_[free[i]] -= steps[i];
    x_[free[i]] += steps[i];
  }
  refresh();
}

template <Real R>
void ContactSet<R>::insert(std::size_t segment, const R& from_left, Point point) {
  // The new length of a segment much longer than the contact must be computed from the places.
  const bool by_places = lengths_[segment] > 4;
  const R x = from_left <= lengths_[segment] / 2 || by_places ? x_[segment] + from_left
                                                              : x_[segment + 1] - (lengths_[segment] - from_left);
  insert(segment, from_left, by_places ? x_[segment + 1] - x : lengths_[segment] - from_left, x, point);
}

template <Real R>
void ContactSet<R>::insert(std::size_t segment, const R& from_left, const R& from_right, const R& x, Point point) {
  const auto after = static_cast<std::ptrdiff_t>(segment) + 1;
  lengths_[segment] = from_left;
  lengths_.insert(lengths_.begin() + after, from_right);
  points_.insert(points_.begin() + after, point);
  x_.insert(x_.begin() + after, x);
}

template <Real R>
void ContactSet<R>::erase(std::size_t j) {
  if (points_[j].anchor) {
    points_[j].kind = Kind::interior;
    points_[j].vanishes = false;
    return;
  }
  const auto at = static_cast<std::ptrdiff_t>(j);
  lengths_[j - 1] += lengths_[j];
  lengths_.erase(lengths_.begin() + at);
  points_.erase(points_.begin() + at);
  x_.erase(x_.begin() + at);
}

template <Real R>
void ContactSet<R>::cross_anchor(std::size_t j, Side towards, const R& distance) {
  const Point end{std::nullopt, points_[j].kind, true};
  erase(j);
  if (towards == Side::left) {
    // The index of the anchor stays j - 1.
    const R d = std::min(distance, lengths_[j - 2] / 2);
    insert(j - 2, lengths_[j - 2] - d, d, x_[j - 1] - d, end);
  } else {
    insert(j, std::min(distance, lengths_[j] / 2), end);
  }
  refresh();
}

template <Real R>
void ContactSet<R>::attach_to_anchor(std::size_t j, Side towards, bool vanishes) {
  Point& anchor = points_[towards == Side::left ? j - 1 : j + 1];
  anchor.kind = points_[j].kind;
  anchor.vanishes = vanishes;
  erase(j);
  refresh();
}

template <Real R>
void ContactSet<R>::move_end(std::size_t j, std::size_t segment, const R& from_left) {
  const Point end{std::nullopt, points_[j].kind, true};
  if (!points_[j].anchor && (segment == j || segment + 1 == j)) {
    // Beside a long segment, a short one must not be computed as a difference.
    const R step = segment == j ? from_left : from_left - lengths_[j - 1];
    lengths_[j - 1] = segment == j ? lengths_[j - 1] + step : from_left;
    lengths_[j] -= step;
    x_[j] += step;
    points_[j] = end;
    refresh();
    return;
  }
  if (!points_[j].anchor && segment > j) --segment;  // the end's two segments become one
  erase(j);
  insert(segment, from_left, end);
  refresh();
}

template <Real R>
void ContactSet<R>::remove_interval(std::size_t j) {
  std::size_t other = j + 1;
  while (!points_[other].is_end()) ++other;
  erase(other);
  erase(j);
  refresh();
}

template <Real R>
void ContactSet<R>::open(const SegmentPlace& from, const SegmentPlace& to) {
  const bool gap = contact_[from.segment];
  const Point first{std::nullopt, gap ? Kind::ends : Kind::begins, true};
  const Point last{std::nullopt, gap ? Kind::begins : Kind::ends, true};
  const auto place = [this](const SegmentPlace& p) {
    return p.from_left < p.from_right ? x_[p.segment] + p.from_left : x_[p.segment + 1] - p.from_right;
  };
  const R x_first = place(from);
  const R x_last = place(to);
  if (from.segment == to.segment) {
    const R between = from.from_left < to.from_right ? to.from_left - from.from_left : from.from_right - to.from_right;
    insert(from.segment, from.from_left, from.from_right, x_first, first);
    insert(from.segment + 1, between, to.from_right, x_last, last);
  } else {
    insert(to.segment, to.from_left, to.from_right, x_last, last);
    insert(from.segment, from.from_left, from.from_right, x_first, first);
  }
  refresh();
}

STEADYSLIDE_INSTANTIATE_CLASS(ContactSet)

}  // namespace steadyslide::numeric
