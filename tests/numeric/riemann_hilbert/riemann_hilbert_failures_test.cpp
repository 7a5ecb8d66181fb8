// Unsolved problems give a reason, and errors in a solution are noticed.

#include "numeric/closed_form/closed_form.hpp"
#include "numeric/flat_punch/flat_punch.hpp"
#include "numeric/riemann_hilbert/contact_inequalities.hpp"
#include "numeric/riemann_hilbert/gap_integral.hpp"
#include "numeric/variational/variational_inequality.hpp"
#include "support/solved_contact.hpp"

namespace {

using Set = ContactSet<double>;
using Form = TractionRepresentation<double>;

const ContactProblem on_two_wells = on_two_coatings(two_wells(), 3);

double missing_load(const Form& form) {
  const auto check = check_of(form);
  return std::abs(check.integral() + form.problem().load()) / form.problem().load();
}

template <Real R>
SearchResult<R> converged(const RoundedProblem<R>& problem, const ContactSet<R>& set, JacobiRules<R>& rules) {
  const std::vector<R> limits(set.segments(), R(1e-3));
  auto found = solve_newton(problem, ContactState<R>::initial(problem, set, R(0)), limits, rules);
  REQUIRE(found.status == NewtonResult<R>::Status::converged);
  return {std::move(found.state), {}, ""};
}

template <Real R>
TractionRepresentation<R> form_of(const RoundedProblem<R>& problem, const ContactState<R>& state,
                                  JacobiRules<R>& rules) {
  return {problem, state.set, state.q, state.tilt, rules};
}

}  // namespace

TEST_CASE("a search that leads nowhere ends with a condition that fails") {
  const ContactProblem p = reduced({0.3_r}, {}, one_piece(-1, 1, {0, 0, 1}), 1);
  const RoundedProblem<double> problem(p, {0, 1});
  JacobiRules<double> rules;
  // Free ends that are fixed at the support's ends cannot carry the load.
  Set set(problem, {{-0.5, 0.5, false, false}});
  set.attach_to_anchor(1, Side::left, true);
  set.attach_to_anchor(set.all(Set::Kind::ends).front(), Side::right, true);
  const auto found = search_contact(problem, ContactState<double>::initial(problem, set, 0), rules);
  CHECK(!found.solved());
  CHECK(!found.failed_condition.empty());
  const RiemannHilbertSolution<double> solution(p, {0, 1}, [&](const auto&, auto&) { return found; });
  CHECK(solution.failed_condition() == found.failed_condition);
}

TEST_CASE("a problem beyond double is refused with a reason, or left unsolved") {
  const auto reason = [](const Rational& s, const Rational& jump) {
    const Indenter wedge(-1, {{0, Polynomial({0, -0.2_r})}, {1, Polynomial({0, 0.2_r})}});
    return riemann_hilbert<double>(reduced({0.3_r, s}, {jump}, wedge, 1)).reason;
  };
  CHECK(reason(parse_rational("2e14"), 0).starts_with("friction too large for the Riemann-Hilbert method; "));
  CHECK(reason(1, parse_rational("1e-301")).starts_with("places too near for the Riemann-Hilbert method; "));
  CHECK(reason(parse_rational("9e13"), parse_rational("1e-299")) == "");
  CHECK(variational_inequality(reduced({parse_rational("1e400")}, {}, two_wells(), 1), {}).reason ==
        "friction too large for cells; gamma f is at most 1e308");
  // A number of 400 digits is infinite in double.
  const auto found = riemann_hilbert<double>(on_two_coatings(two_wells(), parse_rational("1e400"), 0.8_r));
  CHECK(found.solution->failed_condition() != "");
}

TEST_CASE("control: a displaced end is seen in the load, the equation and the closure of the gap") {
  const auto good = solved<double>(on_two_wells);
  const RoundedProblem<double>& problem = good->problem();
  JacobiRules<double> rules;
  REQUIRE(good->contact().size() == 2U);
  ContactState<double> state = good->state();
  CHECK(missing_load(good->form()) < 1e-13);
  const auto closure = [](const Form& form) {
    const std::size_t j = form.set().all(Set::Kind::ends).front();
    const GapIntegral<double> gap(form, j);
    return std::abs(gap.closure_error(gap.rule()).value);
  };
  CHECK(closure(good->form()) < 1e-13);
  const double equation = check_of(good->form()).equation();
  CHECK(equation < 1e-12);
  state.set.move({0, 1e-6, 0, 0});
  const Form displaced = form_of(problem, state, rules);
  CHECK(missing_load(displaced) > 1e-8);
  CHECK(closure(displaced) > 1e-8);
  // If the moments do not vanish, the form is not the Cauchy integral of its traction.
  CHECK(check_of(displaced).equation() > 1e-8);
}

TEST_CASE_TEMPLATE("control: a set of the wrong kind has violations", R, double, Real50) {
  using What = typename Violation<R>::What;
  struct Case {
    ContactProblem data;
    ContactInterval contact;
    What seen;
  };
  // One component instead of two: there is tension in the middle, or the other bump penetrates. Edges instead of free
  // ends: an inclined punch that is fixed at both ends has tension at one of them; the search repairs it.
  const Case cases[] = {{on_two_coatings(on_two_wells.indenter(), 4.5_r), {-1.5, 1.2, false, false}, What::tension},
                        {reduced({0.3_r}, {}, two_wells(0), 0.5_r), {-1.2, -0.8, false, false}, What::penetration},
                        {reduced({0.3_r}, {}, one_piece(-1, 1, {0, 1}), 0.5_r), {-1, 1, true, true}, What::tension}};
  for (const Case& c : cases) {
    JacobiRules<R> rules;
    const RoundedProblem<R> problem(c.data, {0, 1});
    const auto found = converged(problem, ContactSet<R>(problem, {c.contact}), rules);
    const auto seen = violations(form_of(problem, found.state, rules));
    REQUIRE(!seen.empty());
    CHECK(seen.front().what == c.seen);
    if (c.seen == What::penetration) CHECK(std::ranges::count(seen, c.seen, &Violation<R>::what) == std::ssize(seen));
    if (!c.contact.left_at_edge) continue;
    CHECK(seen.size() == 1);
    const auto repaired = search_contact(problem, found.state, rules);
    CHECK(repaired.solved());
    CHECK(violations(form_of(problem, repaired.state, rules)).empty());
  }
  const auto good = solved<R>(on_two_wells);
  CHECK(violations(good->form()).empty());
}

// The search checks the valley even if it is narrow compared with its segment.
TEST_CASE("a second bump on a support much wider than it") {
  const Rational a = 1000;
  const Indenter bumps(-100000, {{0, Polynomial({a * a, 2 * a, 1})}, {100000, Polynomial({a * a, -2 * a, 1})}});
  CHECK(solved<double>(reduced({0.3_r}, {}, bumps, 1))->contact().size() == 2U);
}

// Beyond the wedge, contact reaches less than a millionth of its length.
TEST_CASE("known limit: a wedge under large friction" * doctest::should_fail()) {
  solved<double>(reduced({8}, {}, roof(-1, 1), 0.1_r));
}

TEST_CASE("many values of friction: refused at once in more digits, solved in double") {
  std::vector<Rational> s, jumps;
  for (int k = 0; k < 10'000; ++k) {
    s.emplace_back(k % 7, 10);
    if (k > 0) jumps.emplace_back(2 * k - 10'000, 10'000);
  }
  const ContactProblem punch = reduced(s, jumps, one_piece(-1, 1, {0}), 1);
  const std::string reason =
      "too many values of friction for a solution by powers with more than 16 digits; there are at most 1000; 10000 "
      "values";
  CHECK(riemann_hilbert<Real50>(punch).reason == reason);
  CHECK(closed_form<Real50>(punch).reason == reason);
  const Resultants<double> powers = closed_form<double>(punch).solution->resultants();
  CHECK(std::abs(powers.normal.value - 1) <= powers.normal.error);
  // An independent computation: it uses no traction and no sum over many points.
  const double s_eff = EffectiveFriction<double>(FrictionLayout<double>::of(punch)).value().value;
  const double exact = s_eff / to_real<double>(punch.elasticity().gamma());
  CHECK(std::abs(powers.effective_friction.value - exact) < 1e-12 * exact);
  const auto cells = variational_inequality(punch).solution;
  CHECK(cells->failed_condition() == "");
  // Control: cells longer than the strips give a different number.
  CHECK(std::abs(cells->resultants().effective_friction.value - exact) > 1e-3 * exact);
}
