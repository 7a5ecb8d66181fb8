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
  return {Ball(1).rounded(precision), {{a, {Ball()}, {}}, {b, {}, {Ball()}}}, Ball(1), Ball(1), 0};
}

/// Sum of the rule for f, widened by its error bound.
template <class F>
Ball integral(const Trapezoid& rule, int more, const F& f) {
  Ball sum, absolute;
  for (const Trapezoid::Node& node : rule.nodes()) {
    sum += node.weight * f(node);
    absolute += node.weight * f(node).size();
  }
  return sum.widened(rule.error(more, Ball(1), absolute));
}

Ball integral(const Trapezoid& rule) {
  return integral(rule, 0, [](const auto&) { return Ball(1); });
}

}  // namespace

TEST_CASE("the rule encloses Euler's beta integral, with the width it promises") {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> exponent(-0.98, 1.5);
  for (const slong bits : {20, 60, 200}) {
    for (int k = 0; k < 10; ++k) {
      const Ball a = rounded(exponent(random)), b = rounded(exponent(random));
      const Trapezoid rule(unit_panel(a, b), bits, precision);
      const Ball value = integral(rule), exact = beta(a, b);
      INFO("a = ", a.text(), ", b = ", b.text());
      REQUIRE(value.is_finite());
      CHECK(overlap(value, exact));
      CHECK((exact * rounded(std::ldexp(1, 4 - static_cast<int>(bits))) - value.radius()).is_positive());
    }
  }
}

TEST_CASE("the bound of the rule's error holds for an integrand that nearly reaches it") {
  // cos(2 pi tau/h) is 1 at every node, and cosh(2 pi d/h) on the rim of the strip: the nodes cannot distinguish it
  // from 1. With tau = log(x/(1 - x)), w = 2 pi/h:
  //   int_0^1 x^a (1-x)^b (x + D)^c cos(w tau) dx = Re D^c B(a+1+iw, b+1-iw) 2F1(-c, a+1+iw; a+b+2; -1/D)
  const double a = -0.75, b = -0.5, beyond = 0.25;
  for (const double c : {0.0, 2.0, -2.0, -6.0}) {
    Trapezoid::Panel panel = unit_panel(rounded(a), rounded(b));
    if (c != 0) panel.factors.push_back({rounded(c), {rounded(beyond)}, {}});
    const Trapezoid rule(panel, 30, precision);
    const Ball h = log(rule.nodes()[1].u / rule.nodes()[1].v);
    const Ball w = Ball(2) * Ball::pi(precision) / h;
    Ball d = Ball(1) / rule.secant();  // cos(d/2)
    arb_acos(d.get(), d.get(), precision);
    const Ball growth = exp(w * Ball(2) * d);
    const Ball M = (growth + Ball(1) / growth) * Ball(0.5);

    acb_t p, q, sum, value, other;
    for (acb_ptr z : {p, q, sum, value, other}) acb_init(z);
    acb_set_d_d(p, a + 1, 0);
    arb_set(acb_imagref(p), w.get());
    acb_set_d_d(q, b + 1, 0);
    arb_neg(acb_imagref(q), w.get());
    acb_set_d(sum, a + b + 2);
    acb_gamma(value, p, precision);
    acb_gamma(other, q, precision);
    acb_mul(value, value, other, precision);
    acb_rgamma(other, sum, precision);
    acb_mul(value, value, other, precision);
    acb_set_d(q, -c);
    acb_set_d(other, -1 / beyond);
    acb_hypgeom_2f1(other, q, p, sum, other, 0, precision);
    acb_mul(value, value, other, precision);
    Ball real = rounded(0);
    arb_set(real.get(), acb_realref(value));
    const Ball exact = real * power(rounded(beyond), rounded(c));
    for (acb_ptr z : {p, q, sum, value, other}) acb_clear(z);

    Ball all;
    for (const Trapezoid::Node& node : rule.nodes()) all += node.weight;
    const Ball error = rule.error(0, M, all);
    INFO("c = ", c, ": ", all.text(), " +- ", error.text(), " for ", exact.text());
    CHECK(overlap(all.widened(error), exact));
    if (c == 0) CHECK_FALSE(overlap(all.widened(error * rounded(0.1)), exact));
  }
}

TEST_CASE("a point close to the panel needs no more nodes, and no wider ball") {
  // int_0^1 x^(-1/2) (x + d)^(-1/2) dx = 2 asinh(1/sqrt(d)). With a pole at -d instead,
  // int_0^1 x^(-1/2)/(1 + x/d) dx = 2 sqrt(d) atan(1/sqrt(d)).
  for (const double d : {1.0, 1e-3, 1e-12, 1e-40}) {
    const Ball half = rounded(0.5);
    Trapezoid::Panel panel = unit_panel(-half, Ball());
    panel.factors.push_back({-half, {rounded(d)}, {}});
    panel.left_reach = rounded(d);
    const Trapezoid rule(panel, 80, precision);
    const Ball root = sqrt(rounded(d));
    const Ball exact = Ball(2) * log((Ball(1) + sqrt(Ball(1) + rounded(d))) / root);
    const Ball value = integral(rule);
    CAPTURE(d);
    CHECK(rule.nodes().size() < 2500);
    CHECK(overlap(value, exact));
    CHECK((rounded(1e-20) - value.radius()).is_positive());

    Trapezoid::Panel square_root = unit_panel(-half, Ball());
    square_root.left_reach = rounded(d);
    const Trapezoid other(square_root, 80, precision);
    const auto pole = [&](const Trapezoid::Node& node) { return Ball(1) / (node.u + rounded(d)); };
    const Ball with_pole = integral(other, 1, pole);
    CHECK(overlap(with_pole, Ball(2) / root * atan(Ball(1) / root)));
    CHECK((with_pole * rounded(1e-20) - with_pole.radius()).is_positive());
  }
}

TEST_CASE("powers near -1 fall slowly, and need no more nodes for that") {
  const Ball a = rounded(-0.999), b = rounded(-0.5);
  const Trapezoid rule(unit_panel(a, b), 60, precision);
  CHECK(rule.nodes().size() < 1500);
  const Ball value = integral(rule);
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
