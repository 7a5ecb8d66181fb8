// The method that `auto` chooses.

#include "library/solve/method.hpp"

#include "support/problems.hpp"
#include "support/test.hpp"

using namespace steadyslide::library;

namespace {

/// Points of the parabola x^2/4 on [-0.3, 0.3]. Between two places every second point is slightly higher: this makes
/// concave corners.
ContactProblem trace(const Rational& from, const Rational& to, const Rational& load, int points = 300) {
  const Rational step(6, 10 * points);
  const auto place = [&](int i) { return Rational(i * step - Rational(3, 10)); };
  const auto height = [&](int i) {
    const Rational x = place(i);
    return Rational(x * x / 4 + (i % 2 == 1 && from < x && x < to ? step * step / 2 : Rational(0)));
  };
  std::vector<Indenter::Piece> pieces;
  for (int i = 1; i <= points; ++i) {
    const Rational slope = (height(i) - height(i - 1)) / (place(i) - place(i - 1));
    pieces.push_back({place(i), Polynomial({height(i) - slope * place(i), slope})});
  }
  return reduced({0.1_r}, {}, Indenter(place(0), pieces), load);
}

bool takes_cells(const ContactProblem& problem, bool certify = false, int digits = 16) {
  return takes_variational(Method::automatic, problem, certify, digits);
}

}  // namespace

TEST_CASE("auto takes cells for a gap over each of many corners in the contact") {
  const Rational load = 0.01_r;
  const ContactProblem under = trace(-0.05_r, 0.05_r, load);
  CHECK(takes_cells(under));
  CHECK_FALSE(takes_cells(under, false, 17));
  const ContactProblem fewer = trace(-0.05_r, 0.05_r, load, 190);
  CHECK(takes_cells(fewer));
  CHECK_FALSE(takes_cells(fewer, true));
  CHECK(takes_variational(Method::variational, under, true));
  CHECK_FALSE(takes_variational(Method::riemann_hilbert, under, false));
}

TEST_CASE("auto keeps the Riemann-Hilbert method for few corners in the contact, however many lie beside it") {
  const Rational load = 0.01_r;
  CHECK_FALSE(takes_cells(trace(-0.015_r, 0.015_r, load)));
  CHECK_FALSE(takes_cells(trace(0.15_r, 0.28_r, load)));
  CHECK_FALSE(takes_cells(trace(0, 0, load)));
  // With more than a hundred corners no prediction is made.
  CHECK(takes_cells(trace(-0.3_r, 0.3_r, load)));
}

TEST_CASE("auto counts no kinks at rounding level, as the coefficients of a spline have them") {
  std::vector<Indenter::Piece> pieces;
  Rational height = 0;
  for (int k = 1; k <= 60; ++k) {
    const Rational from = Rational(k - 31, 100), to = Rational(k - 30, 100);
    const Rational slope = k % 2 == 0 ? Rational(1, Integer("10000000000000000")) : 0_r;
    pieces.push_back({to, Polynomial({height - slope * from, slope, 0.25_r})});
    height += slope * (to - from);
  }
  CHECK_FALSE(takes_cells(reduced({0.1_r}, {}, Indenter(Rational(-3, 10), pieces), 0.01_r)));
}
