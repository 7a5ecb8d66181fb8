#include "numeric/hierarchical/line_sum.hpp"

#include <cmath>
#include <limits>

#include "tests/numeric/hierarchical/crowded_line.hpp"

namespace steadyslide::numeric::hierarchical {
namespace {

struct Exact {
  long double value = 0;
  long double size = 0;
};

Exact exact_far(const Line& line, const LineSum& sum, LineSum::Kernel kernel, std::size_t k, double from_left,
                double from_right) {
  std::vector<char> left_out(line.lengths.size(), 0);
  left_out[k] = 1;
  for (const auto& near : sum.near_to(k)) left_out[near.panel] = 1;
  Exact result;
  for (std::size_t i = 0; i < line.sources.size(); ++i) {
    if (left_out[line.sources[i].panel]) continue;
    const long double d = offset(line, k, from_left, from_right, line.sources[i]);
    const bool logarithm = kernel == LineSum::Kernel::logarithm;
    const long double term = logarithm                           ? std::log(std::fabs(d))
                             : kernel == LineSum::Kernel::cauchy ? -1 / d
                                                                 : 1 / std::fabs(d);
    result.value += line.weights[i] * term;
    result.size += std::fabs(line.weights[i]) * (logarithm ? std::max(1.0L, std::fabs(term)) : std::fabs(term));
  }
  return result;
}

double worst_error(int kind, LineSum::Kernel kernel, double wrong_length) {
  const Line line = line_of(kind);
  std::vector<double> lengths = line.lengths;
  lengths[lengths.size() / 2] += wrong_length;
  const LineSum sum({kernel}, lengths, line.sources, {line.weights});
  double worst = 0;
  for (std::size_t k = 0; k < line.lengths.size(); ++k) {
    for (const double part : {0.0, 1e-12, 0.2, 0.5, 1 - 1e-3, 1.0}) {
      const double left = part * line.lengths[k];
      const double right = line.lengths[k] - left;
      const Exact exact = exact_far(line, sum, kernel, k, left, right);
      if (exact.size == 0) continue;
      const auto error = static_cast<double>(std::fabs(sum.far(0, k, left, right) - exact.value) / exact.size);
      worst = std::max(worst, error / std::numeric_limits<double>::epsilon());
    }
  }
  return worst;
}

double rounding(LineSum::Kernel kernel) {
  return kernel == LineSum::Kernel::logarithm ? logarithm_rounding : cauchy_rounding;
}

constexpr LineSum::Kernel kernels[]{LineSum::Kernel::logarithm, LineSum::Kernel::cauchy, LineSum::Kernel::distance};

TEST_CASE("far sums are those of the sources, one by one, to rounding") {
  for (int kind = 0; kind < 5; ++kind) {
    for (const LineSum::Kernel kernel : kernels) {
      CAPTURE(kind);
      CAPTURE(static_cast<int>(kernel));
      CHECK(worst_error(kind, kernel, 0) <= rounding(kernel));
    }
  }
}

TEST_CASE("control: one panel longer by 1e-12 is noticed") {
  for (const LineSum::Kernel kernel : kernels) CHECK(worst_error(0, kernel, 1e-12) > 10 * rounding(kernel));
}

TEST_CASE("cells at one place: beyond the line, around a panel, and rises") {
  for (int kind = 0; kind < 5; ++kind) {
    const Line line = line_of(kind);
    for (const LineSum::Kernel kernel : kernels) {
      const LineSum sum({kernel}, line.lengths, line.sources, {line.weights});
      const std::size_t k = line.lengths.size() / 2;
      const double left = line.lengths[k] / 4;
      const double right = line.lengths[k] - left;
      const double step = line.lengths[k] / 8;
      double value = 0;
      double rise = 0;
      std::vector<char> left_out(line.lengths.size(), 0);
      left_out[k] = 1;
      const auto takes = [&](std::size_t cell, Side side, double distance) {
        const double moved = side == Side::left ? step : -step;
        if (!sum.tree().is_far(cell, distance) || !sum.tree().is_far(cell, distance + moved)) return false;
        value += sum.of_cell(0, cell, side, distance);
        rise += sum.logarithmic_rise(0, cell, side, distance, moved);
        return true;
      };
      sum.tree().around(k, left, right, takes, [&](std::size_t panel, double, Side) { left_out[panel] = 1; });
      long double exact = 0, exact_rise = 0, size = 0, rise_size = 0;
      for (std::size_t i = 0; i < line.sources.size(); ++i) {
        if (left_out[line.sources[i].panel]) continue;
        const long double d = offset(line, k, left, right, line.sources[i]);
        const long double term = kernel == LineSum::Kernel::logarithm ? std::log(std::fabs(d))
                                 : kernel == LineSum::Kernel::cauchy  ? -1 / d
                                                                      : 1 / std::fabs(d);
        exact += line.weights[i] * term;
        exact_rise += line.weights[i] * std::log1p(step / d);
        size += std::fabs(line.weights[i]) * std::max(1.0L, std::fabs(term));
        rise_size += std::fabs(line.weights[i]);
      }
      CAPTURE(kind);
      REQUIRE(size > 0);
      CHECK(std::fabs(value - exact) <= rounding(kernel) * std::numeric_limits<double>::epsilon() * size);
      CHECK(std::fabs(rise - exact_rise) <= rounding(kernel) * std::numeric_limits<double>::epsilon() * rise_size);
      CHECK(std::fabs(value - exact_rise) > 1e-9 * size);  // control: the other sum is another number
    }
  }
}

TEST_CASE("near panels and pairs of cells grow like the number of panels") {
  for (int kind = 0; kind < 5; ++kind) {
    const Line line = line_of(kind);
    const LineSum sum({LineSum::Kernel::logarithm}, line.lengths, line.sources, {line.weights});
    std::size_t near = 0, far = 0;
    for (std::size_t k = 0; k < line.lengths.size(); ++k) near += sum.near_to(k).size();
    for (std::size_t c = 0; c < sum.tree().cells().size(); ++c) far += sum.tree().far_from(c).size();
    CAPTURE(kind);
    CHECK(near < 20 * line.lengths.size());
    CHECK(far < 20 * line.lengths.size());
  }
}

}  // namespace
}  // namespace steadyslide::numeric::hierarchical
