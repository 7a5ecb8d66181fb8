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

Exact term(LineSum::Kernel kernel, long double d) {
  const long double value = kernel == LineSum::Kernel::logarithm ? std::log(std::fabs(d))
                            : kernel == LineSum::Kernel::cauchy  ? -1 / d
                                                                 : 1 / std::fabs(d);
  const long double size = std::fabs(value);
  return {value, kernel == LineSum::Kernel::logarithm ? std::max(1.0L, size) : size};
}

/// Returns the sum over the sources, one by one, at a place of panel k, without the sources of omitted panels.
template <class Term>
Exact exact_sum(const Line& line, const std::vector<char>& left_out, std::size_t k, double from_left, double from_right,
                const Term& term) {
  Exact result;
  for (std::size_t i = 0; i < line.sources.size(); ++i) {
    if (left_out[line.sources[i].panel]) continue;
    const Exact one = term(offset(line, k, from_left, from_right, line.sources[i]));
    result.value += line.weights[i] * one.value;
    result.size += std::fabs(line.weights[i]) * one.size;
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
    std::vector<char> left_out(line.lengths.size(), 0);
    left_out[k] = 1;
    for (const auto& near : sum.near_to(k)) left_out[near.panel] = 1;
    for (const double part : {0.0, 1e-12, 0.2, 0.5, 1 - 1e-3, 1.0}) {
      const double left = part * line.lengths[k];
      const double right = line.lengths[k] - left;
      const Exact exact = exact_sum(line, left_out, k, left, right, [&](long double d) { return term(kernel, d); });
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
      const auto exact_of = [&](const auto& term) { return exact_sum(line, left_out, k, left, right, term); };
      const Exact exact = exact_of([&](long double d) { return term(kernel, d); });
      const Exact exact_rise = exact_of([&](long double d) { return Exact{std::log1p(step / d), 1}; });
      const double tolerance = rounding(kernel) * std::numeric_limits<double>::epsilon();
      CAPTURE(kind);
      REQUIRE(exact.size > 0);
      CHECK(std::fabs(value - exact.value) <= tolerance * exact.size);
      CHECK(std::fabs(rise - exact_rise.value) <= tolerance * exact_rise.size);
      // Control: the other sum differs.
      CHECK(std::fabs(value - exact_rise.value) > 1e-9 * exact.size);
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
