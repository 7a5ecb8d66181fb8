#include "numeric/cauchy/traction_integrals.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "numeric/cauchy/interpolated_density.hpp"
#include "numeric/hierarchical/cell_moments.hpp"
#include "numeric/hierarchical/line_sum.hpp"
#include "numeric/quadrature/tanh_sinh.hpp"
#include "numeric/solution/piecewise_traction.hpp"

namespace steadyslide::numeric {

// The sum over many panels with shear t_t = r_k t, at a place x in or beside a panel with the ratio r:
//
//   sum_k (r_k - r) (1/pi) int_k t/(x'-x) dx',
//
// in double. Panels far from x are grouped in cells (numeric/hierarchical/). The sources are the nodes of the
// quadrature rules that represent the traction of every method (piecewise_traction.hpp). A place costs O(log n). The
// caller adds the panels near x. A rule is accurate if the poles of the integrand are at least a panel's length away;
// cells are far in this sense.

class DistantTractions {
 public:
  /// Segment k of the traction is panel k of the density, with all lengths multiplied by `unit`.
  DistantTractions(const PiecewiseDensity<double>& density, const PiecewiseTraction<double>& traction, double unit)
      : line_(density, traction, unit), moments_(line_.lengths, line_.sources, line_.weights) {}

  /// Returns the sum over far panels, and calls visit(k, side, distance) for the others; x is on that side of panel k.
  /// The panel that contains x is left out, because its ratio is r.
  template <class Visit>
  Estimate<double> around(const LinePlace<double>& place, double ratio, const Visit& visit) const {
    const hierarchical::PanelTree& tree = moments_.tree();
    Estimate<double> sum{0, 0};
    const auto takes = [&](std::size_t cell, Side side, double distance) {
      if (!tree.is_far(cell, distance)) return false;
      sum += of_cell(cell, side, distance, ratio);
      return true;
    };
    const auto near = [&](std::size_t leaf, double distance, Side side) {
      visit(line_.panel_of[leaf], opposite(side), distance);
    };
    if (place.inside) {
      tree.around(line_.leaf_of[place.panels], place.inside->from_left, place.inside->from_right, takes, near);
    } else if (place.panels == 0) {
      tree.beyond(Side::left, place.to_right, takes, near);
    } else if (place.panels == line_.leaf_of.size()) {
      tree.beyond(Side::right, place.to_left, takes, near);
    } else if (const std::size_t before = line_.leaf_of[place.panels - 1]; before + 1 < line_.leaf_of[place.panels]) {
      tree.around(before + 1, place.to_left, place.to_right, takes, near);
    } else {
      // Two panels meet here: use the end of the left one.
      visit(place.panels - 1, Side::right, 0.0);
      tree.around(before, line_.lengths[before], 0.0, takes, near);
    }
    return sum;
  }

 private:
  /// Panels and the gaps between them.
  struct Line {
    std::vector<double> lengths;
    std::vector<std::size_t> leaf_of;   ///< by panel
    std::vector<std::size_t> panel_of;  ///< by leaf
    std::vector<hierarchical::Source> sources;
    /// Forces times r_k, forces, and the error bounds of the sum of both.
    std::vector<std::vector<double>> weights{3};

    Line(const PiecewiseDensity<double>& density, const PiecewiseTraction<double>& traction, double unit) {
      double largest = 0;
      for (const TractionPanel<double>& panel : traction.panels())
        largest = std::max(largest, std::abs(panel.shear_ratio));
      TractionNodes<double> nodes;  // from the singular end of a panel
      for (std::size_t k = 0; k < density.size(); ++k) {
        const auto add_leaf = [&](double length) {
          panel_of.push_back(k);
          lengths.push_back(length);
        };
        if (density[k].gap > 0) add_leaf(density[k].gap);
        const std::size_t leaf = lengths.size();
        leaf_of.push_back(leaf);
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
            sources.push_back({leaf, from_left, std::max(length - from_left, 0.0)});
            weights[0].push_back(panel.shear_ratio * force);
            weights[1].push_back(force);
            weights[2].push_back((std::abs(panel.shear_ratio) + largest) * std::abs(force) * error);
          }
          before += panel.length / unit;
        }
      }
    }
  };

  /// Returns the contribution of a cell at this distance, on that side of x.
  Estimate<double> of_cell(std::size_t cell, Side side, double distance, double ratio) const {
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

  Line line_;
  hierarchical::CellMoments moments_;
};

namespace {

/// Returns int t from an end of a panel to a node in the half at that end.
template <Real R>
Estimate<R> part_integral(const PanelDensity<R>& density, Side end, const R& distance) {
  const Panel<R> part = end == Side::left ? Panel<R>{density.panel.left, density.panel.left + distance, distance}
                                          : Panel<R>{density.panel.right - distance, density.panel.right, distance};
  const bool left = end == Side::left;
  return tanh_sinh::panel_integral<R>(
      {part, left ? density.left : Power<R>{}, left ? Power<R>{} : density.right, [&](const Node<R>& node) {
         return density.without_power(end, density.panel.node_from(end, left ? node.from_left : node.from_right));
       }});
}

}  // namespace

template <Real R>
TractionIntegrals<R>::TractionIntegrals(PiecewiseDensity<R> density, std::vector<OnPanel> on_panels, const R& gamma,
                                        const ContactSolution<R>& solution, const R& unit)
    : density_(std::move(density)), on_panels_(std::move(on_panels)), gamma_(gamma), unit_(unit) {
  if constexpr (std::same_as<R, double>) {
    const auto has_other_ratio = [&](const OnPanel& p) { return p.ratio != on_panels_.front().ratio; };
    if (std::any_of(on_panels_.begin(), on_panels_.end(), has_other_ratio) &&
        density_.size() >= hierarchical::fewest_panels) {
      distant_ = std::make_shared<const DistantTractions>(density_, solution.piecewise_traction(), unit);
    }
  }
  for (PanelDensity<R>& panel : density_) panel = interpolated(std::move(panel));
  before_.emplace_back();
  for (const OnPanel& panel : on_panels_) before_.push_back(before_.back() - panel.load);
}

template <Real R>
Estimate<R> TractionIntegrals<R>::load_before(const LinePlace<R>& place) const {
  if (!place.inside) return before_[place.panels];
  const PanelDensity<R>& density = density_[place.panels];
  const R& error = on_panels_[place.panels].relative_error;
  const auto& [x, left, right] = *place.inside;
  if (left < right) return before_[place.panels] - part_integral(density, Side::left, left).widened(error);
  return before_[place.panels + 1] + part_integral(density, Side::right, right).widened(error);
}

template <Real R>
Estimate<R> TractionIntegrals<R>::cauchy(std::size_t k, Side side, const R& distance) const {
  const OnPanel& on = on_panels_[k];
  if (distance > 0) return tanh_sinh::cauchy<R>({density_[k]}, side, distance).widened(on.relative_error);
  // Here x is an end of the panel, so dividing by the distance lowers its power by one.
  PanelDensity<R> divided = density_[k];
  Power<R>& power = side == Side::left ? divided.left : divided.right;
  power = {power.value - 1, power.value};
  Estimate<R> integral = tanh_sinh::panel_integral(divided).widened(on.relative_error) / pi<R>();
  // t vanishes at the end, but its rounding error does not.
  integral.error += (side == Side::left ? on.left_error : on.right_error) * tanh_sinh::logarithm(power) / pi<R>();
  return side == Side::left ? integral : -integral;
}

template <Real R>
std::size_t TractionIntegrals<R>::nearest(const LinePlace<R>& place) const {
  return place.inside || place.to_right < place.to_left ? place.panels : place.panels - 1;
}

template <Real R>
Estimate<R> TractionIntegrals<R>::from_slope(std::size_t panel, const LinePlace<R>& place, const Estimate<R>& traction,
                                             const Estimate<R>& slope) const {
  const Rational& exact_ratio = on_panels_[panel].ratio;
  const R ratio = to_real<R>(exact_ratio);
  Estimate<R> sum = ratio * (slope - on_panels_[panel].s * traction) + gamma_ * traction;
  const auto add = [&](std::size_t k, Side side, const R& distance) {
    const Rational& other = on_panels_[k].ratio;
    if (other != exact_ratio) sum += to_real<R>(Rational(other - exact_ratio)) * cauchy(k, side, distance);
  };
  if constexpr (std::same_as<R, double>) {
    if (distant_) return sum += distant_->around(place, ratio, add);
  }
  R distance = place.to_left;
  for (std::size_t k = place.panels; k-- > 0; distance += density_[k].panel.length + density_[k].gap) {
    add(k, Side::right, distance);
  }
  distance = place.to_right;
  for (std::size_t k = place.panels + (place.inside ? 1 : 0); k < density_.size(); ++k) {
    add(k, Side::left, distance);
    distance += density_[k].panel.length + (k + 1 < density_.size() ? density_[k + 1].gap : R(0));
  }
  return sum;
}

template <Real R>
Estimate<R> TractionIntegrals<R>::shear_slope(const LinePlace<R>& place, const Estimate<R>& traction,
                                              const Estimate<R>& slope) const {
  return from_slope(nearest(place), place, traction, slope);
}

template <Real R>
Estimate<R> TractionIntegrals<R>::limit(const LinePlace<R>& place, Side side, const TwoSided<R>& traction,
                                        const TwoSided<R>& slope) const {
  const auto infinite = [](const R& sign) { return Estimate<R>{sign > 0 ? infinity<R>() : -infinity<R>(), R(0)}; };
  const bool on_left = side == Side::left;
  const bool touches_left = place.to_left == 0;
  const bool touches_right = place.to_right == 0;
  const Estimate<R>& t = on_left ? traction.left : traction.right;
  const bool touches = on_left ? touches_left : touches_right;
  if (touches_left && touches_right) {
    const Rational rise = on_panels_[place.panels].ratio - on_panels_[place.panels - 1].ratio;
    // t_t jumps. For a finite or logarithmic t, the slope is -(rise/pi) t log d plus smaller terms. If t blows up by a
    // power, the cases below with s apply.
    if (rise != 0 && t.value != 0 && (gamma_ == 0 || !isinf(t.value))) return infinite(R(-sign(rise)));
  }
  // gamma t - r s t = gamma (1 + f^2) t. At a jump of f, the contribution of the other side does not change the sign.
  if (touches && isinf(t.value) && gamma_ != 0) {
    const bool jumps =
        touches_left && touches_right && on_panels_[place.panels].ratio != on_panels_[place.panels - 1].ratio;
    return infinite(jumps ? gamma_ : R(gamma_ * (t.value > 0 ? 1 : -1)));
  }
  const std::size_t panel = touches ? place.panels - (on_left ? 1 : 0) : nearest(place);
  const Estimate<R>& slope_there = on_left ? slope.left : slope.right;
  if (isinf(slope_there.value)) {
    const int ratio = sign(on_panels_[panel].ratio);
    if (ratio != 0) return infinite(R(ratio * (slope_there.value > 0 ? 1 : -1)));
    return from_slope(panel, place, {}, {});
  }
  // If gamma = 0 then s = 0, so an infinite t has no influence.
  return from_slope(panel, place, isinf(t.value) ? Estimate<R>{} : t, slope_there);
}

template <Real R>
void TractionIntegrals<R>::add_to(DetailedSample<R>& sample, const LinePlace<R>& place, bool is_singular_point,
                                  const R& compliance, const R& end_error) const {
  const TwoSided<R>& traction = sample.traction;
  const TwoSided<R> slope{sample.slope.left / compliance, sample.slope.right / compliance};
  sample.cumulative_load = unit_ * load_before(place);
  if (is_singular_point) {
    sample.shear_slope = {limit(place, Side::left, traction, slope), limit(place, Side::right, traction, slope)};
  } else {
    sample.cumulative_load.error += 2 * unit_ * end_error * abs(traction.left.value);
    sample.shear_slope.left = sample.shear_slope.right = shear_slope(place, traction.left, slope.left);
  }
  sample.shear_slope.left *= compliance;
  sample.shear_slope.right *= compliance;
}

STEADYSLIDE_INSTANTIATE_CLASS(TractionIntegrals)

}  // namespace steadyslide::numeric
