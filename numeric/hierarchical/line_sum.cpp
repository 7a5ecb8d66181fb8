#include "numeric/hierarchical/line_sum.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace steadyslide::numeric::hierarchical {
namespace {

constexpr std::size_t terms = CellMoments::terms;
constexpr std::size_t order = 22;

struct Tables {
  std::array<double, terms> reciprocal{};                    ///< 1/k
  std::array<double, order> node{};                          ///< in ]-1, 1[, from left to right
  std::array<double, order> from_left{};                     ///< the same in ]0, 1[
  std::array<std::array<double, order>, order> chebyshev{};  ///< [k][i]: values to coefficient k

  Tables() {
    for (std::size_t k = 1; k < terms; ++k) reciprocal[k] = 1 / static_cast<double>(k);
    for (std::size_t i = 0; i < order; ++i) {
      const double angle = std::numbers::pi * (static_cast<double>(order - i) - 0.5) / order;
      node[i] = std::cos(angle);
      from_left[i] = std::cos(angle / 2) * std::cos(angle / 2);
      for (std::size_t k = 0; k < order; ++k) {
        chebyshev[k][i] = (k == 0 ? 1.0 : 2.0) / order * std::cos(static_cast<double>(k) * angle);
      }
    }
  }
};

const Tables& tables() {
  static const Tables result;
  return result;
}

/// Evaluates a Chebyshev series by Clenshaw's algorithm at several places.
void clenshaw(const double* coefficients, const std::array<double, order>& x, double* value) {
  std::array<double, order> b{}, c{};
  for (std::size_t k = order; k-- > 1;) {
    for (std::size_t i = 0; i < order; ++i) {
      const double next = 2 * x[i] * b[i] - c[i] + coefficients[k];
      c[i] = b[i];
      b[i] = next;
    }
  }
  for (std::size_t i = 0; i < order; ++i) value[i] = x[i] * b[i] - c[i] + coefficients[0];
}

}  // namespace

LineSum::LineSum(std::vector<Kernel> kernels, const std::vector<double>& lengths, const std::vector<Source>& sources,
                 const std::vector<std::vector<double>>& weights)
    : kernels_(std::move(kernels)),
      moments_(lengths, sources, weights),
      fields_(lengths.size() * weights.size() * order, 0) {
  const std::vector<double> nothing(sums() * order, 0);
  hand_down(0, nothing.data());
}

void LineSum::add_far(std::size_t target, double* values) const {
  const Tables& table = tables();
  const double length = tree().cells()[target].length;
  for (const PanelTree::Far& far : tree().far_from(target)) {
    const PanelTree::Cell& cell = tree().cells()[far.cell];
    const double h = cell.extent / 2;
    const double side = far.side == Side::left ? 1 : -1;
    std::array<double, order> distance, r;
    for (std::size_t i = 0; i < order; ++i) {
      distance[i] = h + far.distance + length * table.from_left[side > 0 ? i : order - 1 - i];
      r[i] = side * h / distance[i];
    }
    for (std::size_t s = 0; s < sums(); ++s) {
      const bool logarithm = kernels_[s] == Kernel::logarithm;
      const double* m = moments_.of(far.cell, s);
      std::array<double, order> series{};
      for (std::size_t k = terms; k-- > 1;) {
        const double a = logarithm ? m[k] * table.reciprocal[k] : m[k];
        for (std::size_t i = 0; i < order; ++i) series[i] = (series[i] + a) * r[i];
      }
      double* value = values + s * order;
      if (logarithm) {
        for (std::size_t i = 0; i < order; ++i) value[i] += m[0] * std::log(distance[i]) - series[i];
      } else {
        const double sign = kernels_[s] == Kernel::cauchy ? -side : 1;
        for (std::size_t i = 0; i < order; ++i) value[i] += sign / distance[i] * (m[0] + series[i]);
      }
    }
  }
}

void LineSum::hand_down(std::size_t index, const double* parent_field) {
  const Tables& table = tables();
  const PanelTree::Cell& cell = tree().cells()[index];
  std::vector<double> values(sums() * order, 0);
  if (index != 0) {
    const PanelTree::Cell& parent = tree().cells()[cell.parent];
    std::array<double, order> x;
    for (std::size_t i = 0; i < order; ++i) {
      x[i] = parent.left == index ? 2 * cell.length * table.from_left[i] / parent.length - 1
                                  : 1 - 2 * cell.length * table.from_left[order - 1 - i] / parent.length;
    }
    for (std::size_t s = 0; s < sums(); ++s) clenshaw(parent_field + s * order, x, values.data() + s * order);
  }
  add_far(index, values.data());
  std::vector<double> field(sums() * order, 0);
  for (std::size_t s = 0; s < sums(); ++s) {
    for (std::size_t k = 0; k < order; ++k) {
      double sum = 0;
      for (std::size_t i = 0; i < order; ++i) sum += table.chebyshev[k][i] * values[s * order + i];
      field[s * order + k] = sum;
    }
  }
  if (cell.is_leaf()) {
    std::copy(field.begin(), field.end(), fields_.begin() + static_cast<std::ptrdiff_t>(cell.first * sums() * order));
    return;
  }
  hand_down(cell.left, field.data());
  hand_down(cell.right, field.data());
}

double LineSum::far(std::size_t sum, std::size_t k, double from_left, double from_right) const {
  const double length = tree().cells()[tree().leaf(k)].length;
  const double x = std::clamp((from_left - from_right) / length, -1.0, 1.0);
  // T_2k(x) = T_k(t), and T_2k+1(x) has the same recurrence, t = T_2(x). These are two independent sums.
  const double* c = &fields_[(k * sums() + sum) * order];
  const double t = 2 * x * x - 1;
  double even = 0, even_before = 0, odd = 0, odd_before = 0;
  for (std::size_t i = order / 2; i-- > 0;) {
    const double next_even = 2 * t * even - even_before + c[2 * i];
    const double next_odd = 2 * t * odd - odd_before + c[2 * i + 1];
    even_before = even;
    odd_before = odd;
    even = next_even;
    odd = next_odd;
  }
  return even - t * even_before + x * (odd - odd_before);
}

double LineSum::of_cell(std::size_t sum, std::size_t cell, Side side, double distance) const {
  const double h = tree().cells()[cell].extent / 2;
  const double* m = moments_.of(cell, sum);
  const double sign = side == Side::left ? 1 : -1;
  const double to_centre = h + distance;
  const double r = sign * h / to_centre;
  const bool logarithm = kernels_[sum] == Kernel::logarithm;
  double series = 0;
  for (std::size_t k = terms; k-- > 1;) series = (series + (logarithm ? m[k] * tables().reciprocal[k] : m[k])) * r;
  return logarithm ? m[0] * std::log(to_centre) - series
                   : (kernels_[sum] == Kernel::cauchy ? -sign : 1) / to_centre * (m[0] + series);
}

double LineSum::logarithmic_rise(std::size_t sum, std::size_t cell, Side side, double distance, double step) const {
  const double h = tree().cells()[cell].extent / 2;
  const double* m = moments_.of(cell, sum);
  const double sign = side == Side::left ? 1 : -1;
  const double from = sign * h / (h + distance);
  const double to = sign * h / (h + distance + step);
  double before = 0;
  double after = 0;
  for (std::size_t k = terms; k-- > 1;) {
    before = (before + m[k] * tables().reciprocal[k]) * from;
    after = (after + m[k] * tables().reciprocal[k]) * to;
  }
  return m[0] * std::log1p(step / (h + distance)) - (after - before);
}

}  // namespace steadyslide::numeric::hierarchical
