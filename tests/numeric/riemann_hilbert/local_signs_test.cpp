// The sign of the traction at anchors and at ends of contact: the rules are compared with values as near as possible,
// and with solutions below the load at which a notch closes.

#include "numeric/riemann_hilbert/local_signs.hpp"
#include "numeric/riemann_hilbert/contact_inequalities.hpp"
#include "support/solved_contact.hpp"

namespace {

/// psi = -|x|/5 over s = 0.0375 | 0.1875 is in full contact from this load on: there theta at 0 vanishes.
const Rational threshold = 8.308222888593932767_r;

/// A gap below that load P_c is as long as (1 - P/P_c)^(1/gap_power).
const double gap_power = (std::atan(3. / 16) - std::atan(3. / 80)) / std::numbers::pi;

ContactProblem notch(const Rational& part_of_threshold, bool mirrored = false) {
  const ContactProblem problem = reduced({0.0375_r, 0.1875_r}, {0}, roof(0.2_r, -0.2_r), part_of_threshold * threshold);
  return mirrored ? problem.mirrored() : problem;
}

/// Full contact with edges, for any traction.
template <Real R>
struct FullContact {
  explicit FullContact(const ContactProblem& p) : data(p), problem(data, {0, 1}) {
    auto state = ContactState<R>::initial(problem, ContactSet<R>(problem, {{-1, 1, true, true}}), R(0));
    found = {state, {}, ""};
    form.emplace(problem, state.set, state.q, state.tilt, rules);
  }
  ContactProblem data;
  RoundedProblem<R> problem;
  JacobiRules<R> rules;
  SearchResult<R> found{ContactState<R>{ContactSet<R>(problem), {}, R(0)}, {}, ""};
  std::optional<TractionRepresentation<R>> form;
};

/// Returns the lengths of the two halves of the gap over the notch.
double gap(const ContactSolution<double>& solution) {
  const auto zones = solution.contact();
  REQUIRE(zones.size() == 2U);
  CHECK(zones[0].right.x.value < 0);
  CHECK(zones[1].left.x.value > 0);
  return zones[1].left.x.value - zones[0].right.x.value;
}

}  // namespace

TEST_CASE("the rules against the traction at 10^-1000000 from the corner") {
  int pulls = 0, pushes = 0;
  CHECK(rc::check("full contact over any corner, any friction", [&] {
    const auto slope = [] { return Rational(uniform(-4, 4), 8); };
    const auto s = [] { return Rational(uniform(0, 8), 4); };
    const Rational bend = uniform(0, 2) == 0 ? 0_r : Rational(uniform(-4, 4), 4);
    const ContactProblem p = reduced({s(), s()}, {0}, roof(slope(), slope(), bend), Rational(uniform(1, 64), 4));
    const FullContact<Real50> full(p);
    for (std::size_t j = 0; j < 3; ++j) {
      const auto term = leading_term(*full.form, j);
      RC_ASSERT(term.has_value());
      if (term->sign == 0) continue;
      const Real50 d = pow(Real50(10), -1000000);
      for (const Side side : {Side::left, Side::right}) {
        if (j == (side == Side::left ? 0U : 2U)) continue;
        const Real50 t = full.form->traction(beside(full.form->set(), j, side, d)).value;
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
    const double nearer = gap(*solved<double>(notch(0.9999999_r, mirrored)));
    CHECK(std::log(last / nearer) / std::log(10) == doctest::Approx(1 / gap_power).epsilon(1e-5));
    const auto full = solved<double>(notch(1.000001_r, mirrored));
    REQUIRE(full->contact().size() == 1U);
    for (const auto& point : full->singular_points()) CHECK(point.intensity.value > 0);
  }
}

TEST_CASE("what is in contact where it pulls has an infinite tension, and a name") {
  const FullContact<double> full(notch(0.7_r));
  const auto seen = violations(*full.form);
  REQUIRE(seen.size() == 1U);
  CHECK(seen[0].what == Violation<double>::What::tension);
  CHECK(seen[0].anchor == 1U);
  const std::string words = in_words(*full.form, 1, *leading_term(*full.form, 1));
  CAPTURE(words);
  CHECK(words.find("x = 0 pulls: theta = -0.79") != std::string::npos);
  const auto full_contact = [](const RoundedProblem<double>& problem, JacobiRules<double>&) -> SearchResult<double> {
    return {{ContactSet<double>(problem, {{-1, 1, true, true}}), {problem.load()}, 0}, {}, ""};
  };
  const RiemannHilbertSolution<double> accepted(full.data, {0, 1}, full_contact);
  CHECK(accepted.residuals().tension == infinity<double>());
  // The same corner in a notch without a jump, and in one at which friction falls, for any load.
  for (const auto& s : {std::vector<Rational>{1, 1}, {1, 0.5_r}}) {
    const FullContact<double> other(reduced(s, {0}, roof(0.125_r, -0.125_r), 10));
    CHECK(leading_term(*other.form, 1)->sign == 1);
    CHECK(highest_limit(*other.form, 0.) > 0);
  }
}

TEST_CASE("the constant at a wedge is that of the exact jumps, of s and of the slope") {
  for (const char* difference : {"1e-3", "-1e-9", "3e-15", "1e-17", "-1e-25"}) {
    CAPTURE(difference);
    const Rational d = parse_rational(difference);
    // Falls of s under a wedge of any size; slopes whose difference is lost in double.
    for (const Rational& wedge : {0.125_r, parse_rational("1e-20")}) {
      const Rational s_right = 0.3_r - (d > 0 ? d : Rational(-d));
      const FullContact<double> full(reduced({0.3_r, s_right}, {0}, roof(0.125_r - wedge, 0.125_r), 4));
      const auto term = leading_term(*full.form, 1);
      REQUIRE(term);
      CHECK(term->kind == LeadingTerm<double>::Kind::constant);
      const double expected = to_real<double>(Rational(wedge / (s_right - 0.3_r)));
      CHECK(std::abs(term->coefficient.value - expected) <= term->coefficient.error);
      CHECK(term->coefficient.error <= 1e-15 * std::abs(expected));
      CHECK(term->sign == -1);
    }
  }
}

TEST_CASE("gaps over notches without a jump, however short") {
  for (const int load : {4, 8, 12}) {
    const auto found = riemann_hilbert<double>(
        reduced({1}, {}, Indenter(-1, {{0, Polynomial({0, 0.125_r, 1})}, {1, Polynomial({0, 0, 1})}}), load));
    CHECK(found.solution->failed_condition() == "");
    CHECK(found.solution->contact().size() == 2U);
    CHECK(found.solution->residuals().load < 1e-13);
    CHECK(found.solution->residuals().equation < 1e-10);
  }
}

TEST_CASE("a gap that double cannot hold has a place and an order of magnitude") {
  const ContactProblem pressed = reduced({0.5_r}, {}, roof(0.125_r, -0.125_r), 1000);
  const auto found = riemann_hilbert<double>(pressed);
  CHECK(found.solution->failed_condition() == "");
  CHECK(found.solution->contact().size() == 1U);
  CHECK(found.solution->residuals().tension == 0);
  const auto gaps = found.solution->unresolved_gaps();
  REQUIRE(gaps.size() == 1U);
  CHECK(gaps[0].x.value == 0);
  CHECK(gaps[0].log10_length < -1000);
  // 50 digits reach that near: full contact has tension within that length, and nowhere else.
  const FullContact<Real50> full(pressed);
  for (const Side side : {Side::left, Side::right}) {
    const auto pulls_at = [&](double log10_distance) {
      const Real50 d = pow(Real50(10), Real50(log10_distance));
      return full.form->traction(beside(full.form->set(), 1, side, d)).value > 0;
    };
    CHECK(pulls_at(gaps[0].log10_length - 1));
    CHECK_FALSE(pulls_at(gaps[0].log10_length + 1));
  }
}

TEST_CASE("an unresolved gap is as many times longer as all lengths and the load are") {
  const auto length = [](const Rational& scale) {
    const Rational half(1, 8);
    const Indenter corner(-scale, {{0, Polynomial({0, half})}, {scale, Polynomial({0, -half})}});
    const auto gaps = riemann_hilbert<double>(reduced({0.5_r}, {}, corner, 1000 * scale)).solution->unresolved_gaps();
    REQUIRE(gaps.size() == 1U);
    return gaps[0].log10_length;
  };
  CHECK(length(1000) - length(1) == doctest::Approx(3).epsilon(1e-6));
}

TEST_CASE("unresolved gaps go on with the law of those that have ends") {
  const double resolved = std::log10(gap(*solved<double>(notch(0.999999_r))));
  int unresolved = 0;
  for (const int nines : {12, 16, 20, 24}) {
    CAPTURE(nines);
    const Rational part = 1 - Rational(1, pow(Integer(10), static_cast<unsigned>(nines)));
    const auto solution = riemann_hilbert<double>(notch(part)).solution;
    if (solution->unresolved_gaps().empty()) continue;
    ++unresolved;
    const double expected = resolved - (nines - 6) / gap_power;
    CHECK(solution->unresolved_gaps()[0].log10_length == doctest::Approx(expected).epsilon(0.02));
  }
  CHECK(unresolved > 0);
}

TEST_CASE("50 digits beside a gap over a notch, on hundreds of octaves") {
  for (const auto& [part, mirrored] : {std::pair(0.9_r, true), {0.99_r, false}}) {
    const auto found = solved<Real50>(notch(part, mirrored));
    const auto residuals = found->residuals();
    CHECK(residuals.equation < 1e-50);
    CHECK(residuals.load < 1e-50);
    const auto rough = solved<double>(notch(part, mirrored));
    CHECK(static_cast<double>(found->resultants().effective_friction.value) ==
          doctest::Approx(rough->resultants().effective_friction.value).epsilon(1e-13));
  }
}

TEST_CASE("no solution of a random notch over a jump has a sign that is known to be wrong") {
  int solved_ones = 0;
  CHECK(rc::check("random slopes, frictions and loads", [&] {
    const auto slope = [] { return Rational(uniform(1, 16), 16); };
    const auto s = [] { return Rational(uniform(0, 40), 20); };
    const Rational bend = uniform(0, 2) == 0 ? Rational(uniform(1, 4), 4) : 0_r;
    const ContactProblem q = reduced({s(), s()}, {0}, roof(slope(), -slope(), bend), Rational(uniform(1, 400), 16));
    const ContactProblem p = uniform(0, 1) == 0 ? q : q.mirrored();
    const Attempt<double> attempt = riemann_hilbert<double>(p);
    const std::string why = attempt.solution->failed_condition();
    if (!why.empty()) {
      RC_ASSERT(why.find("the leading term") == 0U);
      return;
    }
    ++solved_ones;
    const auto& form = dynamic_cast<const RiemannHilbertSolution<double>&>(*attempt.solution).form();
    const ContactSet<double>& set = form.set();
    const auto unresolved = hairline_gaps(form, 0.);
    for (std::size_t k = 0; k < set.segments(); ++k) {
      if (!set.in_contact(k)) continue;
      for (const Side side : {Side::left, Side::right}) {
        const std::size_t j = side == Side::left ? k : k + 1;
        const auto is_here = [&](const auto& hairline) { return hairline.anchor == set.point(j).anchor; };
        if (std::ranges::any_of(unresolved, is_here)) continue;
        const Estimate<double> t = form.traction(beside(set, j, opposite(side), 1e-300));
        RC_ASSERT(t.value <= 4 * t.error);
      }
    }
  }));
  CHECK(solved_ones > 50);
}
