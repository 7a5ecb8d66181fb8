// The sign of the traction at anchors and ends of the contact: the rules against values as near as numbers reach, and
// solutions below the load at which a notch closes.

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <cmath>

#include "numeric/riemann_hilbert/contact_inequalities.hpp"
#include "numeric/riemann_hilbert/local_signs.hpp"
#include "support/solved_contact.hpp"
#include "uniform.hpp"

using namespace steadyslide;
using namespace steadyslide::numeric;
using testing::one_piece;
using testing::reduced;
using testing::solved;

namespace {

Indenter roof(const Rational& left, const Rational& right, const Rational& bend = 0) {
  return {-1, {{0, Polynomial({0, left, bend})}, {1, Polynomial({0, right, bend})}}};
}

/// psi = -|x|/5 over s = 0.0375 | 0.1875 is in full contact from this load on: theta at 0 vanishes there.
const Rational threshold = parse_rational("8.308222888593932767");

ContactProblem notch(const Rational& part_of_threshold, bool mirrored = false) {
  const ContactProblem problem = reduced({Rational(3, 80), Rational(3, 16)}, {0}, roof(Rational(1, 5), Rational(-1, 5)),
                                         part_of_threshold * threshold);
  return mirrored ? problem.mirrored() : problem;
}

/// Full contact under edges, whatever its traction.
template <Real R>
struct FullContact {
  explicit FullContact(const ContactProblem& p) : data(p), problem(data, {0, 1}) {
    auto state = ContactState<R>::initial(problem, ContactSet<R>(problem, {{-1, 1, true, true}}), R(0));
    found = {state, R(0), ""};
    form.emplace(problem, state.set, state.q, state.tilt, rules);
  }
  ContactProblem data;
  ReducedProblem<R> problem;
  JacobiRules<R> rules;
  SearchResult<R> found{ContactState<R>{ContactSet<R>(problem), {}, R(0)}, R(0), ""};
  std::optional<RiemannHilbertForm<R>> form;
};

template <Real R>
R traction_beside(const RiemannHilbertForm<R>& form, std::size_t j, Side side, const R& d) {
  const std::size_t k = side == Side::left ? j - 1 : j;
  const R rest = form.set().length(k) - d;
  return form
      .traction({static_cast<std::ptrdiff_t>(k),
                 {form.set().x(j), side == Side::left ? rest : d, side == Side::left ? d : rest}})
      .value;
}

/// Lengths of the two halves of the gap over the notch.
double gap(const ContactSolution<double>& solution) {
  const auto zones = solution.contact();
  REQUIRE(zones.size() == 2U);
  CHECK(zones[0].right.x.value < 0);
  CHECK(zones[1].left.x.value > 0);
  return zones[1].left.x.value - zones[0].right.x.value;
}

}  // namespace

TEST_CASE("the rules against the traction at 10^-1000000 from the corner") {
  int pulls = 0;
  int pushes = 0;
  CHECK(rc::check("full contact over any corner, any friction", [&] {
    const auto slope = [] { return Rational(uniform(-4, 4), 8); };
    const auto s = [] { return Rational(uniform(0, 8), 4); };
    const Rational bend = uniform(0, 2) == 0 ? Rational(0) : Rational(uniform(-4, 4), 4);
    const ContactProblem p = reduced({s(), s()}, {0}, roof(slope(), slope(), bend), Rational(uniform(1, 64), 4));
    const FullContact<Real50> full(p);
    for (std::size_t j = 0; j < 3; ++j) {
      const auto term = leading_term(*full.form, j);
      RC_ASSERT(term.has_value());
      if (term->sign == 0) continue;
      const Real50 d = pow(Real50(10), -1000000);
      for (const Side side : {Side::left, Side::right}) {
        if (j == (side == Side::left ? 0U : 2U)) continue;
        const Real50 t = traction_beside(*full.form, j, side, d);
        RC_ASSERT((term->sign > 0) == (t > 0));
        RC_ASSERT(t != 0);
      }
      if (j == 1) ++(term->sign > 0 ? pulls : pushes);
    }
  }));
  CHECK(pulls > 10);
  CHECK(pushes > 10);
}

TEST_CASE("a notch over a rising jump opens below its threshold, by a gap like (1 - P/P_c)^(1/|beta|)") {
  for (const bool mirrored : {false, true}) {
    CAPTURE(mirrored);
    double last = 1;
    for (const char* part : {"0.5", "0.6", "0.7", "0.9", "0.99", "0.999", "0.999999"}) {
      CAPTURE(part);
      const double now = gap(*solved<double>(notch(parse_rational(part), mirrored)));
      CHECK(now < last);
      last = now;
    }
    const double power = std::atan(3. / 16) / pi<double>() - std::atan(3. / 80) / pi<double>();
    const double nearer = gap(*solved<double>(notch(parse_rational("0.9999999"), mirrored)));
    CHECK(std::log(last / nearer) / std::log(10) == doctest::Approx(1 / power).epsilon(1e-5));
    const auto full = solved<double>(notch(parse_rational("1.000001"), mirrored));
    REQUIRE(full->contact().size() == 1U);
    for (const auto& point : full->singular_points()) CHECK(point.intensity.value > 0);
  }
}

TEST_CASE("what is in contact where it pulls has an infinite tension, and a name") {
  const FullContact<double> full(notch(Rational(7, 10)));
  const auto seen = violations(*full.form);
  REQUIRE(seen.size() == 1U);
  CHECK(seen[0].what == Violation<double>::What::tension);
  CHECK(seen[0].anchor == 1U);
  const std::string words = in_words(*full.form, 1, *leading_term(*full.form, 1));
  CAPTURE(words);
  CHECK(words.find("x = 0 pulls: theta = -0.79") != std::string::npos);
  const auto full_contact = [](const ReducedProblem<double>& problem, JacobiRules<double>&) -> SearchResult<double> {
    return {{ContactSet<double>(problem, {{-1, 1, true, true}}), {problem.load()}, 0}, 0, ""};
  };
  const RiemannHilbertSolution<double> accepted(full.data, {0, 1}, full_contact);
  CHECK(accepted.residuals().tension == infinity<double>());
  // The same corner in a notch without jump, and one where friction falls: whatever the load.
  for (const auto& s : {std::vector<Rational>{1, 1}, {1, Rational(1, 2)}}) {
    const FullContact<double> other(reduced(s, {0}, roof(Rational(1, 8), Rational(-1, 8)), 1000));
    CHECK(leading_term(*other.form, 1)->sign == 1);
    CHECK(highest_limit(*other.form, 0.) > 0);
  }
}

TEST_CASE("gaps over notches without a jump, however short") {
  for (const int load : {4, 8, 12}) {
    const auto found = riemann_hilbert<double>(
        reduced({1}, {}, Indenter(-1, {{0, Polynomial({0, Rational(1, 8), 1})}, {1, Polynomial({0, 0, 1})}}), load));
    CHECK(found.solution->shortcoming() == "");
    CHECK(found.solution->contact().size() == 2U);
    CHECK(found.solution->residuals().load < 1e-13);
    CHECK(found.solution->residuals().equation < 1e-10);
  }
}

TEST_CASE("a gap that double cannot hold is refused, with the reason") {
  const auto found =
      riemann_hilbert<double>(reduced({Rational(1, 2)}, {}, roof(Rational(1, 8), Rational(-1, 8)), 1000));
  CHECK(found.solution->shortcoming().find("the leading term at x = 0 pulls") == 0);
  CHECK(found.solution->residuals().tension == infinity<double>());
}

TEST_CASE("no solution of a random notch over a jump has a sign that is known to be wrong") {
  int solved_ones = 0;
  CHECK(rc::check("random slopes, frictions and loads", [&] {
    const auto slope = [] { return Rational(uniform(1, 16), 16); };
    const auto s = [] { return Rational(uniform(0, 40), 20); };
    const Rational bend = uniform(0, 2) == 0 ? Rational(uniform(1, 4), 4) : Rational(0);
    const ContactProblem q = reduced({s(), s()}, {0}, roof(slope(), -slope(), bend), Rational(uniform(1, 400), 16));
    const ContactProblem p = uniform(0, 1) == 0 ? q : q.mirrored();
    const Attempt<double> attempt = riemann_hilbert<double>(p);
    const std::string why = attempt.solution->shortcoming();
    if (!why.empty()) {
      RC_ASSERT(why.find("the leading term") == 0U);
      return;
    }
    ++solved_ones;
    const auto& form = dynamic_cast<const RiemannHilbertSolution<double>&>(*attempt.solution).form();
    const ContactSet<double>& set = form.set();
    for (std::size_t j = 0; j <= set.segments(); ++j) {
      for (const Side side : {Side::left, Side::right}) {
        if (side == Side::left ? j == 0 : j == set.segments()) continue;
        const std::size_t k = side == Side::left ? j - 1 : j;
        if (!set.in_contact(k)) continue;
        const double d = 1e-300;
        const double rest = set.length(k) - d;
        const Estimate<double> t = form.traction(
            {static_cast<std::ptrdiff_t>(k), {set.x(j), side == Side::left ? rest : d, side == Side::left ? d : rest}});
        RC_ASSERT(t.value <= 4 * t.error);
      }
    }
  }));
  CHECK(solved_ones > 50);
}
