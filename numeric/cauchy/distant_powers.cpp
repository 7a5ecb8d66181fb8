#include "numeric/cauchy/distant_powers.hpp"

#include <algorithm>
#include <cmath>

namespace steadyslide::numeric {
namespace {

std::vector<double> lengths_of(const std::vector<Panel<double>>& panels) {
  std::vector<double> lengths;
  lengths.reserve(panels.size());
  for (const Panel<double>& panel : panels) lengths.push_back(panel.length);
  return lengths;
}

hierarchical::LineSum sum_of(const std::vector<double>& lengths, const std::vector<Power<double>>& powers) {
  std::vector<hierarchical::Source> sources;
  std::vector<double> weights;
  const auto add = [&](std::size_t panel, double from_left, double from_right, double power) {
    if (power == 0) return;
    sources.push_back({panel, from_left, from_right});
    weights.push_back(power);
  };
  for (std::size_t k = 0; k < lengths.size(); ++k) add(k, 0, lengths[k], powers[k].value);
  add(lengths.size() - 1, lengths.back(), 0, powers.back().value);
  return {{hierarchical::LineSum::Kernel::logarithm}, lengths, sources, {weights}};
}

}  // namespace

DistantPowers::DistantPowers(const std::vector<Panel<double>>& panels, const std::vector<Power<double>>& powers)
    : lengths_(lengths_of(panels)), sum_(sum_of(lengths_, powers)) {
  for (const Power<double>& power : powers) size_ += std::abs(power.value);
  for (const double length : lengths_) hull_ += length;
}

double DistantPowers::rounding(std::size_t k) const {
  // Far points are at least as far away as the panel is long.
  const double longest = std::max({1.0, std::abs(std::log(lengths_[k])), std::abs(std::log(hull_))});
  return hierarchical::logarithm_rounding * size_ * longest;
}

}  // namespace steadyslide::numeric
