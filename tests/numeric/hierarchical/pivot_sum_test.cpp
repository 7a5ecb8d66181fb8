#include "numeric/hierarchical/pivot_sum.hpp"

#include <cmath>
#include <limits>
#include <numeric>

#include "numeric/hierarchical/line_sum.hpp"
#include "tests/numeric/hierarchical/crowded_line.hpp"

namespace steadyslide::numeric::hierarchical {
namespace {

using PanelPoint = PivotSum::PanelPoint;

/// Returns a place in panel k at the fraction `part` of its length.
PanelPoint place_in(const Line& line, std::ptrdiff_t k, double part) {
  const double left = part * line.lengths[static_cast<std::size_t>(k)];
  return {k, left, line.lengths[static_cast<std::size_t>(k)] - left};
}

long double offset(const Line& line, const PanelPoint& place, const Source& source) {
  return offset(line, static_cast<std::size_t>(place.panel), place.from_left, place.from_right, source);
}

/// Returns x - e for places in the panels first..end-1.
double between(const Line& line, const PanelPoint& x, const PanelPoint& e) {
  if (x.panel == e.panel) return x.from_left < x.from_right ? x.from_left - e.from_left : e.from_right - x.from_right;
  if (x.panel < e.panel) return -between(line, e, x);
  double sum = e.from_right;
  for (auto k = static_cast<std::size_t>(e.panel) + 1; k < static_cast<std::size_t>(x.panel); ++k) {
    sum += line.lengths[k];
  }
  return sum + x.from_left;
}

struct Sum {
  long double value = 0;
  long double size = 0;
};

Sum term(double weight, long double to_x, long double to_pivot, int sigma) {
  // to_x = x - c, to_pivot = e - c.
  const long double factor = sigma == 0 ? 1 : sigma > 0 ? -1 / to_pivot : -to_pivot;
  return {-weight * factor / to_x, std::fabs(weight * factor / to_x)};
}

/// Returns the difference between the sum by cells plus its near panels and the sum of all sources one by one, in
/// roundings of its sizes.
double error_of(const Line& line, const PivotSum& sum, const PanelPoint& x, const PanelPoint& e, int sigma,
                const PivotSum::PanelRange& without, double wrong_offset = 0) {
  std::vector<double> sums(sum.sums(), 0);
  Sum near, exact;
  const auto panel_of = [&](std::size_t i) { return line.sources[i].panel; };
  sum.around({x, e, between(line, x, e) + wrong_offset, sigma}, without, sums,
             [&](std::size_t panel, double to_x, double to_pivot) {
               CHECK((panel < without.first || panel >= without.end));
               const bool is_left = panel < without.first;
               for (std::size_t i = 0; i < line.sources.size(); ++i) {
                 if (panel_of(i) != panel) continue;
                 const double more = is_left ? line.sources[i].from_right : line.sources[i].from_left;
                 const int sign = is_left ? 1 : -1;
                 const Sum one = term(line.weights[i], sign * (to_x + static_cast<long double>(more)),
                                      sign * (to_pivot + static_cast<long double>(more)), sigma);
                 near.value += one.value;
                 near.size += one.size;
               }
             });
  for (std::size_t i = 0; i < line.sources.size(); ++i) {
    if (panel_of(i) >= without.first && panel_of(i) < without.end) continue;
    const Sum one = term(line.weights[i], offset(line, x, line.sources[i]), offset(line, e, line.sources[i]), sigma);
    exact.value += one.value;
    exact.size += one.size;
  }
  if (exact.size == 0) return 0;
  // The last sum is the sum of sizes.
  if (wrong_offset == 0) CHECK(static_cast<double>(std::fabs(sums[1] + near.size - exact.size) / exact.size) < 1e-13);
  return static_cast<double>(std::fabs(sums[0] + near.value - exact.value) / exact.size) /
         std::numeric_limits<double>::epsilon();
}

PivotSum sum_of(const Line& line) {
  std::vector<double> sizes;
  for (const double w : line.weights) sizes.push_back(std::fabs(w));
  return {line.lengths, line.sources, {line.weights, sizes}};
}

}  // namespace

TEST_CASE("sums beside a pivot are those of the sources, one by one, however close place and pivot are") {
  for (int kind = 0; kind < 5; ++kind) {
    const Line line = line_of(kind);
    const PivotSum sum = sum_of(line);
    const auto last = static_cast<std::ptrdiff_t>(line.lengths.size()) - 1;
    const double whole = std::accumulate(line.lengths.begin(), line.lengths.end(), 0.0);
    double worst = 0;
    double worst_if_off = 0;
    for (std::ptrdiff_t k = 0; k + 3 <= last; k += 54) {
      const PivotSum::PanelRange own{static_cast<std::size_t>(k), static_cast<std::size_t>(k) + 4};
      for (const int sigma : {-1, 0, 1}) {
        for (const std::ptrdiff_t pivot : {k, k + 3}) {
          const PanelPoint e = place_in(line, pivot, pivot == k ? 0 : 1);
          for (const double part : {1e-12, 0.3}) {
            for (const std::ptrdiff_t j : {k, k + 3}) {
              const PanelPoint x = place_in(line, j, part);
              worst = std::max(worst, error_of(line, sum, x, e, sigma, own));
              const double wrong = 1e-6 * whole;
              if (sigma != 0 && j == k)
                worst_if_off = std::max(worst_if_off, error_of(line, sum, x, e, sigma, own, wrong));
            }
          }
        }
      }
    }
    CAPTURE(kind);
    CHECK(worst <= cauchy_rounding);
    CHECK(worst_if_off > 1000 * cauchy_rounding);  // the control: the pivot at another place
  }
}

TEST_CASE("a place in the gap beside what is left out, its pivot at the far end") {
  for (int kind = 0; kind < 5; ++kind) {
    const Line line = line_of(kind);
    const PivotSum sum = sum_of(line);
    double worst = 0;
    for (std::ptrdiff_t k = 3; k < static_cast<std::ptrdiff_t>(line.lengths.size()) - 7; k += 70) {
      // Panels 7 i + 3 have no sources: there is a gap on both sides of 7 i + 4, ..., 7 i + 9.
      const PivotSum::PanelRange own{static_cast<std::size_t>(k) + 1, static_cast<std::size_t>(k) + 7};
      for (const int sigma : {-1, 0, 1}) {
        for (const double part : {0.001, 0.5, 0.999}) {
          worst = std::max(worst, error_of(line, sum, place_in(line, k, part), place_in(line, k + 6, 1), sigma, own));
          worst =
              std::max(worst, error_of(line, sum, place_in(line, k + 7, part), place_in(line, k + 1, 0), sigma, own));
        }
      }
    }
    CAPTURE(kind);
    CHECK(worst <= cauchy_rounding);
  }
}

TEST_CASE("beyond the line only the pivot's side has sources") {
  const Line line = line_of(0);
  const PivotSum sum = sum_of(line);
  const auto end = line.lengths.size();
  for (const int sigma : {-1, 0, 1}) {
    for (const double d : {1e-9, 0.01, 3.0}) {
      std::vector<double> sums(2, 0);
      const auto near = [](std::size_t, double, double) {};
      const PanelPoint left{-1, 0, 0};
      const PanelPoint first = place_in(line, 0, 0);
      sum.around({left, first, -d, sigma}, {0, end}, sums, near);
      CHECK(sums[0] == 0);
      sum.around({left, first, -d, sigma}, {0, 4}, sums, near);
      std::vector<double> moved(2, 0);
      sum.around({first, first, 0, sigma}, {0, 4}, moved, near);
      CHECK(sums[1] > 0);
      CHECK((sigma < 0 || sums[1] < moved[1]));  // farther away
    }
  }
}

}  // namespace steadyslide::numeric::hierarchical
