#include "checker/trapezoid.hpp"

#include <acb_hypgeom.h>
#include <arb_hypgeom.h>
#include <doctest/doctest.h>

#include <cmath>
#include <random>

#include "overlap.hpp"

namespace {

using namespace steadyslide::checker;

constexpr slong precision = 400;

/// Gamma(a + 1) Gamma(b + 1)/Gamma(a + b + 2) = int_0^1 x^a (1 - x)^b dx
Ball beta(const Ball& a, const Ball& b) {
  const auto gamma = [](const Ball& x) {
    Ball result = x;
    arb_gamma(result.get(), x.get(), precision);
    return result;
  };
  return gamma(a + Ball(1)) * gamma(b + Ball(1)) / gamma(a + b + Ball(2));
}

Ball rounded(double x) { return Ball(x).rounded(precision); }

Trapezoid::Panel unit_panel(const Ball& a, const Ball& b) {
  return {Ball(1).rounded(precision), {{Ball(), a}}, {{Ball(), b}}, Ball(1), Ball(1), 0};
}

/// Sum of the rule for f, widened by its error.
template <class F>
Ball integral(const Trapezoid& rule, const F& f, int more) {
  Ball sum, absolute;
  for (const Trapezoid::Node& node : rule.nodes()) {
    sum += node.weight * f(node);
    absolute += node.weight * f(node).size();
  }
  return sum.widened(rule.error(more, Ball(1), absolute));
}

}  // namespace

TEST_CASE("the rule encloses Euler's beta integral, with the width it promises") {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> exponent(-0.98, 1.5);
  for (const slong bits : {20, 60, 200}) {
    for (int k = 0; k < 10; ++k) {
      const Ball a = rounded(exponent(random));
      const Ball b = rounded(exponent(random));
      const Trapezoid rule(unit_panel(a, b), bits, precision);
      const Ball value = integral(
          rule, [](const auto&) { return Ball(1); }, 0);
      const Ball exact = beta(a, b);
      CAPTURE(a.text());
      CAPTURE(b.text());
      REQUIRE(value.is_finite());
      CHECK(overlap(value, exact));
      CHECK((exact * rounded(std::ldexp(1, 4 - static_cast<int>(bits))) - value.radius()).is_positive());
    }
  }
}

TEST_CASE("a point close to the panel needs no more nodes, and no wider ball") {
  // int_0^1 x^(-1/2) (x + d)^(-1/2) dx = 2 asinh(1/sqrt(d)); over (1 + x/d): 2 sqrt(d) atan(1/sqrt(d)) with a pole at -d
  for (const double d : {1.0, 1e-3, 1e-12, 1e-40}) {
    const Ball half = rounded(0.5);
    Trapezoid::Panel panel = unit_panel(-half, Ball());
    panel.left.push_back({rounded(d), -half});
    panel.left_reach = rounded(d);
    const Trapezoid rule(panel, 80, precision);
    const Ball root = sqrt(rounded(d));
    const Ball exact = Ball(2) * log((Ball(1) + sqrt(Ball(1) + rounded(d))) / root);
    const Ball value = integral(
        rule, [](const auto&) { return Ball(1); }, 0);
    CAPTURE(d);
    CHECK(rule.nodes().size() < 2500);
    CHECK(overlap(value, exact));
    CHECK((rounded(1e-20) - value.radius()).is_positive());

    Trapezoid::Panel square_root = unit_panel(-half, Ball());
    square_root.left_reach = rounded(d);
    const Trapezoid other(square_root, 80, precision);
    const auto pole = [&](const Trapezoid::Node& node) { return Ball(1) / (node.u + rounded(d)); };
    const Ball with_pole = integral(other, pole, 1);
    CHECK(overlap(with_pole, Ball(2) / root * atan(Ball(1) / root)));
    CHECK((with_pole * rounded(1e-20) - with_pole.radius()).is_positive());
  }
}

TEST_CASE("powers near -1 fall slowly, and need no more nodes for that") {
  const Ball a = rounded(-0.999);
  const Ball b = rounded(-0.5);
  const Trapezoid rule(unit_panel(a, b), 60, precision);
  CHECK(rule.nodes().size() < 1500);
  const Ball value = integral(
      rule, [](const auto&) { return Ball(1); }, 0);
  CHECK(overlap(value, beta(a, b)));
  CHECK((value * rounded(1e-16) - value.radius()).is_positive());
}

TEST_CASE("control: half the nodes, or a tail left out, is outside of the enclosure") {
  const Ball a = rounded(-0.5);
  const Trapezoid rule(unit_panel(a, a), 60, precision);
  const Ball exact = beta(a, a);
  Ball all, every_second, without_tail;
  for (std::size_t k = 0; k < rule.nodes().size(); ++k) {
    const bool right = k < rule.nodes_to_right();
    const bool tail = k + 1 == rule.nodes().size() || k + 1 == rule.nodes_to_right();
    const Ball& weight = rule.nodes()[k].weight;
    all += weight;
    if (k + 1 < rule.nodes().size()) without_tail += weight;
    if (tail) every_second += weight;
    if (!tail && (right ? k : k - rule.nodes_to_right() + 1) % 2 == 0) every_second += Ball(2) * weight;
  }
  const auto enclosed = [&](const Ball& sum) { return overlap(sum.widened(rule.error(0, Ball(1), sum)), exact); };
  CHECK(enclosed(all));
  CHECK_FALSE(enclosed(every_second));
  CHECK_FALSE(enclosed(without_tail));
}
