// Means of the logarithm over pairs of cells, compared with their exact formula at 100 digits.

#include <random>

#include "numeric/number/real.hpp"
#include "numeric/variational/surface_kernel.hpp"
#include "support/numeric_test.hpp"

using namespace steadyslide::numeric::variational;

namespace {

Real100 second_integral(const Real100& u) { return u == 0 ? Real100(0) : Real100(u * u / 2 * (log(abs(u)) - 1.5)); }

Real100 exact_mean(double a, double b, double c, double d) {
  const Real100 sum = second_integral(Real100(b) - c) - second_integral(Real100(b) - d) -
                      second_integral(Real100(a) - c) + second_integral(Real100(a) - d);
  return sum / ((Real100(b) - a) * (Real100(d) - c));
}

/// The relative error; absolute if the mean is below 1.
double error(double value, const Real100& exact) {
  const Real100 difference = abs(value - exact);
  return (difference / std::max(1.0, std::abs(value))).convert_to<double>();
}

struct Cells {
  double a, b, c, d;
};

/// Lengths and distances over eight decades. The first cell starts anywhere in the support.
Cells random_cells(std::mt19937& random, bool meet) {
  std::uniform_real_distribution<double> place(-0.5, 0.5), decades(-8, 0);
  const double a = place(random), b = a + std::pow(10, decades(random));
  const double c = meet ? b : b + std::pow(10, decades(random));
  return {a, b, c, c + std::pow(10, decades(random))};
}

}  // namespace

TEST_CASE("the mean logarithm over two cells is exact, however they lie") {
  std::mt19937 random(2016);
  double worst = 0, worst_of_centres = 0;
  for (int k = 0; k < 2000; ++k) {
    const auto [a, b, c, d] = random_cells(random, k % 3 == 0);
    for (const Cells& pair : {Cells{a, b, c, d}, Cells{c, d, a, b}, Cells{a, b, a, b}}) {
      const Real100 exact = exact_mean(pair.a, pair.b, pair.c, pair.d);
      worst = std::max(worst, error(mean_log(pair.a, pair.b, pair.c, pair.d), exact));
    }
    // Control: the logarithm of the centres' distance is not the mean.
    worst_of_centres = std::max(worst_of_centres, error(std::log((c + d - a - b) / 2), exact_mean(a, b, c, d)));
  }
  CHECK(worst <= 2e-15);
  CHECK(worst_of_centres > 0.1);
}

TEST_CASE("the mean logarithm is symmetric, additive, and takes a dilation's logarithm") {
  std::mt19937 random(36);
  for (int k = 0; k < 500; ++k) {
    const auto [a, b, c, d] = random_cells(random, k % 2 == 0);
    const double whole = mean_log(a, b, c, d);
    CHECK(mean_log(c, d, a, b) == whole);
    const double m = (c + d) / 2;
    const double parts = ((m - c) * mean_log(a, b, c, m) + (d - m) * mean_log(a, b, m, d)) / (d - c);
    CHECK(parts == doctest::Approx(whole).epsilon(3e-14));
    CHECK(mean_log(4 * a, 4 * b, 4 * c, 4 * d) == doctest::Approx(whole + std::log(4)).epsilon(3e-14));
  }
}

TEST_CASE("unit cells at any distance, to the last digits") {
  std::vector<std::size_t> distances;
  for (std::size_t k = 0; k < 200; ++k) distances.push_back(k);
  for (std::size_t k = 200; k <= 1000000; k += k / 7) distances.push_back(k);
  distances.push_back(1000000);
  for (std::size_t k : distances) {
    CAPTURE(k);
    const auto x = static_cast<double>(k);
    const Real100 exact = exact_mean(0, 1, x, x + 1);
    CHECK(error(mean_log_of_unit_cells(k), exact) <= 4e-16);
    // Control: one more term than log k changes the result until 1/(12 k^2) is below rounding.
    if (k > 0 && k < 100000) CHECK(error(std::log(x), exact) > 4e-16);
  }
}
