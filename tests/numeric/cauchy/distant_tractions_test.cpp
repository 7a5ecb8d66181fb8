// u_t' over many coatings, summed by cells, is compared with the trapezoidal rule on all panels, and with the field
// just below the surface.

#include <random>

#include "numeric/closed_form/closed_form.hpp"
#include "numeric/interior/interior_stress.hpp"
#include "numeric/quadrature/trapezoidal.hpp"
#include "numeric/riemann_hilbert/riemann_hilbert.hpp"
#include "support/solved_contact.hpp"

using namespace steadyslide;
using namespace steadyslide::numeric;

namespace {

/// Coatings of very different lengths on [-1, 1]; neighbours have different friction.
FrictionProfile coatings(int count) {
  std::minstd_rand random(7);
  std::vector<Rational> values, jumps;
  for (int k = 0; k <= count; ++k) {
    values.push_back(Rational(static_cast<int>(random() % 900), 1000));
    const Rational place = Rational(2 * k, count) - 1;
    if (k > 0 && k < count) jumps.push_back(place);
    // Next to one of them each length is half of the one before.
    if (k == count / 2) {
      for (int halving = 1; halving < 30; ++halving) {
        jumps.push_back(place + Rational(2, count) / (Integer(1) << (30 - halving)));
        values.push_back(Rational(static_cast<int>(random() % 900), 1000));
      }
    }
  }
  values.pop_back();
  return FrictionProfile(values, jumps);
}

ContactProblem punch() { return {Elasticity(Solid(0.2_r, 2)), coatings(140), Indenter(-1, {{1, Polynomial()}}), 1}; }

/// A parabola with free ends; some of the coatings are outside of the contact.
ContactProblem parabola() {
  return {Elasticity(Solid(0.2_r, 2)), coatings(180), Indenter(-1, {{1, Polynomial({0, 0, 1})}}), 1, Sliding::minus_x};
}

/// Two bumps with a gap between their contact zones.
ContactProblem bumps() {
  return {Elasticity(Solid(0.2_r, 2)), coatings(260),
          Indenter(-1, {{0, Polynomial({0.25_r, 1, 1})}, {1, Polynomial({0.25_r, -1, 1})}}), 0.1_r};
}

}  // namespace

TEST_CASE("u_t' by cells is what the trapezoidal rule makes of all panels, also between two jumps that are close") {
  for (const ContactProblem& problem : {punch(), parabola()}) {
    const auto data = std::get<ClosedFormData<double>>(closed_form_data<double>(problem));
    const auto solution = closed_form<double>(problem).solution;
    PiecewiseDensity<double> density = data.traction.density();
    for (std::size_t k = 0; k < density.size(); ++k) {
      const double ratio = to_real<double>(problem.shear_ratio(data.first_piece + k));
      density[k] = scaled<double>(density[k], ratio);
    }
    const trapezoidal::Grid<double> shear(density);
    const double c = to_real<double>(problem.elasticity().compliance());
    const double gamma = to_real<double>(problem.elasticity().gamma());
    std::vector<double> differences;
    double scale = 0;
    for (std::size_t k = 1; k + 1 < density.size(); k += 9) {
      const Rational left = data.origin + *data.exact[k], right = data.origin + *data.exact[k + 1];
      const Rational x = left + (right - left) * 0.3_r;
      const Node<double> node{to_real<double>(x - data.origin), to_real<double>(x - left), to_real<double>(right - x)};
      const double expected = c * (shear.hilbert({k, node}) + gamma * data.traction(k, node));
      const Estimate<double> found = solution->details_at(x).shear_slope.left;
      CHECK(found.error < 1e-10 * std::max(std::abs(expected), 1.0));
      differences.push_back(found.value - expected);
      scale = std::max(scale, std::abs(expected));
    }
    for (const double difference : differences) CHECK(std::abs(difference) < 1e-12 * scale);
  }
}

TEST_CASE("u_t' by cells is the slope just below the surface, also in a gap") {
  for (const ContactProblem& problem : {punch(), parabola(), bumps()}) {
    const auto solution = riemann_hilbert<double>(problem).solution;
    REQUIRE(solution->failed_condition().empty());
    const InteriorStress<double> interior(*solution);
    double scale = 0;
    std::vector<std::pair<double, double>> slopes;
    for (const char* place : {"-1.5", "-0.51", "-0.123", "0.0123", "0.003", "0.505", "1.7"}) {
      const Rational x = parse_rational(place);
      slopes.emplace_back(solution->details_at(x).shear_slope.right.value,
                          interior.at(x, parse_rational("1/1000000000000")).gradient->x_x.value);
      scale = std::max(scale, std::abs(slopes.back().second));
    }
    for (const auto& [found, expected] : slopes) CHECK(std::abs(found - expected) < 1e-8 * scale);
  }
}

TEST_CASE("|Y| over more points than vectors are for: as far from 50 digits as its errors say") {
  std::minstd_rand random(3);
  std::vector<double> lengths;
  std::vector<Power<double>> powers;
  for (int k = 0; k < 700; ++k) lengths.push_back(std::ldexp(1 + static_cast<double>(random() % 1000), -10));
  for (int j = 0; j <= 700; ++j) {
    const double p = static_cast<double>(random() % 1000) / 1250 - 0.4;
    powers.push_back({p, 1 + p});
  }
  const FundamentalSolution<double> y(0, lengths, powers);
  std::vector<Power<Real50>> same;
  for (const Power<double>& p : powers) same.push_back({Real50(p.value), 1 + Real50(p.value)});
  const FundamentalSolution<Real50> exact(Real50(0), {lengths.begin(), lengths.end()}, same);
  for (const std::size_t k : {0U, 1U, 350U, 699U}) {
    std::vector<double> left, right, values(3);
    for (const double part : {0x1p-40, 0.25, 1 - 0x1p-20}) {
      left.push_back(part * lengths[k]);
      right.push_back(lengths[k] - left.back());
    }
    y.moduli(k, left, right, values);
    for (std::size_t i = 0; i < values.size(); ++i) {
      const Real50 one = exact.modulus(k, {Real50(0), Real50(left[i]), Real50(right[i])});
      const double error = y.relative_error(k, {y.panel(k).left + left[i], left[i], right[i]}, 0);
      CHECK(static_cast<double>(size_of(Real50(values[i] / one - 1))) <= error);
      CHECK(error < 1e-11);
    }
  }
}
