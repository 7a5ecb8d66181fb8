#include "proofs_checks/kit/rate.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "proofs_checks/instruments/convergence_cases.hpp"

using namespace steadyslide;
using namespace steadyslide::proofs_checks;

namespace {

std::vector<Level> levels(double rate, double scatter) {
  std::vector<Level> result;
  for (int k = 6; k <= 14; ++k) {
    const double cells = std::pow(2, k);
    result.push_back({cells, 3 * std::pow(cells, -rate) * (1 + (k % 2 == 0 ? scatter : -scatter))});
  }
  return result;
}

}  // namespace

TEST_CASE("a power is found, and the scatter shows in the error bar") {
  const Rate exact = fitted_rate(levels(1.5, 0));
  CHECK(exact.value == doctest::Approx(1.5));
  CHECK(exact.error_bar < 1e-7);
  const Rate scattered = fitted_rate(levels(1.5, 0.2));
  CHECK(std::abs(scattered.value - 1.5) < scattered.error_bar);
  CHECK(scattered.error_bar > 0.02);
  CHECK(scattered.error_bar < 0.06);
}

TEST_CASE("no rate from too few levels, or from an error that is none") {
  const std::vector<Level> two{{64, 1}, {128, 0.5}};
  CHECK(std::isnan(fitted_rate(two).value));
  for (const double error : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()}) {
    std::vector<Level> bad = levels(1, 0);
    bad[3].error = error;
    CHECK(std::isnan(fitted_rate(bad).value));
  }
}

TEST_CASE("the rate at each kind of singular point") {
  using Place = numeric::VariationalSolution::Place;
  const Rational low(1, 10);
  const Rational high(6, 5);
  const ContactProblem problem(Elasticity::reduced(Rational(1, 2)), FrictionProfile({low, high}, {0}),
                               Indenter(-1, {{1, Polynomial()}}), 1);
  const Rational s_left = problem.coupled_friction(0);
  const Rational s_right = problem.coupled_friction(1);
  const auto end = [&](SingularKind kind, const Exponent& exponent, Side contact, std::size_t piece) {
    return local_rate(problem, Place{0, kind, exponent, {0}, contact, piece, piece, -1, true});
  };
  CHECK(end(SingularKind::edge, edge_exponent(End::left, s_left), Side::right, 0) == doctest::Approx(1));
  CHECK(end(SingularKind::step, edge_exponent(End::right, s_right), Side::left, 1) == doctest::Approx(1));
  CHECK(end(SingularKind::free, free_exponent(End::left, s_left), Side::right, 0) == doctest::Approx(2));
  CHECK(end(SingularKind::free, free_exponent(End::right, s_right), Side::left, 1) == doctest::Approx(2));
  // With the other friction the powers would not add up.
  CHECK(end(SingularKind::free, free_exponent(End::right, s_right), Side::left, 0) != doctest::Approx(2));
  const Place jump{0, SingularKind::friction_jump, jump_exponent(s_left, s_right), {0}, Side::left, 0, 1, -1, true};
  CHECK(local_rate(problem, jump) == doctest::Approx(1));
  const Place wedge{0, SingularKind::wedge, std::nullopt, {0}, Side::left, 0, 0, 0, true};
  CHECK(local_rate(problem, wedge) == 3);
  CHECK(expected_rate(problem, std::vector<Place>{wedge, jump}) == doctest::Approx(1));
}
