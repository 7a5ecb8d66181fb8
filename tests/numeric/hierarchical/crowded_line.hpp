#pragma once
// Lines of panels with sources, for tests of sums by cells.

#include <cmath>
#include <random>

#include "numeric/hierarchical/cell_moments.hpp"
#include "tests/support/test.hpp"

namespace steadyslide::numeric::hierarchical {

/// Panels and sources in even, crowded and graded layouts.
struct Line {
  std::vector<double> lengths;
  std::vector<Source> sources;
  std::vector<double> weights;

  void add_panel(double length, std::mt19937& random) {
    std::uniform_real_distribution<double> unit(0, 1);
    const std::size_t panel = lengths.size();
    lengths.push_back(length);
    if (panel % 7 == 3) return;  // no sources
    double left = 0;
    for (int i = 0; i < 3; ++i) {
      left += (length - left) * unit(random) * (i == 0 && panel % 3 == 0 ? 0 : 1);
      sources.push_back({panel, left, length - left});
      weights.push_back(2 * unit(random) - 1);
    }
  }
};

inline Line line_of(int kind) {
  std::mt19937 random(static_cast<unsigned>(kind) + 11);
  std::uniform_real_distribution<double> unit(0, 1);
  Line line;
  for (int i = 0; i < 300; ++i) {
    switch (kind) {
      case 0: line.add_panel(1.0 / 128, random); break;
      case 1: line.add_panel(std::pow(10, -6 * unit(random)), random); break;
      case 2: line.add_panel(std::ldexp(1.0, -std::abs(i - 150) / 2), random); break;      // towards both ends
      case 3: line.add_panel(std::ldexp(1.0, std::abs(i - 150) / 3 - 50), random); break;  // towards the middle
      default: line.add_panel(i % 2 == 0 ? 1e-9 : 0.25, random); break;
    }
  }
  return line;
}

/// Returns x - c_i as a sum of lengths from the source to the place in panel k.
inline long double offset(const Line& line, std::size_t k, double from_left, double from_right, const Source& source) {
  if (source.panel == k) {
    return source.from_left < source.from_right ? static_cast<long double>(from_left) - source.from_left
                                                : static_cast<long double>(source.from_right) - from_right;
  }
  long double between = 0;
  for (std::size_t i = std::min(k, source.panel) + 1; i < std::max(k, source.panel); ++i) between += line.lengths[i];
  if (source.panel < k) return between + from_left + source.from_right;
  return -(between + from_right + source.from_left);
}

}  // namespace steadyslide::numeric::hierarchical
