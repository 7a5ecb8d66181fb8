#include "enclosure/cells/cell_pressures.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace steadyslide::enclosure {

CellPressures::CellPressures(std::span<const double> pressures) : before_{0} {
  if (pressures.empty() || pressures.size() > most_cells) throw std::invalid_argument("number of cells");
  double largest = 0;
  for (const double p : pressures) {
    if (!(p >= 0) || std::isinf(p)) throw std::invalid_argument("a pressure on a cell is negative or no number");
    largest = std::max(largest, p);
  }
  if (largest == 0) throw std::invalid_argument("no cell has a pressure");
  int exponent = 0;
  std::frexp(largest, &exponent);
  for (const double p : pressures) {
    weights_.push_back(std::llround(std::ldexp(p, 40 - exponent)));
    before_.push_back(before_.back() + weights_.back());
  }
}

Rational CellPressures::load_before(const Rational& y) const {
  const Integer whole = numerator(y) / denominator(y);
  const auto cell = std::min(static_cast<std::size_t>(whole), size() - 1);
  return Rational(before_[cell]) + (y - Rational(cell)) * Rational(weights_[cell]);
}

std::vector<std::int64_t> CellPressures::rises() const {
  std::vector<std::int64_t> result;
  std::int64_t last = 0;
  for (const std::int64_t n : weights_) {
    result.push_back(n - last);
    last = n;
  }
  result.push_back(-last);
  return result;
}

}  // namespace steadyslide::enclosure
