#include "checker/certificate.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <regex>

#include "checker/reader.hpp"

namespace steadyslide::checker {
namespace {

using Kind = LayoutPoint::Contact;

template <class Is>
std::vector<std::size_t> those_of(const std::vector<LayoutPoint>& points, const Is& is) {
  std::vector<std::size_t> result;
  for (std::size_t j = 0; j < points.size(); ++j) {
    if (is(points[j])) result.push_back(j);
  }
  return result;
}

Ball read_ball(const Reader& at, int bits) {
  const Ball ball = Ball::parse(at.string(), bits);
  if (!ball.is_finite()) {
    at.fail("not a ball", "a finite one as arb_dump_str writes it, of at most " + std::to_string(bits) + " bits");
  }
  return ball;
}

LayoutPoint read_point(const Reader& at, int bits, std::vector<Ball>& log_offsets) {
  LayoutPoint point;
  if (at.has("side")) {
    at.check_keys({"anchor", "side", "log_offset", "contact", "free"});
    point.side = at["side"].choice({"left", "right"}) == 0 ? -1 : 1;
    log_offsets.push_back(read_ball(at["log_offset"], bits));
    if (!(Ball(1000000) - log_offsets.back().size()).is_positive()) {
      at["log_offset"].fail("offset out of range", "its logarithm is at most 1000000 in size");
    }
  } else {
    at.check_keys({"anchor", "contact"}, {"free"});
  }
  point.anchor = static_cast<std::size_t>(at["anchor"].integer(0, 1000000));
  constexpr std::array contacts{Kind::interior, Kind::outside, Kind::begins, Kind::ends};
  point.contact = contacts.at(at["contact"].choice({"interior", "outside", "begins", "ends"}));
  if (point.is_free() && !point.is_end()) at["contact"].fail("no end", "a point beside an anchor is an end of contact");
  if ((at.has("free") && at["free"].boolean()) != point.is_free()) {
    // A traction that vanishes at an anchor would give one more condition than unknowns.
    at.fail("free where it is not", "an end of contact is free if it lies beside an anchor, and an edge if it is one");
  }
  return point;
}

/// Reads the points: anchors in order, free ends in the interval beside their anchor, contact that begins and ends
/// alternately.
Layout read_layout(const Reader& at, const ReducedProblem& problem, int bits, std::vector<Ball>& log_offsets) {
  Layout layout;
  const std::vector<Reader> points = at["points"].list();
  for (const Reader& point : points) layout.points.push_back(read_point(point, bits, log_offsets));
  for (const Reader& segment : at["segments"].list()) layout.in_contact.push_back(segment.boolean());
  if (points.size() != layout.in_contact.size() + 1)
    at["segments"].fail("wrong number", "there is one fewer than points");
  std::size_t next = 0;  // anchor
  for (std::size_t j = 0; j < points.size(); ++j) {
    const auto& [anchor, side, contact] = layout.points[j];
    const bool in_order = side == 0
                              ? anchor == next++
                              : next > 0 && next < problem.anchors.size() && anchor == (side < 0 ? next : next - 1);
    if (!in_order) points[j].fail("points not in order", "every anchor stands once, a free end beside its own");
    if (j + 1 < points.size()) layout.intervals.push_back(next - 1);
    const bool left = j > 0 && layout.in_contact[j - 1];
    const bool right = j + 1 < points.size() && layout.in_contact[j];
    const Kind expected = left ? (right ? Kind::interior : Kind::ends) : (right ? Kind::begins : Kind::outside);
    if (contact != expected) points[j].fail("contact against segments", "they say where it begins and ends alike");
  }
  if (next != problem.anchors.size()) at["points"].fail("missing anchor", "every anchor of the problem stands once");
  if (layout.all(Kind::begins).empty()) at["segments"].fail("no contact", "the load needs some");
  return layout;
}

/// Reads a box. `at` has the keys points, segments, q, and tilt if the indenter may tilt.
Box read_box(const Reader& at, const ReducedProblem& problem, int bits, const Problem::Loads& loads) {
  Box box;
  box.loads = loads;
  box.layout = read_layout(at, problem, bits, box.V.log_offsets);
  for (const Reader& coefficient : at["q"].list()) box.V.q.push_back(read_ball(coefficient, bits));
  const int unknown = std::max(-box.layout.degree_at_infinity() - 1, 0);
  if (static_cast<int>(box.V.q.size()) != unknown) {
    at["q"].fail("wrong number of coefficients", "with these points it is " + std::to_string(unknown));
  }
  if (at.has("tilt")) box.V.tilt.push_back(read_ball(at["tilt"], bits));
  if (box.V.tilt.empty() == problem.load_at.has_value()) {
    throw Malformed(at.place() + ".tilt", "tilt against load_at", "an indenter tilts where load_at says so",
                    box.V.tilt.empty() ? "no tilt" : "a tilt");
  }
  return box;
}

/// Reads boxes for consecutive intervals of loads, from the problem's first load to its last one.
void read_boxes(const Reader& at, const ReducedProblem& problem, Certificate& c) {
  Rational reached = c.problem.loads.from;
  for (const Reader& box : at.list()) {
    box.check_keys({"loads", "points", "segments", "q"}, {"tilt"});
    const Problem::Loads loads = Problem::Loads::read(box["loads"]);
    if (loads.from != reached) box["loads"].fail("loads that do not join", "they begin at " + reached.text());
    reached = loads.to;
    c.boxes.push_back(read_box(box, problem, c.bits, loads));
  }
  if (c.boxes.empty() || reached != c.problem.loads.to)
    at.fail("loads left out", "boxes cover all of the problem's loads");
}

}  // namespace

std::vector<std::size_t> Layout::all(Kind kind) const {
  return those_of(points, [&](const LayoutPoint& point) { return point.contact == kind; });
}

std::vector<std::size_t> Layout::free_ends() const { return those_of(points, std::mem_fn(&LayoutPoint::is_free)); }

int Layout::degree_at_infinity() const {
  return static_cast<int>(free_ends().size()) - static_cast<int>(all(Kind::begins).size());
}

std::vector<Ball> Unknowns::list() const {
  std::vector<Ball> result = log_offsets;
  result.insert(result.end(), q.begin(), q.end());
  result.insert(result.end(), tilt.begin(), tilt.end());
  return result;
}

Unknowns Unknowns::with(const std::vector<Ball>& list) const {
  Unknowns result = *this;
  auto next = list.begin();
  for (std::vector<Ball>* part : {&result.log_offsets, &result.q, &result.tilt}) {
    for (Ball& x : *part) x = *next++;
  }
  return result;
}

void check_heading(const Reader& at) {
  at["certificate"].integer(1, 1);
  if (!std::regex_match(at["generator"].string(), std::regex("[a-z-]{1,40} [0-9]+\\.[0-9]+\\.[0-9]+"))) {
    at["generator"].fail("no program", "it is a program's name and its version, x.y.z");
  }
}

Certificate Certificate::read(const Reader& at) {
  const bool one_load = !at.has("kind") || at["kind"].choice({"solution", "loads"}) == 0;
  if (one_load) {
    at.check_keys({"certificate", "kind", "generator", "problem", "frame", "bits", "points", "segments", "q", "claims"},
                  {"tilt"});
  } else {
    at.check_keys({"certificate", "kind", "generator", "problem", "frame", "bits", "boxes", "claims"});
  }
  check_heading(at);
  Certificate c;
  c.problem = Problem::of_certificate(at["problem"], one_load);
  at["frame"].check_keys({"origin", "unit"});
  c.origin = at["frame"]["origin"].rational();
  c.unit = at["frame"]["unit"].rational();
  if (c.unit.sign() <= 0) at["frame"]["unit"].fail("out of range", "it is positive");
  c.bits = static_cast<int>(at["bits"].integer(64, 4096));
  const ReducedProblem problem(c.problem, c.origin, c.unit);
  if (one_load) {
    c.boxes.push_back(read_box(at, problem, c.bits, c.problem.loads));
  } else {
    read_boxes(at["boxes"], problem, c);
  }
  const Reader claims = at["claims"];
  // A certificate may also say if theorem 1 of [Bal16] applies.
  claims.check_keys({"exists"}, {"unique_by_theorem_1"});
  if (!claims["exists"].boolean())
    claims["exists"].fail("nothing claimed", "a certificate claims that a solution exists");
  if (claims.has("unique_by_theorem_1") && claims["unique_by_theorem_1"].boolean() != c.problem.theorem_1_applies()) {
    claims["unique_by_theorem_1"].fail(
        "wrong claim of uniqueness",
        "theorem 1 wants s nondecreasing towards +x, no step of the profile and no load_at, and then it holds");
  }
  return c;
}

}  // namespace steadyslide::checker
