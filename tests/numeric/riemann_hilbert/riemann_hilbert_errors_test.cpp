// Tests that an estimated error covers the true one, which is measured with more digits.

#include "known_limits/error_estimates.hpp"
#include "numeric/riemann_hilbert/contact_equations.hpp"
#include "support/random_contact.hpp"
#include "support/solved_contact.hpp"

namespace {

/// A wedge in the contact with two different slopes and a friction jump at its tip.
ContactProblem wedge_and_jump(const Rational& f_left, const Rational& f_right) {
  return {Elasticity(Solid(0.3_r, 1)), FrictionProfile({f_left, f_right}, {0}), roof(Rational(-1, 7), 0.1_r), 0.1_r};
}

template <Real R>
SolvedSingularPoint<R> corner(const ContactProblem& problem) {
  const auto solution = riemann_hilbert<R>(problem).solution;
  REQUIRE(solution);
  REQUIRE(solution->failed_condition() == "");
  for (const auto& point : solution->singular_points()) {
    if (point.kind == SingularKind::wedge_and_jump) return point;
  }
  throw std::logic_error("no wedge with a jump in the contact");
}

ContactProblem nearly_equal(const char* difference) {
  return wedge_and_jump(0.2_r, 0.2_r + parse_rational(difference));
}

/// D/[s] from the exact data.
Rational constant_of(const ContactProblem& problem) {
  const Rational jump = problem.coupled_friction(1) - problem.coupled_friction(0);
  return problem.indenter().breaks().front().wedge / (problem.elasticity().compliance() * jump);
}

template <Real R>
void check_constant(const SolvedSingularPoint<R>& found, const ContactProblem& problem) {
  using std::abs;
  const auto truth = to_real<Real100>(constant_of(problem));
  CHECK(abs(Real100(found.constant.value) - truth) <= Real100(found.constant.error));
  CHECK(found.constant.error <= 2 * numeric::epsilon<R>() * abs(found.constant.value));
}

/// Returns the solution with its free ends moved by `error`, which is also their estimated error. The other numbers are
/// unchanged, so its load and gaps are wrong as well: an error may be a quarter of the difference.
RiemannHilbertSolution<double> displaced(const ContactProblem& problem, std::size_t pattern, double error) {
  const Solved<double> rough = solved<double>(problem);
  const auto found = [&](const RoundedProblem<double>& reduced, JacobiRules<double>&) {
    const ContactState<double>& state = rough->state();
    ContactSet<double> set = ContactSet<double>::converted(reduced, state.set);
    std::vector<double> steps;
    for (std::size_t f = 0; f < set.movable().size(); ++f) steps.push_back((pattern >> f & 1U) == 0 ? error : -error);
    set.move(steps);
    return SearchResult<double>{{std::move(set), state.q, state.tilt}, {{error, 1, 1}}, ""};
  };
  return RiemannHilbertSolution<double>(problem, rough->problem().frame(), found);
}

std::vector<ContactProblem> with_free_ends() {
  const Indenter parabola = one_piece(-1, 1, {0, 0, 2.5_r});
  return {reduced({0.1_r, 0.6_r}, {0}, parabola, 1),
          reduced({0.6_r, 0.1_r}, {0}, parabola, 1),
          wedge_and_jump(0.2_r, 0.2_r),
          wedge_and_jump(0.2_r, 0.1_r),
          on_two_coatings(two_wells(), 8),
          on_two_coatings(two_wells(), 8, 0.1_r)};
}

}  // namespace

TEST_CASE("wedge and jump: the constant D/[s] and the intensity keep their digits at nearly equal frictions") {
  for (const char* difference : {"0.1", "1e-6", "1e-14", "-1e-14", "1e-20"}) {
    CAPTURE(difference);
    const ContactProblem problem = nearly_equal(difference);
    const auto found = corner<double>(problem);
    const auto truth = corner<Real50>(problem);
    check_constant(found, problem);
    check_constant(truth, problem);
    CHECK(within_error(found.intensity, truth.intensity));
    CHECK(found.intensity.error <= 1e-13 * std::abs(found.intensity.value));
    CHECK(truth.intensity.error <= Real50(1e-50) * abs(truth.intensity.value));
  }
  // The two values differ by more than rounded numbers of 50 digits show.
  const ContactProblem problem = nearly_equal("-1e-70");
  check_constant(corner<Real50>(problem), problem);
}

TEST_CASE("a wedge: intensity and constant of a singular point are those of the traction beside it") {
  for (const char* friction : {"0", "0.2", "0.9"}) {
    for (const char* further : {"0", "0.4"}) {  // without a friction jump, and with one
      CAPTURE(friction);
      CAPTURE(further);
      const Rational f = parse_rational(friction);
      const auto solution = riemann_hilbert<Real50>(wedge_and_jump(f + parse_rational(further), f)).solution;
      const std::vector<SolvedSingularPoint<Real50>> points = solution->singular_points();
      const auto corner =
          std::ranges::find_if(points, [](const auto& point) { return local_terms(point.kind).derivative == 1; });
      REQUIRE(corner != points.end());
      // At the distances d, 2d and 4d on the left; t = constant + intensity log(d)/pi, or constant + amplitude d^power.
      std::array<Real50, 3> t;
      for (std::size_t k = 0; k < 3; ++k) t[k] = solution->at(Rational(-(1 << k), 1000000000000)).traction.left.value;
      const auto near = [](const Real50& found, const Real50& expected) {
        return abs(found - expected) <= Real50(1e-9) * abs(expected);
      };
      if (local_terms(corner->kind).has_logarithm) {
        const Real50 intensity = (t[1] - t[0]) * pi<Real50>() / log(Real50(2));
        CHECK(near(corner->intensity.value, intensity));
        CHECK(near(corner->constant.value,
                   t[0] - intensity * log(to_real<Real50>(Rational(1, 1000000000000))) / pi<Real50>()));
      } else {
        CHECK(near(corner->constant.value, (t[0] * t[2] - t[1] * t[1]) / (t[0] + t[2] - 2 * t[1])));
      }
    }
  }
}

TEST_CASE("free ends: what they are off by is covered by every estimate") {
  for (const ContactProblem& problem : with_free_ends()) {
    const auto truth = riemann_hilbert<Real50>(problem).solution;
    REQUIRE(truth->failed_condition() == "");
    for (const std::size_t pattern : {0U, 1U, 2U}) {
      EstimateAudit audit;
      audit_solution("", problem, displaced(problem, pattern, 1e-8), *truth, false, audit);
      REQUIRE(audit.compared == 1U);
      std::string beyond_estimates;
      for (const std::string& line : audit.dishonest) beyond_estimates += line + '\n';
      INFO("pattern ", pattern, "; up to four times the estimate is right:\n", beyond_estimates);
      CHECK_FALSE(holds(beyond_estimates, "nan"));
      for (const auto& of_kind : audit.numbers) CHECK_MESSAGE(of_kind.second.worst <= 4, of_kind.first);
    }
  }
}

TEST_CASE("free ends: what they do to u' is in the error of u_t', f u' and more") {
  for (const ContactProblem& problem : with_free_ends()) {
    const RiemannHilbertSolution<double> found = displaced(problem, 1, 1e-8);
    // The ends of the support, and places in gaps, in contact and beside the support.
    for (const char* x : {"-1", "1", "-0.97", "0.93", "0.31", "-1.2", "1.3"}) {
      CAPTURE(x);
      const DetailedSample<double> there = found.details_at(parse_rational(x));
      if (there.traction.left.value == 0) CHECK(there.slope.left.error > 1e-10);
      const std::vector<Rational>& f = problem.friction().values();
      const double least =
          to_real<double>(*std::min_element(f.begin(), f.end())) * there.slope.left.error * (1 - 1e-12);
      CHECK(there.shear_slope.left.error >= least);
      CHECK(there.shear_slope.right.error >= least);
    }
  }
}

TEST_CASE("contact that ends 1e-96 beyond a break: the length between is known to a part of itself") {
  const ContactProblem problem = random_contact(20160262);
  const auto rough = riemann_hilbert<double>(problem).solution;
  CHECK(fault(*rough) == "");
  CHECK(rough->estimated_error().traction <= 1e-6);
  const auto exact = riemann_hilbert<Real50>(problem).solution;
  const ContactEnd<double> end = rough->contact().front().left;
  const ContactEnd<Real50> true_end = exact->contact().front().left;
  REQUIRE(end.kind == SingularKind::free);
  // It grows like the length to the power -0.976.
  CHECK(end.intensity.value > 1e93);
  CHECK(end.intensity.error < 1e-3 * end.intensity.value);
  CHECK(true_end.intensity.error < Real50(1e-20) * true_end.intensity.value);
  CHECK(within_error(end.intensity, true_end.intensity));
}

TEST_CASE("contact that ends 1e-12 beyond a break, at a gap over a notch: no step is left for Newton's method") {
  const Solved<double> found = solved<double>(random_contact(20165131, ContactFamily::many_wedges));
  const ContactSet<double>& set = found->state().set;
  ContactEquations<double> equations(found->form());
  REQUIRE(equations.solve());
  const std::vector<std::size_t> ends = set.movable();
  const std::vector<double> steps = equations.end_steps();
  double shortest = 1;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    CAPTURE(ends[i]);
    const double length = std::min(set.length(ends[i] - 1), set.length(ends[i]));
    CHECK(std::abs(steps[i]) <= 1e-11 * length);
    shortest = std::min(shortest, length);
  }
  CHECK(shortest < 1e-11);
}
