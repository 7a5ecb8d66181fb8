// Bounds of quadrature errors, compared with the errors. For each integrand one term dominates the error: a bound
// without that term, or with a hundredth of it, is too small.

#include "enclosure/quadrature/jacobi_rule.hpp"
#include "enclosure/quadrature/outside_points.hpp"
#include "enclosure/quadrature/trapezoidal.hpp"
#include "support/enclosure_test.hpp"

namespace {

/// Returns int_0^2 y^left (2-y)^right dy minus the rule's sum, and the rule's bound of that.
std::pair<Ball, Ball> trapezoidal_error(const Rational& left, const Rational& right, int degree, Bits bits) {
  constexpr Bits more = 256;
  const Ball l(left, more), r(right, more);
  const Trapezoidal rule(Ball(2, more), l, r, {}, std::nullopt, degree, bits);
  Ball sum(0, more);
  for (const Trapezoidal::Node& node : rule.nodes()) sum += node.weight;
  const Ball value =
      power(Ball(2, more), l + r + Ball(1)) * gamma(l + Ball(1)) * gamma(r + Ball(1)) / gamma(l + r + Ball(2));
  return {value - sum, rule.remainder(1)};
}

}  // namespace

TEST_CASE("the integral of T_2n by n nodes reaches a third of the remainder's bound") {
  const Bits bits = 200;
  for (const int n : {2, 7, 20}) {
    const JacobiRule rule(n, Ball(-0.5_r, bits), Ball(-0.5_r, bits), bits);
    Ball sum(0, bits);
    for (std::size_t i = 0; i < rule.size(); ++i) {
      sum += rule.weights[i] * chebyshev_polynomial(2 * n, rule.from_left[i] - Ball(1));
    }
    // The integral is 0; T_2n(cos z) = cos(2nz) is largest on the ellipse's axis.
    const Ball rho(5, bits);
    const Ball bound = rule.remainder((power(rho, 2 * n) + power(rho, -2 * n)) / 2, rho);
    CHECK(abs(sum) < bound);
    CHECK(abs(sum) > bound / 3);
  }
}

TEST_CASE("the trapezoidal rule: its error reaches a part of the bound that the strip alone makes") {
  for (const Bits bits : {4, 8, 16}) {
    CAPTURE(bits);
    // The degree is 0: the strip's bound dominates.
    const auto [error, bound] = trapezoidal_error(0, 0, 0, bits);
    CHECK(abs(error) < bound);
    CHECK(abs(error) > bound / 8);
  }
}

TEST_CASE("the trapezoidal rule: what is left out on either side is all but its bound") {
  for (const auto& [left, right] : {std::pair(0_r, 0_r), {-0.5_r, 0.3_r}, {1_r, -0.7_r}}) {
    // The integrand does not have this degree: the strip's bound is nearly zero.
    const auto [error, bound] = trapezoidal_error(left, right, 60, 30);
    CHECK_FALSE(error > bound);
    CHECK(error > bound * Ball(0.99_r, 64));
  }
}

TEST_CASE("a bound of powers of distances holds at both ends of the ellipse") {
  const Bits bits = 128;
  const Ball length(2, bits), reach(0.4_r, bits);
  for (const Side side : {Side::left, Side::right}) {
    for (const Rational& p : {-0.7_r, 0.7_r, -1_r, 2_r}) {
      const OutsideProduct product({{side, Ball(0.5_r, bits), Ball(p, bits)}});
      const Ball bound = product.bound(length, reach);
      const Ball nearly = reach * Ball(0.999_r, bits);
      CHECK(product.at(-nearly, length + nearly) < bound);
      CHECK(product.at(length + nearly, -nearly) < bound);
      CHECK(bound < Ball(1.001_r, bits) * max(product.at(-reach, length + reach), product.at(length + reach, -reach)));
    }
  }
}
