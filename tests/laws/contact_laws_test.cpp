// Changes of a problem that change its solution in a known way, for the Riemann-Hilbert solver on the random problems
// that it is measured by; and the closed forms, which it has to reproduce.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "numeric/riemann_hilbert/riemann_hilbert.hpp"
#include "support/random_contact.hpp"
#include "support/random_problem.hpp"

using namespace steadyslide;
using namespace steadyslide::numeric;

namespace {

using Solution = ContactSolution<double>;
using Contact = std::vector<ContactComponent<double>>;

// Two runs round differently, and free ends amplify it. In units of the contact's length, of each intensity, and of
// load/length; set before there was a solver to measure.
constexpr double end_tolerance = 1e-10;
constexpr double intensity_tolerance = 1e-8;
constexpr double traction_tolerance = 1e-9;

/// A problem and what is expected of the changed one: x -> scale x + shift, t -> factor t.
struct Law {
  ContactProblem changed;
  Rational scale = 1;
  Rational shift = 0;
  double factor = 1;
};

double real(const Rational& value) { return value.convert_to<double>(); }

double length_of(const Contact& contact) { return contact.back().right.x.value - contact.front().left.x.value; }

bool close(double a, double b, double scale) { return (std::isinf(a) && a == b) || std::abs(a - b) <= scale; }

bool close_relatively(double a, double b, double tolerance) {
  return close(a, b, tolerance * (std::abs(a) + std::abs(b)));
}

std::string compare_end(const ContactEnd<double>& a, const ContactEnd<double>& b, const Law& law, double length) {
  const double scale = real(law.scale);
  if (a.kind != b.kind || !(a.exponent == b.exponent)) return "another kind of end";
  if (!close(scale * a.x.value + real(law.shift), b.x.value, end_tolerance * std::abs(scale) * length)) return "end";
  const double expected = law.factor * a.intensity.value * std::pow(std::abs(scale), -to_real<double>(a.exponent));
  return close_relatively(expected, b.intensity.value, intensity_tolerance) ? "" : "intensity";
}

std::string compare_resultants(const Solution& before, const Solution& after, const Law& law, double length) {
  const double scale = real(law.scale);
  const double force = law.factor * std::abs(scale);
  const Resultants<double> a = before.resultants();
  const Resultants<double> b = after.resultants();
  if (!close_relatively(force * a.normal.value, b.normal.value, traction_tolerance)) return "normal";
  if (!close(force * a.tangential.value, b.tangential.value,
             traction_tolerance * (std::abs(b.tangential.value) + b.normal.value))) {
    return "tangential";
  }
  if (!close(scale * a.centre_of_pressure.value + real(law.shift), b.centre_of_pressure.value,
             end_tolerance * 10 * std::abs(scale) * length)) {
    return "centre of pressure";
  }
  const auto tilt_before = before.tilt();
  const auto tilt_after = after.tilt();
  if (tilt_before.has_value() != tilt_after.has_value()) return "tilt";
  if (!tilt_before) return "";
  const double expected = (law.scale < 0 ? -law.factor : law.factor) * tilt_before->value;
  const double slope = real(law.changed.elasticity().compliance()) * b.normal.value / (std::abs(scale) * length);
  return close(expected, tilt_after->value, intensity_tolerance * (std::abs(expected) + slope)) ? "" : "tilt";
}

/// In the middle of each contact component and towards its ends.
std::vector<Rational> places(const Contact& contact) {
  std::vector<Rational> result;
  for (const ContactComponent<double>& zone : contact) {
    const Rational left(zone.left.x.value);
    const Rational width = Rational(zone.right.x.value) - left;
    for (const int part : {13, 271, 502, 838, 991}) result.push_back(left + width * part / 1009);
  }
  return result;
}

std::string compare_traction(const Solution& before, const Solution& after, const Law& law, double length) {
  const double mean = before.resultants().normal.value / length;
  for (const Rational& x : places(before.contact())) {
    const double expected = law.factor * before.at(x).traction.left.value;
    const TwoSided<double> found = after.at(law.scale * x + law.shift).traction;
    const double t = law.scale < 0 ? found.right.value : found.left.value;
    if (!close(expected, t, traction_tolerance * (std::abs(expected) + law.factor * mean))) return "traction";
  }
  return "";
}

/// What does not agree, or nothing.
std::string compare(const Solution& before, const Solution& after, const Law& law) {
  const Contact a = before.contact();
  Contact b = after.contact();
  if (a.size() != b.size()) return "another number of zones";
  if (law.scale < 0) {
    std::reverse(b.begin(), b.end());
    for (ContactComponent<double>& zone : b) std::swap(zone.left, zone.right);
  }
  const double length = length_of(a);
  for (std::size_t k = 0; k < a.size(); ++k) {
    for (const auto end : {&ContactComponent<double>::left, &ContactComponent<double>::right}) {
      if (const std::string text = compare_end(a[k].*end, b[k].*end, law, length); !text.empty()) return text;
    }
  }
  const std::string text = compare_resultants(before, after, law, length);
  return text.empty() ? compare_traction(before, after, law, length) : text;
}

/// Solves the first `count` random problems and those that `change` makes of them. What is not solved at all is the
/// business of tests/known_limits; here it may be one problem in twenty.
template <class Change>
void obey(int count, const Change& change) {
  int compared = 0;
  std::string last_reason;
  for (int i = 0; i < count; ++i) {
    const std::uint64_t seed = testing::first_listed_seed + static_cast<std::uint64_t>(i);
    const ContactProblem problem = testing::random_contact(seed);
    const Attempt<double> before = riemann_hilbert<double>(problem);
    if (!before.solution || !before.solution->shortcoming().empty()) {
      last_reason = before.solution ? before.solution->shortcoming() : before.why_not;
      continue;
    }
    const Law law = change(problem, *before.solution);
    const Attempt<double> after = riemann_hilbert<double>(law.changed);
    ++compared;
    const std::string text = after.solution ? compare(*before.solution, *after.solution, law) : after.why_not;
    CHECK_MESSAGE(text.empty(), (std::to_string(seed) + ' ' + text));
  }
  CHECK_MESSAGE(20 * compared >= 19 * count, "compared " << compared << " of " << count << ": " << last_reason);
}

/// A place in the first zone where friction does not change and no two pieces meet.
Rational regular_place(const ContactProblem& problem, const Solution& solution) {
  for (const Rational& x : places(solution.contact())) {
    const std::vector<Rational>& jumps = problem.friction().jumps();
    const auto& pieces = problem.indenter().pieces();
    if (std::find(jumps.begin(), jumps.end(), x) == jumps.end() &&
        std::none_of(pieces.begin(), pieces.end(), [&](const Indenter::Piece& piece) { return piece.to == x; })) {
      return x;
    }
  }
  return (problem.indenter().left() + problem.indenter().right()) / 2;
}

/// psi times `profile_factor`, the load times `load_factor`.
ContactProblem scaled(const ContactProblem& p, const Rational& profile_factor, const Rational& load_factor) {
  return p.with_indenter(p.indenter().scaled(profile_factor)).with_load(load_factor * p.load());
}

void all_laws(int count) {
  SUBCASE("mirror") {
    obey(count, [](const ContactProblem& p, const Solution&) { return Law{p.mirrored(), -1}; });
  }
  SUBCASE("translation") {
    obey(count, [](const ContactProblem& p, const Solution&) {
      return Law{p.moved(1, Rational(-7, 3)), 1, Rational(-7, 3)};
    });
  }
  SUBCASE("dilation with the profile, the load in proportion: the same traction") {
    for (const Rational& k : {Rational(4), Rational(3, 5)}) {
      obey(count, [&](const ContactProblem& p, const Solution&) { return Law{scaled(p, k, k).moved(k, 0), k}; });
    }
  }
  SUBCASE("load and profile in proportion: the same contact") {
    for (const Rational& k : {Rational(8), Rational(5, 7)}) {
      obey(count, [&](const ContactProblem& p, const Solution&) { return Law{scaled(p, k, k), 1, 0, real(k)}; });
    }
  }
  SUBCASE("a jump of height zero changes nothing") {
    obey(count, [](const ContactProblem& p, const Solution& solution) {
      return Law{p.with_jump(regular_place(p, solution), 0)};
    });
  }
}

/// Ends and tractions in every panel.
template <Real R>
void reproduces_the_closed_form(const ContactProblem& problem, const R& tolerance) {
  using std::abs;
  const Attempt<R> expected = closed_form<R>(problem);
  const Attempt<R> found = riemann_hilbert<R>(problem);
  if (!found.solution) RC_FAIL(found.why_not);
  RC_ASSERT(found.solution->shortcoming() == "");
  const auto a = expected.solution->contact();
  const auto b = found.solution->contact();
  RC_ASSERT(b.size() == 1U);
  const R length = a[0].right.x.value - a[0].left.x.value;
  RC_ASSERT(b[0].left.kind == a[0].left.kind);
  RC_ASSERT(b[0].right.kind == a[0].right.kind);
  RC_ASSERT(abs(b[0].left.x.value - a[0].left.x.value) <= tolerance * length);
  RC_ASSERT(abs(b[0].right.x.value - a[0].right.x.value) <= tolerance * length);
  std::vector<R> ends;
  for (const SolvedSingularPoint<R>& point : expected.solution->singular_points()) ends.push_back(point.x.value);
  for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
    for (const int part : {31, 317, 503, 811, 983}) {
      const R x = ends[k] + (ends[k + 1] - ends[k]) * part / 1009;
      const Rational place(static_cast<double>(x));
      const R t = expected.solution->at(place).traction.left.value;
      // An end displaced by the tolerance moves the traction at the distance d from it by that over d.
      const R distance = std::min(R(x - a[0].left.x.value), R(a[0].right.x.value - x));
      const R allowed = tolerance * abs(t) * (1 + length / distance);
      RC_ASSERT(abs(found.solution->at(place).traction.left.value - t) <= allowed);
    }
  }
}

template <Real R>
void reproduces_closed_forms(const R& tolerance) {
  CHECK(rc::check("flat punches", [&] { reproduces_the_closed_form<R>(*testing::flat_punch(4), tolerance); }));
  CHECK(rc::check("parabolas", [&] { reproduces_the_closed_form<R>(*testing::parabola(4), tolerance); }));
}

}  // namespace

TEST_CASE("laws") { all_laws(40); }

TEST_CASE("slow: laws" * doctest::skip()) { all_laws(400); }

TEST_CASE("closed forms in double") { reproduces_closed_forms<double>(1e-12); }

TEST_CASE("digits: closed forms with 50 digits" * doctest::skip()) { reproduces_closed_forms<Real50>(Real50("1e-44")); }

TEST_CASE("digits: closed forms with 100 digits" * doctest::skip()) {
  reproduces_closed_forms<Real100>(Real100("1e-92"));
}

TEST_CASE("control: wrong laws are refuted") {
  const ContactProblem p(Elasticity(Solid(0, 1)), FrictionProfile({Rational(1, 2), 1}, {Rational(1, 10)}),
                         Indenter(-1, {{1, Polynomial({0, Rational(1, 8), 1})}}), Rational(1, 4));
  const Attempt<double> before = riemann_hilbert<double>(p);
  REQUIRE_MESSAGE(before.solution, before.why_not);
  const auto refuted = [&](const Law& law) {
    const Attempt<double> after = riemann_hilbert<double>(law.changed);
    REQUIRE_MESSAGE(after.solution, after.why_not);
    return compare(*before.solution, *after.solution, law);
  };
  CHECK(refuted({p.mirrored(), -1}) == "");
  CHECK(refuted({p.mirrored().with_sliding(p.sliding()), -1}) != "");        // sliding direction kept
  CHECK(refuted({p.moved(2, 0), 2}) != "");                                  // heights and load kept
  CHECK(refuted({scaled(p, 2, 1), 1, 0, 2}) != "");                          // load kept
  CHECK(refuted({p.with_jump(Rational(-1, 100), Rational(1, 100))}) != "");  // a jump of some height
  const Rational nearly = Rational(1) + Rational(1, 100000000);
  CHECK(refuted({scaled(p, nearly, nearly), 1, 0, 1}) != "");  // a near miss
}
