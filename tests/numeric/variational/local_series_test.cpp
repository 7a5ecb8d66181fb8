// Series fitted to cells with means in closed form.

#include "numeric/variational/local_fit.hpp"
#include "support/numeric_test.hpp"

using namespace steadyslide::numeric::variational;

namespace {

constexpr std::size_t count = 2000;
constexpr double length = 1. / count;

std::vector<double> edges(double shift) {
  std::vector<double> result;
  for (std::size_t i = 0; i <= count; ++i) result.push_back(shift + length * static_cast<double>(i));
  return result;
}

/// Means of d^power over cells that begin at 0.
double mean_power(std::size_t i, double power) {
  const double left = length * static_cast<double>(i);
  if (power == -1) return std::log((left + length) / left) / length;
  return (std::pow(left + length, power + 1) - std::pow(left, power + 1)) / ((power + 1) * length);
}

/// Means of -2 d^lambda (1 + 3 d) + 1e-3 d^(lambda - 1), if that is integrable.
std::vector<double> means(double lambda) {
  std::vector<double> result(count);
  for (std::size_t i = 1; i < count; ++i) {
    result[i] = -2 * mean_power(i, lambda) - 6 * mean_power(i, lambda + 1) + 1e-3 * mean_power(i, lambda - 1);
  }
  return result;
}

}  // namespace

TEST_CASE("bins hold the force of whole cells within the window, weighted down to its ends") {
  const std::vector<double> places = edges(2);
  std::vector<double> mean(count);
  for (std::size_t i = 0; i < count; ++i) mean[i] = std::sin(static_cast<double>(i));
  const Window window{0.0101, 0.7003};
  const std::vector<Bin> bins = gathered({places, mean}, 2, Side::right, window);
  REQUIRE(bins.size() > 20U);
  CHECK(bins.size() < 100U);
  CHECK(bins.front().near == doctest::Approx(21 * length));
  CHECK(bins.back().far <= window.to);
  double force = 0, expected = 0, largest = 0;
  for (std::size_t i = 0; i < bins.size(); ++i) {
    if (i > 0) CHECK(bins[i].near == bins[i - 1].far);
    CHECK(bins[i].weight > 0);
    largest = std::max(largest, bins[i].weight);
    force += bins[i].mean * (bins[i].far - bins[i].near);
  }
  for (auto i = 21; i < std::lround(bins.back().far / length); ++i) expected += length * std::sin(i);
  CHECK(force == doctest::Approx(expected).epsilon(1e-10));
  CHECK(bins.front().weight < 0.1 * largest);
  CHECK(bins.back().weight < 0.1 * largest);
  // Cells as long as their distance say too little. On the other side there are no cells.
  CHECK(gathered({places, mean}, 2, Side::right, {length, 0.5}).empty());
  CHECK(gathered({places, mean}, 2, Side::left, window).empty());
}

TEST_CASE("a series that holds the truth finds it") {
  const std::vector<double> places = edges(0);
  for (const double lambda : {-0.9, -0.3, 0., 0.4}) {
    CAPTURE(lambda);
    const std::vector<double> mean = means(lambda);
    const std::vector<Bin> bins = gathered({places, mean}, 0, Side::right, {10 * length, 0.9});
    const SeriesFit fit = fitted(bins, {.exponent = lambda, .poles = 1, .terms = 2}, lambda);
    CHECK(fit.amplitude == doctest::Approx(-2).epsilon(1e-9));
    CHECK(fit.first_pole == doctest::Approx(1e-3).epsilon(1e-8));
    CHECK(std::sqrt(fit.square) < 1e-9);
    // Fits without the pole, without the second term, or with another power fail.
    const SeriesFit wrong[] = {fitted(bins, {.exponent = lambda, .terms = 2}, lambda),
                               fitted(bins, {.exponent = lambda, .poles = 1, .terms = 0}, lambda),
                               fitted(bins, {.exponent = lambda + 0.01, .poles = 1, .terms = 2}, lambda)};
    for (const SeriesFit& other : wrong) CHECK(std::sqrt(other.square) > 1e-6);
  }
}

TEST_CASE("left and right are mirror images") {
  const std::vector<double> places = edges(0), mean = means(-0.3);
  std::vector<double> mirrored_places;
  for (const double x : places) mirrored_places.push_back(-x);
  std::reverse(mirrored_places.begin(), mirrored_places.end());
  const std::vector<double> mirrored(mean.rbegin(), mean.rend());
  const FittedExponent right = fitted_exponent({places, mean}, {0, 2, 1}, Side::right);
  const FittedExponent left = fitted_exponent({mirrored_places, mirrored}, {0, 1, 2}, Side::left);
  CHECK(right.exponent.value == doctest::Approx(-0.3).epsilon(1e-6));
  CHECK(left.exponent.value == doctest::Approx(right.exponent.value).epsilon(1e-9));
  const FittedIntensity theta = fitted_end({mirrored_places, mirrored}, {0, 1, 2}, Side::left, -0.3);
  CHECK(theta.intensity.value == doctest::Approx(2).epsilon(1e-8));
}

TEST_CASE("a peak so small that t grows over most of the window is seen") {
  const std::vector<double> places = edges(0);
  for (const double lambda : {-0.8, -0.66, -0.3}) {
    CAPTURE(lambda);
    std::vector<double> mean(count), without(count);
    for (std::size_t i = 1; i < count; ++i) {
      without[i] = -mean_power(i, lambda + 1);
      mean[i] = without[i] - 0.01 * mean_power(i, lambda);
    }
    const LocalPlace place{0, 2, 1};
    CHECK(fitted_exponent({places, mean}, place, Side::right).exponent.value == doctest::Approx(lambda).epsilon(1e-6));
    // The result is the next power if there is no peak.
    CHECK(fitted_exponent({places, without}, place, Side::right).exponent.value ==
          doctest::Approx(lambda + 1).epsilon(1e-6));
  }
}
