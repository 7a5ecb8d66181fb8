#include "enclosure/loads/contact_anchors.hpp"

namespace steadyslide::enclosure {
namespace {

using Point = ContactTopology::Point;

/// The anchor on the left of a free end.
std::size_t interval_of(const Point& end) { return end.anchor - (*end.beside == Side::left ? 1 : 0); }

Point turned(const Point& end) {
  Point result = end;
  const bool from_left = *end.beside == Side::right;
  result.anchor = from_left ? end.anchor + 1 : end.anchor - 1;
  result.beside = from_left ? Side::left : Side::right;
  return result;
}

Ball length_of(const ReducedProblem& problem, std::size_t interval, Bits bits) {
  return Ball(Rational(problem.anchors[interval + 1].x - problem.anchors[interval].x), bits);
}

/// log of what is left of the interval beyond an offset.
Ball turned_offset(const Ball& log_offset, const Ball& length) { return log(length - exp(log_offset)); }

bool same_end(const Point& a, const Point& b) {
  if (a.kind != b.kind || a.vanishes != b.vanishes || a.beside.has_value() != b.beside.has_value()) return false;
  return a.beside ? interval_of(a) == interval_of(b) : a.anchor == b.anchor;
}

}  // namespace

ContactBox seen_from_nearer(const ReducedProblem& problem, const ContactBox& box) {
  ContactBox result = box;
  const std::vector<std::size_t> movable = box.topology.movable();
  for (std::size_t i = 0; i < movable.size(); ++i) {
    Point& end = result.topology.points[movable[i]];
    Ball& offset = result.log_offsets[i];
    const Ball length = length_of(problem, interval_of(end), offset.bits());
    if (!(exp(offset) * Ball(2) > length)) continue;
    offset = turned_offset(offset, length);
    end = turned(end);
  }
  return result;
}

std::optional<ContactBox> seen_from(const ReducedProblem& problem, const ContactBox& box,
                                    const ContactTopology& other) {
  if (box.topology.points.size() != other.points.size()) return std::nullopt;
  ContactBox result = box;
  std::size_t i = 0;
  for (std::size_t j = 0; j < other.points.size(); ++j) {
    Point& end = result.topology.points[j];
    if (!same_end(end, other.points[j])) return std::nullopt;
    if (!end.beside) continue;
    Ball& offset = result.log_offsets[i++];
    if (end.beside == other.points[j].beside) continue;
    offset = turned_offset(offset, length_of(problem, interval_of(end), offset.bits()));
    end = turned(end);
  }
  return result;
}

}  // namespace steadyslide::enclosure
