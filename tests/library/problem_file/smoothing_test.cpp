#include "library/problem_file/smoothing.hpp"

#include <boost/math/quadrature/gauss_kronrod.hpp>

#include "support/test.hpp"

using namespace steadyslide::library;

namespace {

using std::numbers::pi;

std::vector<double> equally_spaced(double left, double right, int points) {
  std::vector<double> x;
  for (int i = 0; i < points; ++i) x.push_back(left + (right - left) * i / (points - 1));
  return x;
}

std::vector<double> unequally_spaced(double left, double right, int points) {
  std::vector<double> x = equally_spaced(left, right, points);
  const double step = x[1] - x[0];
  for (std::size_t i = 1; i + 1 < x.size(); ++i) x[i] += 0.4 * step * std::sin(7.0 * static_cast<double>(i));
  return x;
}

template <class F>
std::vector<double> values(const std::vector<double>& x, const F& f) {
  std::vector<double> result;
  for (const double place : x) result.push_back(f(place));
  return result;
}

/// Returns int f s / int s over [left, right] around a place, by quadrature; s as ISO 16610-21 writes it.
template <class F>
double filtered_by_quadrature(const F& f, double left, double right, double place, double cutoff) {
  const double a = 0.46971863934983506;
  const auto s = [&](double x) { return std::exp(-pi * std::pow(x / (a * cutoff), 2)) / (a * cutoff); };
  const auto integral = [&](const auto& g) {
    using boost::math::quadrature::gauss_kronrod;
    return gauss_kronrod<double, 61>::integrate(g, std::max(left, place - 2 * cutoff),
                                                std::min(right, place + 2 * cutoff), 8, 1e-12);
  };
  return integral([&](double x) { return f(x) * s(x - place); }) / integral([&](double x) { return s(x - place); });
}

}  // namespace

TEST_CASE("Gaussian filter: the transmission of a sine is one half at the cutoff, and the exact formula elsewhere") {
  // Few points in half a cutoff are summed directly, many by interpolation.
  for (const int points : {401, 4001, 40001}) {
    const std::vector<double> x = equally_spaced(-10, 10, points);
    const double cutoff = 1;
    for (const double wavelength : {0.4, 0.7, 1.0, 1.6, 3.0}) {
      const auto sine = [&](double place) { return std::cos(2 * pi * place / wavelength); };
      const auto filtered = gauss_filtered(x, values(x, sine), cutoff);
      const double transmission = filtered[filtered.size() / 2];
      CAPTURE(points);
      CAPTURE(wavelength);
      CHECK(std::abs(transmission - std::exp(-pi * std::numbers::ln2 / pi * std::pow(cutoff / wavelength, 2))) < 1e-13);
      if (wavelength == cutoff) CHECK(std::abs(transmission - 0.5) < 1e-13);
      // The control: the roughness at the cutoff does not pass at the rate of another one.
      const auto other = gauss_filtered(x, values(x, sine), 1.001 * cutoff);
      CHECK(std::abs(other[filtered.size() / 2] - transmission) > 1e-5);
    }
  }
}

TEST_CASE("Gaussian filter: a constant stays, also at the ends and between unequal distances") {
  for (const int points : {3, 10, 500, 20000}) {
    const std::vector<double> x = unequally_spaced(2, 3, points);
    for (const double value : gauss_filtered(x, std::vector<double>(x.size(), 0.7), 0.8)) {
      CHECK(std::abs(value - 0.7) < 1e-13);
    }
  }
}

TEST_CASE("Gaussian filter: the sums agree with quadrature of the weight function, and interpolated with direct ones") {
  const auto f = [](double x) { return x * x + std::sin(5 * x) - 0.3 * std::cos(40 * x); };
  const std::vector<double> x = unequally_spaced(-1, 1, 20001);
  const double cutoff = 0.3;
  const auto filtered = gauss_filtered(x, values(x, f), cutoff);
  for (const std::size_t i : {0U, 1U, 700U, 9000U, 12345U, 19999U, 20000U}) {
    CAPTURE(x[i]);
    CHECK(std::abs(filtered[i] - filtered_by_quadrature(f, -1, 1, x[i], cutoff)) < 1e-6);
    // The same sums, one place at a time: all terms, with the weights of the trapezoidal rule.
    long double above = 0, below = 0;
    for (std::size_t k = 0; k < x.size(); ++k) {
      const long double length = (x[std::min(k + 1, x.size() - 1)] - x[k > 0 ? k - 1 : 0]) / 2;
      const long double u = (x[k] - x[i]) / cutoff;
      const long double weight = length * std::exp(-pi * pi / std::numbers::ln2 * static_cast<double>(u * u));
      above += weight * f(x[k]);
      below += weight;
    }
    CHECK(std::abs(filtered[i] - static_cast<double>(above / below)) < 2e-14);
  }
  // Controls: half the points have four times the error of the trapezoidal rule, far above that of the interpolation.
  CHECK(std::abs(filtered[9000] - filtered_by_quadrature(f, -1, 1, x[9000], 1.01 * cutoff)) > 1e-4);
}

TEST_CASE("spline: slopes of a line; second derivatives agree at the points and vanish at the ends") {
  REQUIRE(rc::check([] {
    const int pieces = uniform(2, 12);
    std::vector<double> h, d;
    for (int i = 0; i < pieces; ++i) {
      h.push_back(uniform(1, 1000) / 100.0);
      d.push_back(uniform(-1000, 1000) / 100.0);
    }
    const auto m = spline_slopes(h, d);
    RC_ASSERT(m.size() == h.size() + 1);
    // Second derivatives of the cubic polynomial of piece i at its ends.
    const auto at_left = [&](std::size_t i) { return (6 * d[i] - 4 * m[i] - 2 * m[i + 1]) / h[i]; };
    const auto at_right = [&](std::size_t i) { return (2 * m[i] + 4 * m[i + 1] - 6 * d[i]) / h[i]; };
    const double rounding = 1e-11 / *std::min_element(h.begin(), h.end());
    RC_ASSERT(std::abs(at_left(0)) < rounding);
    RC_ASSERT(std::abs(at_right(h.size() - 1)) < rounding);
    for (std::size_t i = 1; i < h.size(); ++i) RC_ASSERT(std::abs(at_left(i) - at_right(i - 1)) < rounding);
    for (const double slope : spline_slopes(h, std::vector<double>(h.size(), 0.3)))
      RC_ASSERT(std::abs(slope - 0.3) < 1e-14);
  }));
}

TEST_CASE("spline: away from the ends the error of slopes falls like the fourth power of the distance of points") {
  const auto error = [](int points) {
    const std::vector<double> x = equally_spaced(-1, 1, points);
    std::vector<double> h, d;
    for (std::size_t i = 1; i < x.size(); ++i) {
      h.push_back(x[i] - x[i - 1]);
      d.push_back((std::exp(x[i]) - std::exp(x[i - 1])) / h.back());
    }
    const auto slopes = spline_slopes(h, d);
    return std::abs(slopes[slopes.size() / 2] - 1);
  };
  const double rate = std::log2(error(81) / error(161));
  CAPTURE(rate);
  CHECK(rate > 3.9);
  CHECK(rate < 4.1);
}
