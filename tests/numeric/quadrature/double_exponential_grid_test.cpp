// The short grid of high precision, compared with integrals of known value, and with the trapezoidal grid.

#include "numeric/quadrature/double_exponential_grid.hpp"

#include "numeric/closed_form/closed_form.hpp"
#include "support/solved_contact.hpp"

namespace {

template <class R>
using Short = double_exponential::Grid<R>;

/// |a - b| is at most ten units of the last promised digit, relative to their size.
template <Real R>
bool agree(const R& a, const R& b, const R& part = R(0)) {
  return size_of(R(a - b)) <= pow(R(10), 1 - digits_served<R>) * std::max({size_of(a), size_of(b), size_of(part)});
}

template <Real R>
PiecewiseDensity<R> galin(const Rational& s) {
  const Exponent a = Exponent::angle(s);
  return {{Panel<R>{-1, 1, 2}, Power<R>::of(-half - a), Power<R>::of(-half + a), [](const Node<R>&) { return R(1); }}};
}

/// A flat punch on [-1, 1] with these jumps: its panels touch each other.
ContactProblem punch(std::vector<Rational> jumps) {
  std::vector<Rational> values;
  for (int k = 0; k <= static_cast<int>(jumps.size()); ++k) values.emplace_back((3 * k * k + 1) % 7, 5);
  return {Elasticity(Solid(0.3_r, 1)), FrictionProfile(values, std::move(jumps)), Indenter(-1, {{1, Polynomial({0})}}),
          1};
}

template <Real R>
PiecewiseDensity<R> traction_of(const ContactProblem& problem) {
  return std::get<ClosedFormData<R>>(closed_form_data<R>(problem)).traction.density();
}

/// The grid of a solution by Riemann-Hilbert. The solution has to live longer than the grid.
template <Real R>
PiecewiseDensity<R> solved_traction(const ContactSolution<R>& solution) {
  return traction_density(dynamic_cast<const RiemannHilbertSolution<R>&>(solution).form());
}

}  // namespace

TEST_CASE_TEMPLATE("Galin's weight: its integral is pi/cos(pi a), H of it -tan(pi a) times it", R, Real50, Real100) {
  for (const Rational& s : {0_r, Rational(1, 7), Rational(-5), 37_r}) {
    CAPTURE(to_string(s));
    const auto density = galin<R>(s);
    REQUIRE(Short<R>::suits(density));
    const Short<R> grid(density);
    const R expected = pi<R>() / cos_pi_alpha<R>(s);
    const Estimate<R> integral = grid.panel_integral(0);
    CHECK(agree(integral.value, expected));
    for (const double fraction : {double_exponential::nearest_place, 0.3, 0.5, 1 - double_exponential::nearest_place}) {
      const auto at = grid.midpoint_near(0, fraction);
      CHECK(agree(grid.hilbert(at), R(-to_real<R>(s) * density[0](at.node)), density[0](at.node)));
      // Control: the value at another midpoint differs (for s = 0 it is 0 at all of them).
      auto other = at;
      other.cell += 10;
      if (s != 0)
        CHECK(size_of(R(grid.hilbert(other) + to_real<R>(s) * density[0](at.node))) > R(1e-3) * density[0](at.node));
    }
  }
}

TEST_CASE_TEMPLATE("panels that touch, of very different lengths: the trapezoidal grid's values", R, Real50, Real100) {
  for (const std::vector<Rational>& jumps :
       {std::vector<Rational>{0_r}, {-0.9_r, 0.1_r, 0.101_r}, {Rational(-1) + 0.00001_r}}) {
    CAPTURE(jumps.size());
    const auto density = traction_of<R>(punch(jumps));
    REQUIRE(Short<R>::suits(density));
    const Short<R> grid(density);
    const trapezoidal::Grid<R> other(density);
    for (std::size_t k = 0; k < density.size(); ++k) {
      CHECK(grid.touches(k, Side::left) == (k > 0));
      CHECK(agree(grid.panel_integral(k).value, other.panel_integral(k)));
      const double fraction = double_exponential::nearest_beside_a_panel;
      for (const double place : {fraction, 0.4, 1 - fraction}) {
        const auto at = grid.midpoint_near(k, place);
        CHECK(agree(grid.hilbert(at), other.hilbert(at), density[k](at.node)));
      }
      CHECK(grid.highest() < 0);
    }
    for (const char* distance : {"1e-4", "0.3", "50"}) {
      const R d = to_real<R>(parse_rational(distance));
      for (const Side end : {Side::left, Side::right}) {
        const std::size_t k = end == Side::left ? 0 : density.size() - 1;
        const Estimate<double> rough = grid.rough_displacement(k, end, static_cast<double>(d));
        const double exact = static_cast<double>(other.displacement(k, end, d));
        CHECK(std::abs(rough.value - exact) <= rough.error);
        CHECK(rough.error <= 1e-10 * (1 + std::abs(exact)));
        CHECK_FALSE(std::abs(1.000001 * rough.value - exact) <= rough.error);
      }
    }
  }
}

TEST_CASE_TEMPLATE("a density that says it is constant is sampled alike, and says the truth", R, Real50, Real100) {
  const auto all_of_it = [](const PiecewiseDensity<R>& density) {
    const Short<R> grid(density);
    CHECK(grid.highest() < 0);
    std::vector<R> values{grid.panel_integral(0).value};
    for (const double place : {0.2, 0.5625, 0.8}) values.push_back(grid.hilbert(grid.midpoint_near(0, place)));
    return values;
  };
  const auto are_alike = [](const std::vector<R>& a, const std::vector<R>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), [](const R& x, const R& y) { return agree(x, y); });
  };
  const auto under = [](const Polynomial& profile) {
    return ContactProblem(Elasticity(Solid(0.3_r, 1)), FrictionProfile({0.4_r}, {}), Indenter(-9, {{9, profile}}), 1);
  };
  const ContactProblem parabola = under(Polynomial({0, 0, 1}));
  for (const ContactProblem& problem : {punch({}), parabola}) {
    const auto solved = riemann_hilbert<R>(problem).solution;
    for (PiecewiseDensity<R> density : {traction_of<R>(problem), solved_traction(*solved)}) {
      REQUIRE(density.size() == 1);
      REQUIRE(density[0].is_constant);
      const std::vector<R> quick = all_of_it(density);
      density[0].is_constant = false;
      CHECK(are_alike(quick, all_of_it(density)));
      // Small factors count; control: a factor that changes by 1e-20.
      const auto smooth = density[0].smooth;
      density[0] = scaled<R>(density[0], R("1e-300"));
      std::vector<R> tiny = all_of_it(density);
      for (R& value : tiny) value *= R("1e300");
      CHECK(are_alike(quick, tiny));
      density[0].smooth = [&](const Node<R>& node) { return R(smooth(node) * (1 + R("1e-20") * node.from_left)); };
      CHECK_FALSE(are_alike(quick, all_of_it(density)));
    }
  }
  CHECK_FALSE(traction_of<R>(punch({0_r}))[0].is_constant);
  const auto solved = riemann_hilbert<R>(under(Polynomial({0, 0, 0, 0, 1}))).solution;
  const auto density = solved_traction(*solved);
  CHECK(density.size() == 1);
  CHECK_FALSE(density[0].is_constant);
}

TEST_CASE("a panel billions of times as long as its neighbour is left to the trapezoidal grid") {
  const auto density = traction_of<Real50>(punch({Rational(-1) + Rational(1, 1'000'000'000)}));
  CHECK_FALSE(Short<Real50>::suits(density));
  CHECK_FALSE(Short<Real50>::suits(galin<Real50>(1e6_r)));
  CHECK_FALSE(Short<Real50>::suits({}));
}

TEST_CASE("control at 50 digits: a friction value, an amplitude or a power that is wrong leaves a large residual") {
  const ContactProblem problem = punch({-0.2_r, 0.5_r});
  std::vector<Real50> s;
  for (std::size_t k = 0; k < 3; ++k) s.push_back(to_real<Real50>(problem.coupled_friction(k)));
  const auto no_slope = [](std::size_t, const Node<Real50>&) { return Real50(0); };
  const auto equation = [&](const PiecewiseDensity<Real50>& density, const std::vector<Real50>& friction) {
    return SurfaceCheck<Real50>(density, friction, no_slope).equation();
  };
  const PiecewiseDensity<Real50> right = traction_of<Real50>(problem);
  CHECK(equation(right, s) < Real50("1e-48"));
  std::vector<Real50> wrong_s = s;
  wrong_s[1] *= Real50(1) + Real50("1e-20");
  CHECK(equation(right, wrong_s) > Real50("1e-22"));
  PiecewiseDensity<Real50> louder = right;
  louder[2] = scaled<Real50>(right[2], 1 + Real50("1e-20"));
  CHECK(equation(louder, s) > Real50("1e-22"));
  PiecewiseDensity<Real50> steeper = right;
  steeper[0].right.value += Real50("1e-20");
  steeper[0].right.plus_one += Real50("1e-20");
  CHECK(equation(steeper, s) > Real50("1e-23"));
}
