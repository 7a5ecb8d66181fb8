// The approach on a rigid base: springs, two places of the contact, and cells.

#include "numeric/bodies/approach.hpp"

#include "numeric/bodies/body_contact.hpp"
#include "numeric/layers/body_kernel.hpp"
#include "numeric/variational/variational_inequality.hpp"
#include "support/numeric_test.hpp"
#include "support/problems.hpp"

namespace {

ContactProblem on_layer(const Rational& nu, std::vector<Rational> friction, const Indenter& indenter,
                        const Rational& thickness) {
  const Solid solid(nu, 2_r);
  std::vector<Rational> jumps;
  if (friction.size() > 1) jumps.push_back(0.1_r);
  return ContactProblem(Elasticity(solid), FrictionProfile(std::move(friction), std::move(jumps)), indenter, 1)
      .with_body(Body::layered({{thickness, solid}}, std::nullopt));
}

}  // namespace

TEST_CASE("the approach is that of springs on thin layers") {
  // p = K (delta - x^2/2), so delta = a^2/2 with the load 2/3 K a^3.
  const auto off = [](const Rational& thickness) {
    const ContactProblem problem = on_layer(0.2_r, {0}, one_piece(-2, 2, {0, 0, 0.5_r}), thickness);
    const auto cells = variational_inequality(problem, {.cells = 1 << 13}).solution;
    REQUIRE(cells);
    const double mu = 2 / 2.4, K = 2 * mu * 0.8 / 0.6 / to_real<double>(thickness), a = std::cbrt(1.5 / K);
    return approach(problem, *cells)->value / (a * a / 2) - 1;
  };
  const double thick = off(0.04_r), thin = off(0.01_r);
  CHECK(std::abs(thin) < 0.05);
  CHECK(std::abs(thick / thin) > 1.5);
}

TEST_CASE("the approach is the same by cells, and at two places by the integral of the kernel over the contact") {
  for (const auto& [nu, h] : {std::pair(0.3_r, 0.5_r), {0.45_r, 2_r}}) {
    const ContactProblem problem = on_layer(nu, {0.2_r, 0.6_r}, one_piece(-2, 2, {0, 0.1_r, 0.5_r}), h);
    const auto found = contact_on_body(problem).solution;
    const auto cells = variational_inequality(problem, {.cells = 2048}).solution;
    REQUIRE(found);
    REQUIRE(cells);
    const Estimate<double> delta = *approach(problem, *found), coarse = *approach(problem, *cells);
    CHECK(delta.error < 1e-8);
    CHECK(std::abs(delta.value - coarse.value) <= delta.error + coarse.error);
    CHECK(coarse.error < 1e-3);
    // -u/c = (1/pi) int p (N - log|x - x'|) + (int_-oo^x - int_x^oo) s p/2 + (1/pi) int f p T
    const BodyKernel<double> kernel(BodySymbols<double>(problem), 10);
    const double c = to_real<double>(problem.elasticity().compliance()),
                 gamma = to_real<double>(problem.elasticity().gamma());
    const double left = found->contact().front().left.x.value, right = found->contact().front().right.x.value;
    for (const double x : {-0.3, 0.4}) {
      double displacement = 0;
      constexpr double jump = 0.1;
      std::vector<double> ends{left, jump, right};
      ends.insert(std::lower_bound(ends.begin(), ends.end(), x), x);
      for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
        const double f = ends[k] < jump ? 0.2 : 0.6, side = ends[k] < x ? 1 : -1;
        // Powers and the logarithm at the ends: x' = a + L (3 v^2 - 2 v^3) and again.
        constexpr int count = 400;
        for (int i = 0; i < count; ++i) {
          double v = (i + 0.5) / count, weight = (ends[k + 1] - ends[k]) / count;
          for (int again = 0; again < 3; ++again) {
            weight *= 6 * v * (1 - v);
            v = v * v * (3 - 2 * v);
          }
          const double there = ends[k] + (ends[k + 1] - ends[k]) * v;
          if (there <= ends[k] || there >= ends[k + 1] || there == x) continue;
          const double p = -found->at(Rational(there)).traction.left.value, y = there - x;
          displacement +=
              weight * p *
              ((kernel.normal().at(y) - std::log(std::abs(y)) + f * kernel.coupling().at(y)) / std::numbers::pi +
               side * gamma * f / 2);
        }
      }
      CHECK(c * displacement + 0.1 * x + 0.5 * x * x == doctest::Approx(delta.value).epsilon(1e-8));
    }
  }
}

TEST_CASE("there is an approach on a rigid base alone") {
  const Solid solid(0.3_r, 2_r);
  const ContactProblem problem = on_layer(0.3_r, {0}, one_piece(-1, 1, {0, 0, 1}), 1);
  const auto found = contact_on_body(problem).solution;
  CHECK(approach(problem, *found));
  CHECK(!approach(problem.with_body({}), *found));
  CHECK(!approach(problem.with_body(Body::layered({{1, solid}}, solid)), *found));
}
