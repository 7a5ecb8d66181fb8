#include <random>

#include "proofs_checks/instruments/convergence/convergence_cases.hpp"
#include "proofs_checks/kit/rate.hpp"
#include "support/problems.hpp"

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

TEST_CASE("the error bar by hand: what three points leave over") {
  // log(error) at log(cells) = 1, 2, 3 is 5 - 2 log(cells) plus d, -2 d, d, which no line can fit. The remaining
  // squares add up to 6 d^2, one degree of freedom remains, and the squares of log(cells) about their mean add up to 2.
  for (const double d : {0.01, 0.25, -1.0}) {
    const auto level = [](double x, double y) { return Level{std::exp(x), std::exp(5 - 2 * x + y)}; };
    const Rate rate = fitted_rate(std::vector<Level>{level(1, d), level(2, -2 * d), level(3, d)});
    CHECK(rate.value == doctest::Approx(2).epsilon(1e-12));
    CHECK(rate.error_bar == doctest::Approx(std::sqrt(3) * std::abs(d)).epsilon(1e-12));
  }
}

TEST_CASE("the error bar covers the truth as often as Student's distribution says") {
  // Nine levels leave seven degrees of freedom: the chance to be within one standard deviation is 0.6494, within two
  // 0.9144.
  std::mt19937_64 engine(2016);
  const auto uniform = [&] { return (static_cast<double>(engine() >> 11) + 0.5) / 9007199254740992.0; };
  const auto normal = [&] { return std::sqrt(-2 * std::log(uniform())) * std::cos(2 * std::numbers::pi * uniform()); };
  constexpr int trials = 20000;
  int within_one = 0, within_two = 0;
  for (int k = 0; k < trials; ++k) {
    std::vector<Level> noisy = levels(1.5, 0);
    for (Level& level : noisy) level.error *= std::exp(0.1 * normal());
    const Rate rate = fitted_rate(noisy);
    within_one += std::abs(rate.value - 1.5) < rate.error_bar ? 1 : 0;
    within_two += std::abs(rate.value - 1.5) < 2 * rate.error_bar ? 1 : 0;
  }
  const auto deviation = [](double chance) { return std::sqrt(chance * (1 - chance) / trials); };
  CHECK(std::abs(within_one / static_cast<double>(trials) - 0.6494) < 4 * deviation(0.6494));
  CHECK(std::abs(within_two / static_cast<double>(trials) - 0.9144) < 4 * deviation(0.9144));
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
  using SingularPlace = numeric::VariationalSolution::SingularPlace;
  const ContactProblem problem = reduced({0.05_r, 0.6_r}, {0}, one_piece(-1, 1, {}), 1);
  const Rational s_left = problem.coupled_friction(0), s_right = problem.coupled_friction(1);
  const auto end = [&](SingularKind kind, const Exponent& exponent, Side contact, std::size_t piece) {
    return local_rate(problem, SingularPlace{0, kind, exponent, {0}, contact, piece, piece, -1, true});
  };
  CHECK(end(SingularKind::edge, edge_exponent(End::left, s_left), Side::right, 0) == doctest::Approx(1));
  CHECK(end(SingularKind::step, edge_exponent(End::right, s_right), Side::left, 1) == doctest::Approx(1));
  CHECK(end(SingularKind::free, free_exponent(End::left, s_left), Side::right, 0) == doctest::Approx(2));
  CHECK(end(SingularKind::free, free_exponent(End::right, s_right), Side::left, 1) == doctest::Approx(2));
  // With the friction of the other side the powers would not add up.
  CHECK(end(SingularKind::free, free_exponent(End::right, s_right), Side::left, 0) != doctest::Approx(2));
  const SingularPlace jump{0,   SingularKind::friction_jump, jump_exponent(s_left, s_right), {0}, Side::left, 0, 1, -1,
                           true};
  CHECK(local_rate(problem, jump) == doctest::Approx(1));
  const SingularPlace wedge{0, SingularKind::wedge, std::nullopt, {0}, Side::left, 0, 0, 0, true};
  CHECK(local_rate(problem, wedge) == 3);
  CHECK(expected_rate(problem, std::vector<SingularPlace>{wedge, jump}) == doctest::Approx(1));
}
