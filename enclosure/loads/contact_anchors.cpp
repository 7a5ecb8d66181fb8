#include "enclosure/loads/contact_anchors.hpp"

namespace steadyslide::enclosure {
namespace {

using Point = ContactTopology::Point;

/// Returns the anchor on the left of a free end.
std::size_t interval_of(const Point& end) { return end.anchor - (*end.beside == Side::left ? 1 : 0); }

/// Returns the length of the interval in which a free end lies.
Ball length_around(const ReducedProblem& problem, const Point& end, Bits bits) {
  const std::size_t k = interval_of(end);
  return Ball(Rational(problem.anchors[k + 1].x - problem.anchors[k].x), bits);
}

/// Expresses a free end by the other one of the two anchors around it.
void turn(const ReducedProblem& problem, Point& end, Ball& log_offset) {
  log_offset = log(length_around(problem, end, log_offset.bits()) - exp(log_offset));
  const bool from_left = *end.beside == Side::right;
  end.anchor = from_left ? end.anchor + 1 : end.anchor - 1;
  end.beside = from_left ? Side::left : Side::right;
}

bool same_end(const Point& a, const Point& b) {
  if (a.kind != b.kind || a.vanishes != b.vanishes || a.beside.has_value() != b.beside.has_value()) return false;
  return a.beside ? interval_of(a) == interval_of(b) : a.anchor == b.anchor;
}

}  // namespace

ContactBox with_nearest_anchors(const ReducedProblem& problem, const ContactBox& box) {
  ContactBox result = box;
  const std::vector<std::size_t> movable = box.topology.movable();
  for (std::size_t i = 0; i < movable.size(); ++i) {
    Point& end = result.topology.points[movable[i]];
    Ball& offset = result.log_offsets[i];
    if (exp(offset) * 2 > length_around(problem, end, offset.bits())) turn(problem, end, offset);
  }
  return result;
}

std::optional<ContactBox> with_anchors_of(const ReducedProblem& problem, const ContactBox& box,
                                          const ContactTopology& other) {
  if (box.topology.points.size() != other.points.size()) return std::nullopt;
  ContactBox result = box;
  std::size_t i = 0;
  for (std::size_t j = 0; j < other.points.size(); ++j) {
    Point& end = result.topology.points[j];
    if (!same_end(end, other.points[j])) return std::nullopt;
    if (!end.beside) continue;
    Ball& offset = result.log_offsets[i++];
    if (end.beside != other.points[j].beside) turn(problem, end, offset);
  }
  return result;
}

}  // namespace steadyslide::enclosure
