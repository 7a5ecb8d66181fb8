// Proofs of contact for whole intervals of loads, with the events between them. They are compared with the
// Riemann-Hilbert solver at single loads, and with loads known in closed form.

#include "enclosure/loads/load_path.hpp"

#include "enclosure/found_contact.hpp"
#include "enclosure/loads/closing_gap.hpp"
#include "enclosure/loads/contact_anchors.hpp"
#include "support/numeric_test.hpp"
#include "support/problems.hpp"
#include "support/random_contact.hpp"

namespace steadyslide::enclosure {

namespace {

std::vector<LoadStretch> path(const ContactProblem& problem, const Rational& from, const Rational& to,
                              const Rational& width = Rational(1, 1000000), bool intervals_alone = false) {
  LoadPathOptions options;
  options.width = width;
  options.intervals_alone = intervals_alone;
  return follow_loads(
      problem, from, to, [&](const Rational& load) { return found_contact<double>(problem.with_load(load)); }, options);
}

using Words = std::vector<std::string>;

/// Checks that stretches have no holes and no overlaps, and that events lie only between proved stretches. Returns the
/// texts of unproved stretches, in order.
Words words_of(const std::vector<LoadStretch>& stretches, const Rational& from, const Rational& to) {
  Words result;
  REQUIRE_FALSE(stretches.empty());
  CHECK(stretches.front().from == from);
  CHECK(stretches.back().to == to);
  for (std::size_t i = 0; i < stretches.size(); ++i) {
    const LoadStretch& s = stretches[i];
    if (i > 0) CHECK(s.from == stretches[i - 1].to);
    CHECK((s.kind == LoadStretch::Kind::proved || s.kind == LoadStretch::Kind::closing) == s.interval.has_value());
    if (s.interval) {
      CHECK(s.interval->proof.proved);
      CHECK(s.from < s.to);
      CHECK(s.interval->from == s.from);
      CHECK(s.interval->to == (s.kind == LoadStretch::Kind::closing ? s.from : s.to));
    } else {
      result.push_back(s.words);
    }
    if (s.kind == LoadStretch::Kind::event) {
      REQUIRE((i > 0 && i + 1 < stretches.size()));
      CHECK(stretches[i - 1].interval);
      CHECK(stretches[i + 1].interval);
    }
  }
  return result;
}

std::vector<LoadStretch> events(std::vector<LoadStretch> stretches) {
  std::erase_if(stretches, [](const LoadStretch& s) { return s.kind != LoadStretch::Kind::event; });
  return stretches;
}

/// True if the solver's contact at this load is in the box of the interval.
bool holds_solution(const LoadInterval& interval, const ApproximateContact& contact) {
  const ReducedProblem& problem = interval.proof.problem;
  const ContactStart start(problem, contact);
  const std::optional<ContactBox> seen =
      with_anchors_of(problem, start.box(interval.proof.bits), interval.box.topology);
  if (!seen) return false;
  for (std::size_t i = 0; i < seen->log_offsets.size(); ++i) {
    if (!interval.proof.box.log_offsets[i].contains(seen->log_offsets[i])) return false;
  }
  return true;
}

/// A parabola of radius 1/5 over s = 1/10 for x < c, and 6/10 for x > c.
ContactProblem parabola(const Rational& c, const Rational& load) {
  return reduced({0.1_r, 0.6_r}, {c}, one_piece(-2, 2, {0, 0, 2.5_r}), load);
}

/// The load at which the front end of a parabola on s = 1/10 alone is at c: a^2 = P R/(2 pi (1/4 - alpha^2)), the end
/// is at (1 - 2 alpha) a.
double load_at_jump(double c) {
  const double alpha = std::atan(0.1) / std::numbers::pi;
  const double a = c / (1 - 2 * alpha);
  return a * a * 2 * std::numbers::pi * (0.25 - alpha * alpha) / 0.2;
}

bool is_between(double value, const LoadStretch& stretch) {
  return static_cast<double>(stretch.from) <= value && value <= static_cast<double>(stretch.to);
}

bool is_narrow(const LoadStretch& stretch, const Rational& width = Rational(1, 1000000)) {
  return stretch.to - stretch.from <= width * stretch.to;
}

}  // namespace

TEST_CASE("an interval of loads: what the solver finds at single loads lies in the box") {
  const ContactProblem problem = parabola(0, 1);
  const LoadInterval interval = prove_loads(problem, *found_contact<double>(problem), 0.95_r, 1.05_r);
  REQUIRE_MESSAGE(interval.proof.proved, interval.proof.reason);
  CHECK(prove_box(interval.proof.problem, interval.box, interval.proof.bits).proved);
  for (int i = 0; i <= 10; ++i) {
    const Rational load = 0.95_r + Rational(i, 100);
    CHECK(holds_solution(interval, *found_contact<Real50>(problem.with_load(load))));
  }
  // At loads outside of the interval, it does not: the box is no wider than necessary.
  CHECK_FALSE(holds_solution(interval, *found_contact<Real50>(problem.with_load(0.85_r))));
  CHECK_FALSE(holds_solution(interval, *found_contact<Real50>(problem.with_load(1.15_r))));
}

TEST_CASE("a box that leaves out the ends of some of the loads is not proved") {
  const ContactProblem problem = parabola(0, 1);
  const LoadInterval interval = prove_loads(problem, *found_contact<double>(problem), 0.99_r, 1.01_r);
  REQUIRE(interval.proof.proved);
  const auto proved = [&](const ContactBox& box) {
    return prove_box(interval.proof.problem, box, interval.proof.bits).proved;
  };
  const ContactBox& box = interval.box;
  CHECK(proved(box));
  for (std::size_t i = 0; i < box.log_offsets.size(); ++i) {
    const Ball width = box.log_offsets[i].radius();
    for (const int sign : {-1, 1}) {
      ContactBox moved = box;
      moved.log_offsets[i] += Ball(sign) * width / Ball(2);
      CHECK_FALSE(proved(moved));
    }
    ContactBox narrow = box;
    narrow.log_offsets[i] = Ball::around(box.log_offsets[i], width / Ball(2));
    CHECK_FALSE(proved(narrow));
  }
  CHECK_FALSE(proved(interval.at_from));
  CHECK_FALSE(proved(interval.at_to));
}

TEST_CASE("loads in the wrong order, or no loads, are refused") {
  const ContactProblem problem = parabola(0, 1);
  const ApproximateContact contact = *found_contact<double>(problem);
  CHECK(thrown_by([&] { prove_loads(problem, contact, 1.1_r, 1); }) ==
        "these are no loads from the smaller to the larger; 0 < from <= to; from 1.1 to 1");
  CHECK(holds(thrown_by([&] { prove_loads(problem, contact, 0, 1); }), "from 0 to 1"));
  CHECK(holds(thrown_by([&] { path(problem, 2, 1); }), "0 < from < to; from 2 to 1"));
  CHECK(holds(thrown_by([&] { path(problem, 1, 1); }), "from 1 to 1"));
  CHECK(holds(thrown_by([&] { path(problem, -1, 1); }), "from -1 to 1"));
  CHECK(holds(thrown_by([&] { path(problem, 1, 2, 0); }), "an event has no width"));
}

TEST_CASE("an end passes a jump at the load that is known; without a jump on its way nothing happens") {
  const Rational c = 0.2_r, from = 0.2_r, to = 0.8_r;
  const auto stretches = path(parabola(c, 1), from, to);
  CHECK(words_of(stretches, from, to) == Words{"the right end of contact passes the friction jump at x = 0.2"});
  const LoadStretch event = events(stretches).front();
  CHECK(is_between(load_at_jump(0.2), event));
  CHECK(is_narrow(event));
  // An interval that contains the event is not proved from either side, even a very short one.
  for (const Rational& load : {event.from, event.to}) {
    const ContactProblem problem = parabola(c, load);
    CHECK_FALSE(prove_loads(problem, *found_contact<Real50>(problem), event.from, event.to).proof.proved);
  }
  // The proved boxes contain the solver's ends, at loads that the proof does not use.
  for (const LoadStretch& s : stretches) {
    if (!s.interval) continue;
    const Rational load = (2 * s.from + s.to) / 3;
    CHECK(holds_solution(*s.interval, *found_contact<Real50>(parabola(c, load))));
  }
  CHECK(words_of(path(parabola(0, 1), from, to), from, to).empty());
  CHECK(words_of(path(reduced({0.1_r}, {}, one_piece(-2, 2, {0, 0, 2.5_r}), 1), from, to), from, to).empty());
}

TEST_CASE("loads that are not proved beside an event belong to it, where what is proved in between is shorter") {
  // An end of contact passes the jump at x = 0. It approaches the jump more and more slowly.
  const ContactProblem problem(Elasticity(Solid(0.3_r, 1)), FrictionProfile({0.1_r, 0.7_r}, {0}),
                               one_piece(-2, 2, {0.25_r, 0, -0.5_r, 0, 0.25_r}), 1);
  const Rational from = 0.773_r, to = 0.7731_r;
  const auto stretches = path(problem, from, to);
  CHECK(words_of(stretches, from, to) == Words{"the left end of contact passes the friction jump at x = 0"});
  CHECK(is_narrow(events(stretches).at(0), Rational(1, 100000)));
}

TEST_CASE("two wells: a second zone of contact is born, and later both meet") {
  const ContactProblem problem = on_two_coatings(two_wells(), 1);
  const auto happens = [&](const Rational& from, const Rational& to, const std::string& what, std::size_t ends_before,
                           std::size_t ends_after) {
    const auto stretches = path(problem, from, to, 0.002_r);
    const auto words = words_of(stretches, from, to);
    REQUIRE(words.size() == 1);
    CHECK_MESSAGE(words.front().starts_with(what), words.front());
    const LoadStretch event = events(stretches).at(0);
    CHECK(is_narrow(event, 0.002_r));
    // The solver's number of zones at both ends of the event.
    CHECK(found_contact<Real50>(problem.with_load(event.from))->ends.size() == ends_before);
    CHECK(found_contact<Real50>(problem.with_load(event.to))->ends.size() == ends_after);
  };
  happens(0.379_r, 0.388_r, "a zone of contact is born near x = 0.9", 2, 4);
  happens(4.7_r, 5, "two zones of contact meet near x = -0.1", 4, 2);
}

TEST_CASE("a rounded punch which may tilt comes to rest on its edges one after the other") {
  const ContactProblem problem = reduced({0.1_r, 0.3_r}, {0.1_r}, one_piece(-1, 1, {0, 0, 1}), 1, 0.05_r);
  const auto stretches = path(problem, 2, 5, 0.00001_r);
  CHECK(words_of(stretches, 2, 5) == Words{"the right end of contact reaches the support's edge at x = 1",
                                           "the left end of contact reaches the support's edge at x = -1"});
  // The solver's contact has one edge between the two events, and none before.
  const auto edges = [&](const Rational& load) {
    const auto ends = found_contact<Real50>(problem.with_load(load))->ends;
    return std::count_if(ends.begin(), ends.end(), [](const auto& end) { return !end.vanishes; });
  };
  const auto at = events(stretches);
  for (const std::size_t k : {0U, 1U}) {
    CHECK(is_narrow(at[k], 0.00001_r));
    CHECK(edges(at[k].from) == static_cast<std::ptrdiff_t>(k));
    CHECK(edges(at[k].to) == static_cast<std::ptrdiff_t>(k) + 1);
  }
}

namespace {

/// Found by two independent computations: from this load on, a roof of slopes 1/5 is in full contact on s = 3/80 |
/// 3/16.
const Rational full_contact_load = 8.308222888593932767_r;

ContactProblem notch(const Rational& load, const Rational& bend = 0, const std::optional<Rational>& load_at = {}) {
  return reduced({0.0375_r, 0.1875_r}, {0}, roof(0.2_r, -0.2_r, bend), load, load_at);
}

/// Checks that the gap closes between these loads, and that the solver agrees at both ends of the event.
void check_closing(const ContactProblem& problem, const Rational& from, const Rational& to,
                   const Rational& width = Rational(1, 1000000)) {
  const auto stretches = path(problem, from, to, width);
  const auto words = words_of(stretches, from, to);
  REQUIRE(words.size() == 1);
  CHECK_MESSAGE(words.front().starts_with("the gap closes over the wedge at x = "), words.front());
  REQUIRE(stretches.size() >= 3);
  CHECK(stretches[0].kind == LoadStretch::Kind::closing);
  const LoadStretch& event = stretches[1];
  CHECK(event.kind == LoadStretch::Kind::event);
  CHECK(is_narrow(event, width));
  CHECK(found_contact<double>(problem.with_load(event.to))->ends.size() == 2);
  Rational before = 1;
  for (const int thirds : {0, 1, 2}) {
    const auto contact = found_contact<double>(problem.with_load(from + (event.from - from) * Rational(thirds, 3)));
    REQUIRE(contact);
    REQUIRE(contact->ends.size() == 4);
    CHECK(contact->ends[1].offset < before);
    before = contact->ends[1].offset;
  }
}

}  // namespace

TEST_CASE("a notch over a rising jump: full contact is proved from the threshold on, a gap for loads below it") {
  const ContactProblem problem = notch(full_contact_load);
  const ApproximateContact everywhere{{{-1}, {1}}};
  const auto full = [&](const Rational& from, const Rational& to) {
    return prove_loads(problem, everywhere, full_contact_load * from, full_contact_load * to).proof.proved;
  };
  CHECK(full(1.000001_r, 1.01_r));
  CHECK_FALSE(full(0.999999_r, 1.01_r));
  CHECK_FALSE(full(0.99_r, 0.999999_r));

  const auto gap = found_contact<double>(problem.with_load(2));
  REQUIRE(gap);
  REQUIRE(gap->ends.size() == 4);
  const LoadInterval interval = prove_loads(problem, *gap, 1.998_r, 2.002_r);
  CHECK_MESSAGE(interval.proof.proved, interval.proof.reason);
  CHECK(holds_solution(interval, *found_contact<Real50>(problem.with_load(1.9985_r))));
  CHECK_FALSE(holds_solution(interval, *found_contact<Real50>(problem.with_load(2.01_r))));
}

TEST_CASE("the gap of a notch closes at the load that is known") {
  check_closing(notch(1), 3, 10);
  const auto stretches = path(notch(1), 2, 9);
  CHECK(is_between(static_cast<double>(full_contact_load), events(stretches).at(0)));
  // All loads below are one branch, also if it is proved by intervals.
  const Rational below = full_contact_load * (1 - Rational(1, 1000000000));
  CHECK(words_of(path(notch(1), 2, below), 2, below).empty());
  const auto by_intervals = path(notch(1), 2, 2.004_r, Rational(1, 1000000), true);
  CHECK(words_of(by_intervals, 2, 2.004_r).empty());
  CHECK(by_intervals.front().kind == LoadStretch::Kind::proved);
  // A range may end inside the interval of the event; the event is then narrower. The threshold's own digits are not
  // tested.
  const Rational above = full_contact_load * (1 + Rational(1, 1000000000));
  CHECK(is_narrow(events(path(notch(1), 2, above)).at(0), Rational(1, 500000000)));
  CHECK(words_of(path(notch(1), above, 9), above, 9).empty());
  const auto undecided = path(notch(1), 2, full_contact_load);
  CHECK(words_of(undecided, 2, full_contact_load) == Words{"whether the gap has closed is not decided"});
  CHECK(is_narrow(undecided.back(), Rational(1, 1000000000000)));
}

TEST_CASE("gaps that can only close") {
  const auto closes = [](const ContactProblem& problem, const ApproximateContact& contact) {
    const ReducedProblem reduced(problem, frame_of(problem, contact));
    const ContactStart start(reduced, contact);
    REQUIRE(start.topology.fault(reduced).empty());
    const auto full = closed_gap(reduced, start.box(64));
    if (full) CHECK(full->topology == ContactStart(reduced, {{{-1}, {1}}}).topology);
    return full.has_value();
  };
  const ApproximateContact::End left{0, Side::left, 0.01_r, true}, right{0, Side::right, 0.02_r, true};
  const ApproximateContact gap{{{-1}, left, right, {1}}};
  CHECK(closes(notch(1), gap));
  CHECK(closes(notch(1, 0.1_r), gap));
  CHECK_FALSE(closes(notch(1, -0.1_r), gap));
  CHECK_FALSE(closes(notch(1, 0, 0.01_r), gap));
  CHECK_FALSE(closes(notch(1), {{{-1}, {1}}}));
  CHECK_FALSE(closes(notch(1), {{{-1, Side::right, 0.1_r, true}, left, right, {1}}}));
  CHECK_FALSE(closes(notch(1), {{{-1}, left}}));
  const Indenter stepped(-1, {{0, Polynomial({0, 0.2_r})}, {1, Polynomial({0.1_r, -0.2_r})}});
  CHECK_FALSE(closes(reduced({0.1_r, 0.2_r}, {0}, stepped, 1), gap));
  // Flanks that are convex only beside the wedge: (x/2)^3 - x/2, and its mirror image.
  const Indenter cubic(-1,
                       {{0, Polynomial({0, 0.5_r, 0.1_r, 0.125_r})}, {1, Polynomial({0, -0.5_r, 0.1_r, -0.125_r})}});
  CHECK(closes(reduced({0.1_r, 0.2_r}, {0}, cubic, 1), gap));
  CHECK_FALSE(closes(reduced({0.1_r, 0.2_r}, {0}, cubic, 1), {{{-1}, {0, Side::left, 0.4_r, true}, right, {1}}}));

  // If full contact has no tension at the first load, it says nothing about a gap.
  const ReducedProblem problem(notch(1), {0, 2});
  const ContactBox full = ContactStart(problem, {{{-1}, {1}}}).box(64);
  JacobiRules rules(64);
  WorkBudget work;
  CHECK_FALSE(full_contact_from(problem, full, full_contact_load * 1.001_r, 9, 0.001_r, rules, work));
  const auto from = full_contact_from(problem, full, 2, 9, 0.001_r, rules, work);
  REQUIRE(from);
  CHECK(from->refuted < full_contact_load);
  CHECK(full_contact_load < from->proved.value());
  CHECK_FALSE(full_contact_from(problem, full, 2, 8, 0.001_r, rules, work)->proved);
}

TEST_CASE("slow: notches close on other coatings, with other jumps and flanks, or never" * doctest::skip()) {
  const auto on = [](const std::vector<Rational>& s, const std::vector<Rational>& jumps, const Indenter& indenter) {
    return reduced(s, jumps, indenter, 1);
  };
  check_closing(on({0.05_r, 0.3_r}, {0}, roof(0.2_r, -0.2_r)), 1, 9);
  check_closing(on({0.05_r, 0.3_r}, {0}, roof(0.2_r, -0.1_r)), 1, 9);
  check_closing(on({0.05_r, 0.3_r}, {0}, roof(0.2_r, -0.2_r, 0.05_r)), 1, 9);
  check_closing(on({0.3_r, 0.05_r, 0.6_r, 0.7_r}, {-0.5_r, 0, 0.3_r}, roof(0.2_r, -0.2_r)), 1, 20,
                Rational(1, 100000000));
  // If friction falls or is constant, no load closes the gap.
  for (const ContactProblem& problem :
       {on({0.3_r, 0.1_r}, {0}, roof(0.2_r, -0.2_r)), on({0.3_r}, {}, roof(0.2_r, -0.2_r))}) {
    const auto stretches = path(problem, 1, 50);
    CHECK(words_of(stretches, 1, 50).empty());
    CHECK(stretches.size() == 1);
  }
  // A range that begins close to the event.
  const Rational below = full_contact_load * (1 - Rational(1, 10000000));
  const auto stretches = path(notch(1), below, 9);
  CHECK(words_of(stretches, below, 9) == Words{"the gap closes over the wedge at x = 0"});
  CHECK(is_narrow(events(stretches).at(0)));
}

namespace {

/// Proves random problems from `first` to before `last` over loads, and checks that the boxes contain the solver's
/// contact.
void follows_random_problems(int first, int last) {
  int solved_problems = 0;
  Rational proved = 0;
  for (int i = first; i < last; ++i) {
    CAPTURE(i);
    const ContactProblem problem = random_contact(first_listed_seed + static_cast<std::uint64_t>(i));
    if (!found_contact<double>(problem)) continue;
    ++solved_problems;
    const Rational from = problem.load() * 0.99_r, to = problem.load() * 1.01_r;
    const auto stretches = path(problem, from, to, 0.001_r);
    words_of(stretches, from, to);
    for (const LoadStretch& s : stretches) {
      if (s.kind == LoadStretch::Kind::open) MESSAGE(i << ": " << s.words);
      if (!s.interval) continue;
      proved += (s.to - s.from) / (to - from);
      const auto contact = found_contact<Real50>(problem.with_load((2 * s.from + s.to) / 3));
      if (contact) CHECK(holds_solution(*s.interval, *contact));
    }
  }
  CHECK(proved > 0.9_r * solved_problems);
}

}  // namespace

TEST_CASE("slow: random problems 0 to 24 over loads" * doctest::skip()) { follows_random_problems(0, 25); }
TEST_CASE("slow: random problems 25 to 49 over loads" * doctest::skip()) { follows_random_problems(25, 50); }
TEST_CASE("slow: random problems 50 to 74 over loads" * doctest::skip()) { follows_random_problems(50, 75); }
TEST_CASE("slow: random problems 75 to 99 over loads" * doctest::skip()) { follows_random_problems(75, 100); }

}  // namespace steadyslide::enclosure
