#include "model/contact_topology.hpp"

namespace steadyslide {

std::vector<std::size_t> ContactTopology::movable() const {
  std::vector<std::size_t> result;
  for (std::size_t j = 0; j < points.size(); ++j) {
    if (points[j].beside) result.push_back(j);
  }
  return result;
}

int ContactTopology::degree_at_infinity() const {
  int degree = 0;
  for (const Point& point : points) degree += (point.vanishes ? 1 : 0) - (point.kind == Kind::begins ? 1 : 0);
  return degree;
}

std::string ContactTopology::fault(const ReducedProblem& problem) const {
  std::size_t next = 0;  // the next anchor that must occur
  bool contact = false;
  bool any = false;
  for (std::size_t j = 0; j < points.size(); ++j) {
    const Point& point = points[j];
    if (point.anchor >= problem.anchors.size()) return "a point names an anchor that the problem does not have";
    if (point.beside) {
      const bool right = *point.beside == Side::right;
      if (point.anchor + (right ? 1 : 0) != next || next == 0 || next == problem.anchors.size()) {
        return "a free end is not beside its anchor";
      }
      if (!point.vanishes || !point.is_end()) return "a point that moves is no free end";
    } else if (point.anchor != next++) {
      return "the anchors are not met one after the other";
    }
    if (point.kind == Kind::interior && point.vanishes) return "a point that is no end vanishes";
    if (point.kind == Kind::interior) {
      if (contact && problem.anchors[point.anchor].step != 0) return "contact over a step of the profile";
      continue;
    }
    if (contact == (point.kind == Kind::begins)) return "contact does not begin and end in turns";
    contact = !contact;
    any = true;
    if (!point.beside && !point.vanishes && point.anchor != 0 && point.anchor + 1 != problem.anchors.size()) {
      // At a step, contact is on the side that protrudes, which is the lower one.
      const int step = sign(problem.anchors[point.anchor].step);
      if (step == 0) return "an edge is neither at the support's end nor at a step";
      if ((step > 0) != (point.kind == Kind::ends)) return "contact at a step lies on the receding side";
    }
  }
  if (next != problem.anchors.size()) return "an anchor is missing";
  if (!any || contact) return "contact does not begin and end in turns";
  return {};
}

}  // namespace steadyslide
