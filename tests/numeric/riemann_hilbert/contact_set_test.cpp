#include "numeric/riemann_hilbert/contact_set.hpp"
#include "support/numeric_test.hpp"
#include "support/problems.hpp"

namespace {

template <Real R>
using Kind = typename ContactSet<R>::Kind;

ContactProblem jumps_on(const Rational& left, const Rational& right, const std::vector<Rational>& jumps) {
  std::vector<Rational> s;
  for (std::size_t k = 0; k <= jumps.size(); ++k) s.push_back(Rational(static_cast<int>(k) + 1, 20));
  return reduced(s, jumps, one_piece(left, right, {0, 0, 1}), 1);
}

const Frame unit_frame{0, 1};

/// Returns the fault of a set; empty if there is none.
template <Real R>
std::string fault(const RoundedProblem<R>& problem, const ContactSet<R>& set) {
  using std::abs;
  R sum = 0;
  std::size_t anchor = 0;
  bool contact = false;
  if (set.points().size() != set.segments() + 1 || set.points().front().anchor != 0U) return "shape";
  for (std::size_t j = 0; j < set.segments(); ++j) {
    const auto& point = set.point(j);
    if (point.anchor && j > 0) {
      if (*point.anchor != ++anchor) return "order of anchors";
      if (abs(sum - problem.spacing(anchor - 1)) > 4 * epsilon<R>() * problem.spacing(anchor - 1)) return "spacing";
      sum = 0;
    }
    if (point.is_end() && contact == (point.kind == Kind<R>::begins)) return "ends do not alternate";
    if (!point.anchor && !point.is_end()) return "a point without purpose";
    if (point.kind != Kind<R>::interior) contact = point.kind == Kind<R>::begins;
    if (set.in_contact(j) != contact || set.interval(j) != anchor) return "segment";
    const R& length = set.length(j);
    if (!(length > 0)) return "length";
    if (abs(set.x(j + 1) - set.x(j) - length) > 16 * epsilon<R>() * (abs(set.x(j)) + length)) return "place";
    sum += length;
  }
  if (set.points().back().anchor != problem.anchors().size() - 1) return "last anchor";
  return "";
}

template <Real R>
typename ContactSet<R>::SegmentPlace place(const ContactSet<R>& set, std::size_t segment, const R& part) {
  return {segment, part * set.length(segment), (1 - part) * set.length(segment)};
}

/// Makes one random change of the set. Free ends keep a distance of a thousandth of the available length.
template <Real R>
void change(ContactSet<R>& set) {
  const auto part = [](int low, int high) { return R(uniform(low, high)) / 1000; };
  const std::vector<std::size_t> free = set.movable();
  const auto any_segment = static_cast<std::size_t>(uniform(0, static_cast<int>(set.segments()) - 1));
  const int kind = uniform(0, 4);
  if (kind == 1) {
    if (set.components() > 4) return;
    set.open(place(set, any_segment, part(1, 499)), place(set, any_segment, part(501, 999)));
  } else if (kind == 2) {
    const auto begins = set.all(uniform(0, 1) == 0 ? Kind<R>::begins : Kind<R>::ends);
    if (begins.size() > 1) set.remove_interval(begins.front());
  } else if (free.empty()) {
    return;
  } else if (kind == 0) {
    std::vector<R> steps;
    for (const std::size_t j : free) {
      const R p = part(-450, 450);
      steps.push_back(p * (p < 0 ? set.length(j - 1) : set.length(j)));
    }
    set.move(steps);
  } else if (kind == 3) {
    const std::size_t j = free[static_cast<std::size_t>(uniform(0, static_cast<int>(free.size()) - 1))];
    const Side side = uniform(0, 1) == 0 ? Side::left : Side::right;
    const std::size_t neighbour = side == Side::left ? j - 1 : j + 1;
    const bool at_support = neighbour == 0 || neighbour == set.segments();
    using std::pow;
    if (!set.point(neighbour).is_end() && !at_support) set.cross_anchor(j, side, pow(R(10), -uniform(1, 40)));
  } else {
    const std::size_t j = free.front(), k = uniform(0, 1) == 0 ? j : j - 1;
    set.move_end(j, k, part(1, 999) * set.length(k));
  }
}

}  // namespace

TEST_CASE_TEMPLATE("random changes: lengths add up to the anchors' spacing and places follow them", R, double, Real50) {
  const ContactProblem p = jumps_on(Rational(-7, 3), 2, {-1.5_r, -0.001_r, 0, Rational(1, 3), Rational(4, 3)});
  const RoundedProblem<R> problem(p, unit_frame);
  CHECK(rc::check("random changes", [&] {
    ContactSet<R> set(problem, {{-1.7, -0.3, false, false}, {0.2, 1, false, false}});
    RC_ASSERT(fault(problem, set) == "");
    for (int i = 0; i < 30; ++i) {
      change(set);
      RC_ASSERT(fault(problem, set) == "");
    }
  }));
}

TEST_CASE("zones that somebody guessed") {
  const ContactProblem p = jumps_on(-1, 1, {0});
  const RoundedProblem<double> problem(p, unit_frame);
  for (const ContactInterval& guess : {ContactInterval{-1, 1, true, true},
                                       {-1, 0.5, true, false},
                                       {-0.5, 1, false, true},
                                       {-0.5, 0.5, false, false},
                                       {0, 0.5, false, false},
                                       {-0.5, 0, false, false}}) {
    const ContactSet<double> set(problem, {guess});
    CHECK(fault(problem, set) == "");
    REQUIRE(set.components() == 1U);
    const auto& begin = set.point(set.all(Kind<double>::begins).front());
    const auto& end = set.point(set.all(Kind<double>::ends).front());
    CHECK(begin.is_free() != guess.left_at_edge);
    CHECK(end.is_free() != guess.right_at_edge);
    CHECK(set.span_length() == doctest::Approx(guess.right - guess.left).epsilon(0.05));
    // An end never lies on an anchor: the jump at 0 is either inside or outside.
    CHECK(set.movable().size() == (begin.is_free() ? 1U : 0U) + (end.is_free() ? 1U : 0U));
  }
}

TEST_CASE("an end settles at an anchor, and the set is closed and opened again") {
  const ContactProblem p = jumps_on(-1, 1, {0, 0.5_r});
  const RoundedProblem<double> problem(p, unit_frame);
  ContactSet<double> set(problem, {{-0.5, 0.25, false, false}});
  set.attach_to_anchor(set.all(Kind<double>::ends).front(), Side::right, true);
  CHECK(fault(problem, set) == "");
  CHECK(set.movable().size() == 1U);
  CHECK(set.point(set.all(Kind<double>::ends).front()).is_free());
  set.attach_to_anchor(set.all(Kind<double>::begins).front(), Side::left, false);
  CHECK(fault(problem, set) == "");
  CHECK(set.span_length() == doctest::Approx(1.5));
  CHECK(!set.point(0).is_free());
  CHECK(set.movable().empty());
  // A gap from one segment into the next contains the anchor between them.
  set.open({0, 0.75, 0.25}, {1, 0.25, 0.25});
  CHECK(fault(problem, set) == "");
  CHECK(set.components() == 2U);
  CHECK(set.length(1) + set.length(2) == doctest::Approx(0.5));
  set.remove_interval(set.all(Kind<double>::ends).front());
  CHECK(set.components() == 1U);
  CHECK(set.span_length() == doctest::Approx(1.5));
  set.open({2, 0.1, 0.4}, {2, 0.2, 0.3});  // beyond the contact: a new component
  CHECK(set.components() == 2U);
  CHECK(fault(problem, set) == "");
}

TEST_CASE("tiny lengths survive, in the type and on the way to another one") {
  const ContactProblem p = jumps_on(-1, 1, {Rational(-1, 3), Rational(1, 3)});
  const RoundedProblem<double> rough(p, unit_frame);
  const RoundedProblem<Real50> fine(p, unit_frame);
  for (const double tiny : {1e-12, 1e-30, 1e-300}) {
    ContactSet<double> set(rough, {{-0.2, 0.2, false, false}});
    const std::size_t begin = set.all(Kind<double>::begins).front();
    set.cross_anchor(begin, Side::left, tiny);
    set.cross_anchor(set.all(Kind<double>::ends).front(), Side::right, tiny);
    CHECK(fault(rough, set) == "");
    CHECK(set.length(1) == tiny);
    CHECK(set.length(3) == tiny);
    const auto converted = ContactSet<Real50>::converted(fine, set);
    CHECK(converted.length(1) == Real50(tiny));
    CHECK(converted.length(3) == Real50(tiny));
    CHECK(fault(fine, converted) == "");
    CHECK(converted.x(1) <= fine.anchors()[1].x);
    const auto back = ContactSet<double>::converted(rough, converted);
    CHECK(back.length(1) == tiny);
    CHECK(fault(rough, back) == "");
  }
}

TEST_CASE_TEMPLATE("anchors a million units away take no digit from the contact", R, double, Real50) {
  const ContactProblem p = jumps_on(-1000000, 1000000, {});
  const RoundedProblem<R> problem(p, unit_frame);
  CHECK(rc::check("far supports", [&] {
    using std::abs;
    ContactSet<R> set(problem, {{-1, 1, false, false}});
    R left = set.x(1), right = set.x(2);
    for (int i = 0; i < 30; ++i) {
      const R a = R(uniform(-1000, 1000)) / 10007, b = R(uniform(-1000, 1000)) / 10007;
      if (right + b - left - a < 0.1 || abs(left + a) > 3 || abs(right + b) > 3) continue;
      set.move({a, b});
      left += a;
      right += b;
      RC_ASSERT(abs(set.x(1) - left) <= 200 * epsilon<R>());
      RC_ASSERT(abs(set.x(2) - right) <= 200 * epsilon<R>());
      RC_ASSERT(abs(set.length(1) - (right - left)) <= 200 * epsilon<R>());
      RC_ASSERT(fault(problem, set) == "");
    }
  }));
}

TEST_CASE("control: the checker sees a set that belongs to another problem") {
  const ContactProblem p = jumps_on(-1, 1, {0});
  const ContactProblem other = jumps_on(-1, 1, {Rational(1, 1000000)});
  const RoundedProblem<double> problem(p, unit_frame), displaced(other, unit_frame);
  const ContactSet<double> set(problem, {{-0.5, 0.5, false, false}});
  CHECK(fault(problem, set) == "");
  CHECK(fault(displaced, set) == "spacing");
}
