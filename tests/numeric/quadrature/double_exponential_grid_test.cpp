// The short grid of high precision beside integrals with a known value, and beside the trapezoidal grid.

#include "numeric/quadrature/double_exponential_grid.hpp"

#include "numeric/cauchy/residuals.hpp"
#include "numeric/closed_form/closed_form.hpp"
#include "support/numeric_test.hpp"

namespace {

template <class R>
using Short = double_exponential::Grid<R>;

/// |a - b| at most ten units of the last digit that is served, relative to their size.
template <Real R>
bool agree(const R& a, const R& b, const R& part = R(0)) {
  return size_of(R(a - b)) <= pow(R(10), 1 - digits_served<R>) * std::max({size_of(a), size_of(b), size_of(part)});
}

template <Real R>
PiecewiseDensity<R> galin(const Rational& s) {
  const Exponent a = Exponent::angle(s);
  return {{Panel<R>{-1, 1, 2}, Power<R>::of(-half - a), Power<R>::of(-half + a), [](const Node<R>&) { return R(1); }}};
}

/// A flat punch on [-1, 1] with these jumps: panels that touch.
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
      // Control: the value at another midpoint is none here (of s = 0 it is 0 at all of them).
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
  louder[2].smooth = [smooth = right[2].smooth](const Node<Real50>& node) {
    return Real50(smooth(node) * (1 + Real50("1e-20")));
  };
  CHECK(equation(louder, s) > Real50("1e-22"));
  PiecewiseDensity<Real50> steeper = right;
  steeper[0].right.value += Real50("1e-20");
  steeper[0].right.plus_one += Real50("1e-20");
  CHECK(equation(steeper, s) > Real50("1e-23"));
}
