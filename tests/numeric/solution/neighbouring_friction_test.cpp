// A friction jump with two almost equal values. u_t' there is (f+ - f-) times an integral like 1/(f+ - f-): the error
// of the difference in double is a factor of it. Compared with 50 digits.

#include "numeric/closed_form/closed_form.hpp"
#include "numeric/riemann_hilbert/riemann_hilbert.hpp"
#include "support/numeric_test.hpp"
#include "support/problems.hpp"

namespace {

const Rational place = 0.1_r;

const Rational small_differences[] = {1e-4_r,  2e-7_r,   -3e-10_r, -3e-11_r, 2e-13_r,
                                      1e-15_r, -7e-17_r, 2e-19_r,  -2e-23_r, 1e-25_r};

ContactProblem on_neighbours(const Rational& difference, const Indenter& indenter, Sliding sliding) {
  const FrictionProfile friction({0.64_r, 0.64_r + difference}, {place});
  return {Elasticity::reduced(0.45_r), friction, indenter, 1, sliding};
}

/// Two polynomials of x - 1/10 that meet at 1/10.
Indenter meeting(const std::vector<Rational>& left, const std::vector<Rational>& right) {
  const auto moved = [](const std::vector<Rational>& coefficients) {
    return Polynomial(coefficients).composed(1, -place);
  };
  return {-1, {{place, moved(left)}, {1, moved(right)}}};
}

/// Compares the finite numbers of u_t' with 50 digits. Each is within its error, and the error is not much too large.
int compare(const ContactSolution<double>& found, const ContactSolution<Real50>& truth) {
  REQUIRE(found.failed_condition() == "");
  REQUIRE(truth.failed_condition() == "");
  int finite = 0;
  for (const Rational& x :
       {place, Rational(place - parse_rational("1e-9")), Rational(place + 0.001_r), 0.5_r, -0.3_r}) {
    CAPTURE(to_string(x));
    const TwoSided<double> here = found.details_at(x).shear_slope;
    const TwoSided<Real50> there = truth.details_at(x).shear_slope;
    for (const auto& [number, exact] : {std::pair(here.left, there.left), {here.right, there.right}}) {
      if (isinf(exact.value)) {
        CHECK(Real50(number.value) == exact.value);
        continue;
      }
      CHECK(within_error(number, exact));
      CHECK(number.error <= 2e-13 * std::max(std::abs(number.value), 0.1));
      ++finite;
    }
  }
  return finite;
}

}  // namespace

TEST_CASE("u_t' at a jump between neighbouring frictions: a flat punch, by two methods") {
  for (const Rational& difference : small_differences) {
    CAPTURE(to_string(difference));
    for (const Sliding sliding : {Sliding::plus_x, Sliding::minus_x}) {
      const ContactProblem p = on_neighbours(difference, one_piece(-1, 1, {0}), sliding);
      const auto truth = closed_form<Real50>(p).solution;
      // The pressure vanishes at the jump from the lower to the higher s, and is infinite at the other one.
      const bool vanishes = (difference > 0) == (sliding == Sliding::minus_x);
      CHECK(compare(*closed_form<double>(p).solution, *truth) == (vanishes ? 10 : 8));
      CHECK(compare(*riemann_hilbert<double>(p).solution, *truth) == (vanishes ? 10 : 8));
    }
  }
}

TEST_CASE("u_t' at a jump between neighbouring frictions, where the profile has a wedge or changes its curvature") {
  bool forward = false;
  for (const Rational& difference : small_differences) {
    CAPTURE(to_string(difference));
    forward = !forward;
    const Sliding sliding = forward ? Sliding::plus_x : Sliding::minus_x;
    const bool vanishes = (difference > 0) == (sliding == Sliding::minus_x);
    // If there is no wedge, the pressure is 0 where s rises, and the slope is finite there, even if double finds
    // different slopes at 1/10.
    const Indenter wedge = meeting({0, -0.2_r}, {0, 0.3_r, 1}), bent = meeting({0, 0, 0.25_r}, {0, 0, 1});
    const Indenter rounded = meeting({0, 0, 1}, {0, 0, Rational(-1, 3)});
    for (const auto& [indenter, finite] :
         {std::pair(&wedge, 8), {&bent, vanishes ? 10 : 8}, {&rounded, vanishes ? 10 : 8}}) {
      const ContactProblem p = on_neighbours(difference, *indenter, sliding);
      CHECK(compare(*riemann_hilbert<double>(p).solution, *riemann_hilbert<Real50>(p).solution) == finite);
    }
  }
}

TEST_CASE("u_t' where the pressure vanishes at a jump is the limit of u_t' beside it, also on a change of curvature") {
  for (const Indenter& indenter : {one_piece(-1, 1, {0}), meeting({0, 0, 0.25_r}, {0, 0, 1})}) {
    // beta = 0.26: at 1e-40 from the jump u_t' is 1e-10 from its limit.
    const ContactProblem p{Elasticity::reduced(0.45_r), FrictionProfile({0.1_r, 2.5_r}, {place}), indenter, 1,
                           Sliding::minus_x};
    const auto solution = riemann_hilbert<Real50>(p).solution;
    const TwoSided<Real50> limits = solution->details_at(place).shear_slope;
    const Rational d = parse_rational("1e-40");
    CHECK(abs(solution->details_at(place - d).shear_slope.left.value - limits.left.value) < 1e-8);
    CHECK(abs(solution->details_at(place + d).shear_slope.right.value - limits.right.value) < 1e-8);
    CHECK(abs(solution->details_at(place + 0.01_r).shear_slope.right.value - limits.right.value) > 1e-3);
  }
}
