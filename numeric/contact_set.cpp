#include "numeric/contact_set.hpp"

#include <cmath>

namespace steadyslide::numeric {

template <Real R>
ContactSet<R>::ContactSet(const ReducedProblem<R>& problem) : problem_(&problem) {
  const std::size_t count = problem.anchors().size();
  for (std::size_t k = 0; k < count; ++k) {
    points_.push_back({k, Kind::passed, false});
    if (k + 1 < count) lengths_.push_back(problem.spacing(k));
  }
  refresh();
}

template <Real R>
ContactSet<R>::ContactSet(const ReducedProblem<R>& problem, const std::vector<ZoneGuess>& zones) : ContactSet(problem) {
  const auto anchor_next_to = [&](double x) {
    std::size_t best = 0;
    for (std::size_t j = 0; j < points_.size(); ++j) {
      if (!points_[j].anchor) continue;
      using std::abs;
      if (!points_[best].anchor || abs(x_[j] - R(x)) < abs(x_[best] - R(x))) best = j;
    }
    return best;
  };
  const auto add = [&](double x, bool at_edge, Kind kind, double width) {
    if (at_edge) {
      points_[anchor_next_to(x)].kind = kind;
      return;
    }
    // A guess on an anchor is moved off it, into the contact: on which side the end lies is to be found out.
    std::size_t k = 0;
    const R place = R(x);
    while (k + 1 < segments() && place >= x_[k + 1]) ++k;
    R from_left = place - x_[k];
    if (kind == Kind::ends && from_left <= R(1e-9 * width) && k > 0 && !points_[k].is_end()) {
      --k;
      from_left = lengths_[k];
    }
    const R margin = std::min(R(0.02 * width), R(lengths_[k] / 8));
    from_left = std::clamp(from_left, margin, R(lengths_[k] - margin));
    insert(k, from_left, {std::nullopt, kind, true});
    refresh();
  };
  for (const ZoneGuess& zone : zones) {
    add(zone.left, zone.left_at_edge, Kind::begins, zone.right - zone.left);
    add(zone.right, zone.right_at_edge, Kind::ends, zone.right - zone.left);
  }
  refresh();
}

template <Real R>
void ContactSet<R>::refresh() {
  // Between two anchors the lengths add up to what is exact: the longest takes what rounding has left over.
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
  intervals_.assign(lengths_.size(), 0);
  x_.assign(points_.size(), R(0));
  bool contact = false;
  for (std::size_t j = 0; j < points_.size(); ++j) {
    if (points_[j].kind == Kind::begins) contact = true;
    if (points_[j].kind == Kind::ends) contact = false;
    if (points_[j].anchor) {
      x_[j] = problem_->anchors()[*points_[j].anchor].x;
    } else {
      x_[j] = x_[j - 1] + lengths_[j - 1];
    }
    if (j < lengths_.size()) {
      contact_[j] = contact;
      intervals_[j] = points_[j].anchor ? *points_[j].anchor : intervals_[j - 1];
    }
  }
  // From the nearer anchor.
  for (std::size_t j = points_.size(); j-- > 1;) {
    if (points_[j].anchor || j + 1 == points_.size()) continue;
    const R from_left = x_[j] - problem_->anchors()[intervals_[j]].x;
    const R next = problem_->anchors()[intervals_[j] + 1].x;
    if (from_left > problem_->spacing(intervals_[j]) / 2) {
      R distance = lengths_[j];
      for (std::size_t i = j + 1; !points_[i].anchor; ++i) distance += lengths_[i];
      x_[j] = next - distance;
    }
  }
}

template <Real R>
std::vector<Panel<R>> ContactSet<R>::panels() const {
  std::vector<Panel<R>> result;
  result.reserve(segments());
  for (std::size_t k = 0; k < segments(); ++k) result.push_back({x_[k], x_[k + 1], lengths_[k]});
  return result;
}

template <Real R>
std::size_t ContactSet<R>::components() const {
  return all(Kind::begins).size();
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
std::vector<std::size_t> ContactSet<R>::movable() const {
  std::vector<std::size_t> result;
  for (std::size_t j = 0; j < points_.size(); ++j) {
    if (points_[j].is_free() && !points_[j].anchor) result.push_back(j);
  }
  return result;
}

template <Real R>
R ContactSet<R>::hull() const {
  const std::vector<std::size_t> begins = all(Kind::begins);
  const std::vector<std::size_t> ends = all(Kind::ends);
  if (begins.empty()) return R(0);
  R sum = 0;
  for (std::size_t k = begins.front(); k < ends.back(); ++k) sum += lengths_[k];
  return sum;
}

template <Real R>
void ContactSet<R>::move(const std::vector<R>& steps) {
  const std::vector<std::size_t> free = movable();
  for (std::size_t i = 0; i < free.size(); ++i) {
    lengths_[free[i] - 1] += steps[i];
    lengths_[free[i]] -= steps[i];
  }
  refresh();
}

template <Real R>
std::size_t ContactSet<R>::insert(std::size_t segment, const R& from_left, Point point) {
  const R rest = lengths_[segment] - from_left;
  lengths_[segment] = from_left;
  lengths_.insert(lengths_.begin() + static_cast<std::ptrdiff_t>(segment) + 1, rest);
  points_.insert(points_.begin() + static_cast<std::ptrdiff_t>(segment) + 1, point);
  return segment + 1;
}

template <Real R>
void ContactSet<R>::erase(std::size_t j) {
  if (points_[j].anchor) {
    points_[j].kind = Kind::passed;
    points_[j].vanishes = false;
    return;
  }
  lengths_[j - 1] += lengths_[j];
  lengths_.erase(lengths_.begin() + static_cast<std::ptrdiff_t>(j));
  points_.erase(points_.begin() + static_cast<std::ptrdiff_t>(j));
}

template <Real R>
void ContactSet<R>::hop(std::size_t j, Side towards, const R& distance) {
  const Point end{std::nullopt, points_[j].kind, true};
  erase(j);
  if (towards == Side::left) {
    // The anchor was j - 1 and still is.
    const R d = std::min(distance, R(lengths_[j - 2] / 2));
    insert(j - 2, R(lengths_[j - 2] - d), end);
    lengths_[j - 1] = d;
  } else {
    const R d = std::min(distance, R(lengths_[j] / 2));
    insert(j, d, end);
  }
  refresh();
}

template <Real R>
void ContactSet<R>::settle(std::size_t j, Side towards, bool vanishes) {
  Point& anchor = points_[towards == Side::left ? j - 1 : j + 1];
  anchor.kind = points_[j].kind;
  anchor.vanishes = vanishes;
  erase(j);
  refresh();
}

template <Real R>
void ContactSet<R>::move_end(std::size_t j, std::size_t segment, const R& from_left) {
  const Point end{std::nullopt, points_[j].kind, true};
  R place = from_left;
  if (!points_[j].anchor && segment >= j) {
    // The end's two segments become one.
    if (segment == j) place += lengths_[j - 1];
    --segment;
  }
  erase(j);
  insert(segment, place, end);
  refresh();
}

template <Real R>
void ContactSet<R>::close(std::size_t j) {
  std::size_t other = j + 1;
  while (!points_[other].is_end()) ++other;
  erase(other);
  erase(j);
  refresh();
}

template <Real R>
void ContactSet<R>::open(std::size_t k, const R& from, const R& to) {
  open(k, from, k, to);
}

template <Real R>
void ContactSet<R>::open(std::size_t first, const R& from, std::size_t last, const R& to) {
  const bool gap = contact_[first];
  insert(last, to, {std::nullopt, gap ? Kind::begins : Kind::ends, true});
  insert(first, from, {std::nullopt, gap ? Kind::ends : Kind::begins, true});
  refresh();
}

template class ContactSet<double>;
template class ContactSet<Real50>;
template class ContactSet<Real100>;

}  // namespace steadyslide::numeric
