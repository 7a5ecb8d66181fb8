#include "numeric/cauchy/distant_tractions.hpp"

#include <algorithm>
#include <cmath>

namespace steadyslide::numeric {

DistantTractions::Line DistantTractions::line_of(const PiecewiseDensity<double>& density,
                                                 const PiecewiseTraction<double>& traction, double unit) {
  Line line;
  double largest = 0;
  for (const TractionPanel<double>& panel : traction.panels()) largest = std::max(largest, std::abs(panel.shear_ratio));
  TractionNodes<double> nodes;  // from the singular end of a panel
  for (std::size_t k = 0; k < density.size(); ++k) {
    const auto add_leaf = [&](double length) {
      line.panel_of.push_back(k);
      line.lengths.push_back(length);
    };
    if (density[k].gap > 0) add_leaf(density[k].gap);
    const std::size_t leaf = line.lengths.size();
    line.leaf_of.push_back(leaf);
    const double length = density[k].panel.length;
    add_leaf(length);
    double before = 0;
    for (const TractionPanel<double>& panel : traction.segment(k)) {
      nodes.clear();
      traction.append_nodes(panel, nodes);
      const double error = panel.error + 32 * epsilon<double>();
      const bool backwards = panel.singular_end == Side::right;
      for (std::size_t n = 0; n < nodes.forces.size(); ++n) {
        const std::size_t i = backwards ? nodes.forces.size() - 1 - n : n;
        const double from_left = before + nodes.from_left[i] / unit;
        const double force = nodes.forces[i] / unit;
        line.sources.push_back({leaf, from_left, std::max(length - from_left, 0.0)});
        line.weights[0].push_back(panel.shear_ratio * force);
        line.weights[1].push_back(force);
        line.weights[2].push_back((std::abs(panel.shear_ratio) + largest) * std::abs(force) * error);
      }
      before += panel.length / unit;
    }
  }
  return line;
}

DistantTractions::DistantTractions(Line line)
    : line_(std::move(line)), moments_(line_.lengths, line_.sources, line_.weights) {}

Estimate<double> DistantTractions::of_cell(std::size_t cell, Side side, double distance, double ratio) const {
  // From the centre c: 1/(x'-x) = -+(1/D) sum_k r^k u^k, D = |x - c|.
  const double h = moments_.tree().cells()[cell].extent / 2;
  const double to_centre = h + distance;
  const double sign = side == Side::left ? -1 : 1;
  const double r = -sign * h / to_centre;
  hierarchical::CellMoments::Series series;
  series[0] = 1 / (pi<double>() * to_centre);
  for (std::size_t k = 1; k < series.size(); ++k) series[k] = r * series[k - 1];
  const auto sum = [&](std::size_t s) { return moments_.weighted(cell, s, series); };
  return {sign * (sum(0) - ratio * sum(1)), sum(2)};
}

}  // namespace steadyslide::numeric
