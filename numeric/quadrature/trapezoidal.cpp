#include "numeric/quadrature/trapezoidal.hpp"

#include <cstdlib>

#include "numeric/hierarchical/line_sum.hpp"
#include "numeric/number/compensated_sum.hpp"

namespace steadyslide::numeric::trapezoidal {
namespace {

// The nodes in tau, x = tanh(tau/2), and the end powers at them: from_left = length/(1+e^-tau), from_right = from_left
// e^-tau, and log(from_left/from_right) = tau.

/// Returns -log(epsilon), the required accuracy as an exponent.
template <Real R>
R accuracy() {
  return -log(epsilon<R>());
}

/// Principal values may be taken as close as e^-margin of a panel to its ends.
template <Real R>
R margin() {
  return 20;
}

/// The data for the nodes of every panel at +-tau, tau >= 0.
template <Real R>
struct UnitNode {
  R exponential;  ///< e^-tau
  R sum;          ///< 1 + e^-tau
  R logarithm;    ///< log(1 + e^-tau)

  static UnitNode at(const R& tau) {
    const R e = exp(-tau);
    return {e, R(1 + e), log(R(1 + e))};
  }
};

/// A step with few bits, so that every k h is exact. Otherwise the rounding of nodes would be the largest error.
template <Real R>
R step_length() {
  // The integrand is analytic for |Im tau| < pi, with branch points on the border. So aim at slightly more than the
  // accuracy.
  return floor(1024 * 2 * pi<R>() * pi<R>() / (accuracy<R>() + 12)) / 1024;
}

/// The data at 0, h, 2h, ... are the same for all grids. Their logarithms are the most expensive part.
template <Real R>
const std::vector<UnitNode<R>>& unit_nodes() {
  static const std::vector<UnitNode<R>> nodes = [] {
    std::vector<UnitNode<R>> result;
    const R last = accuracy<R>() + 2 * margin<R>();
    for (R tau = 0; tau < last; tau += step_length<R>()) result.push_back(UnitNode<R>::at(tau));
    return result;
  }();
  return nodes;
}

template <Real R>
Node<R> node_at(const Panel<R>& panel, const UnitNode<R>& unit, bool right_half) {
  // Compute both distances from the smaller exponential: there is no overflow and no cancellation.
  const R far = panel.length / unit.sum;
  const R near = far * unit.exponential;
  return right_half ? Node<R>{panel.right - near, far, near} : Node<R>{panel.left + near, near, far};
}

/// Returns from_left^(1+lambda) from_right^(1+mu), where lambda and mu are the density's end powers. In higher
/// precision it is one exponential. A large argument loses digits, but it is negative, so the factor is so small that
/// the loss does not affect the sums.
template <Real R>
class EndPowers {
 public:
  explicit EndPowers(const PanelDensity<R>& density) : left_(density.left.plus_one), right_(density.right.plus_one) {
    if constexpr (!std::same_as<R, double>) log_length_ = log(density.panel.length);
  }

  R at(const Node<R>& node, const UnitNode<R>& unit, const R& tau) const {
    if (left_ == 1 && right_ == 1) return node.from_left * node.from_right;
    if constexpr (std::same_as<R, double>) {
      return pow(node.from_left, left_) * pow(node.from_right, right_);
    } else {
      // log(from_left/from_right) is tau.
      return exp((left_ + right_) * (log_length_ - unit.logarithm) + (tau > 0 ? -right_ * tau : left_ * tau));
    }
  }

 private:
  R left_;
  R right_;
  R log_length_ = 0;
};

}  // namespace

template <Real R>
Grid<R>::Grid(PiecewiseDensity<R> density)
    : density_(std::move(density)), step_(step_length<R>()), shortest_(infinity<R>()) {
  for (const PanelDensity<R>& panel : density_) shortest_ = std::min(shortest_, panel.panel.length);
  samples_.reserve(density_.size());
  for (std::size_t k = 0; k < density_.size(); ++k) samples_.push_back(sample(k, R(0)));
  line_ = line();
}

template <Real R>
struct Grid<R>::Line {
  std::vector<std::size_t> leaf_of;   ///< by panel
  std::vector<std::size_t> panel_of;  ///< by leaf
  hierarchical::LineSum sum;
};

template <Real R>
std::shared_ptr<const typename Grid<R>::Line> Grid<R>::line() const {
  if constexpr (std::same_as<R, double>) {
    // A displacement has a logarithm for every sample. So cells are faster already for fewer panels than in sums of
    // quotients.
    if (density_.size() < hierarchical::fewest_panels / 4) return nullptr;
    std::vector<std::size_t> leaf_of, panel_of;
    std::vector<double> lengths, weights;
    std::vector<hierarchical::Source> sources;
    for (std::size_t k = 0; k < density_.size(); ++k) {
      if (density_[k].gap > 0) {
        lengths.push_back(density_[k].gap);
        panel_of.push_back(k);
      }
      const std::size_t leaf = lengths.size();
      const double length = density_[k].panel.length;
      leaf_of.push_back(leaf);
      panel_of.push_back(k);
      lengths.push_back(length);
      sources.push_back({leaf, 0, length});
      weights.push_back(samples_[k].left_tail);
      for (const Sample& sample : samples_[k].inner) {
        sources.push_back({leaf, sample.node.from_left, sample.node.from_right});
        weights.push_back(sample.weighted);
      }
      sources.push_back({leaf, length, 0});
      weights.push_back(samples_[k].right_tail);
    }
    return std::make_shared<const Line>(
        Line{std::move(leaf_of), std::move(panel_of),
             hierarchical::LineSum({hierarchical::LineSum::Kernel::cauchy}, lengths, sources, {weights})});
  } else {
    return nullptr;
  }
}

template <Real R>
typename Grid<R>::Samples Grid<R>::sample(std::size_t panel_index, const R& offset) const {
  const PanelDensity<R>& density = density_[panel_index];
  const Panel<R>& panel = density.panel;
  // Beyond this tau the density equals its end power to full accuracy, and so does its product with a Cauchy kernel. A
  // short neighbouring panel needs the density at distances of its own length.
  const R constant_beyond = accuracy<R>() + margin<R>() + log(panel.length / shortest_);
  const auto reach = [&](const Power<R>& power, const R& gap) {
    const R usual = min(constant_beyond, R((5 + constant_beyond) / power.plus_one));
    if (gap == 0) return usual;
    // At distances larger than a short gap, the end beyond the gap also influences the power.
    return max(usual, min(R(2 * constant_beyond), R(log(panel.length / gap) + margin<R>())));
  };
  const R right_gap = panel_index + 1 < density_.size() ? density_[panel_index + 1].gap : R(0);
  const auto lowest = static_cast<long>(ceil((-reach(density.left, density.gap) - offset) / step_));
  const auto highest = static_cast<long>(ceil((reach(density.right, right_gap) - offset) / step_));

  Samples samples;
  samples.inner.reserve(static_cast<std::size_t>(highest - lowest + 1));
  const R factor = step_ / panel.length;
  const EndPowers<R> powers(density);
  const std::vector<UnitNode<R>>& units = unit_nodes<R>();
  for (long k = lowest; k <= highest; ++k) {
    const R tau = offset + static_cast<int>(k) * step_;
    const auto index = static_cast<std::size_t>(std::labs(k));
    const UnitNode<R> unit = offset == 0 && index < units.size() ? units[index] : UnitNode<R>::at(abs(tau));
    const Node<R> node = node_at(panel, unit, tau > 0);
    samples.inner.push_back({node, factor * density.smooth(node) * powers.at(node, unit, tau)});
  }
  const auto tail = [&](const R& last, const Power<R>& power) {
    // q + q^2 + ... with q = exp(-h (1 + lambda)).
    return last / expm1(step_ * power.plus_one);
  };
  samples.left_tail = tail(samples.inner.front().weighted, density.left);
  samples.right_tail = tail(samples.inner.back().weighted, density.right);
  return samples;
}

template <Real R>
template <class Kernel>
R Grid<R>::sum(const Panel<R>& panel, const Samples& samples, const Kernel& kernel) const {
  // Next to a zero of the traction, principal values lose three digits and more by cancellation.
  CompensatedSum<R> total;
  for (const Sample& s : samples.inner) total.add(s.weighted * kernel(s.node));
  total.add(samples.left_tail * kernel(Node<R>{panel.left, R(0), panel.length}));
  total.add(samples.right_tail * kernel(Node<R>{panel.right, panel.length, R(0)}));
  return total.value();
}

template <Real R>
R Grid<R>::panel_integral(std::size_t k) const {
  return sum(density_[k].panel, samples_[k], [](const Node<R>&) { return R(1); });
}

template <Real R>
R Grid<R>::integral() const {
  R total = 0;
  for (std::size_t k = 0; k < density_.size(); ++k) total += panel_integral(k);
  return total;
}

template <Real R>
R Grid<R>::moment(const R& origin) const {
  R total = 0;
  for (std::size_t k = 0; k < density_.size(); ++k) {
    total += sum(density_[k].panel, samples_[k], [&](const Node<R>& node) { return node.x - origin; });
  }
  return total;
}

template <Real R>
PanelPoint<R> Grid<R>::midpoint_near(std::size_t k, const R& fraction) const {
  const R cell = floor(log(fraction / (1 - fraction)) / step_);
  const R tau = (cell + R(0.5)) * step_;
  return {k, node_at(density_[k].panel, UnitNode<R>::at(abs(tau)), tau > 0)};
}

template <Real R>
R Grid<R>::hilbert(const PanelPoint<R>& at) const {
  const PanelDensity<R>& own = density_[at.panel];
  const Node<R>& x = at.node;
  const R tau = log(x.from_left / x.from_right);
  const R cells = tau / step_ - R(0.5);
  const R off_grid = cells - floor(cells + R(0.5));
  const bool left_is_near = x.from_left < x.from_right;
  const auto cauchy_kernel = [&](const Node<R>& node) {
    return 1 / (left_is_near ? node.from_left - x.from_left : x.from_right - node.from_right);
  };
  // If the point is displaced by delta from the staggered position, the principal value has the error pi^2 t delta/h.
  // So only rounding is allowed.
  const bool on_grid = abs(off_grid) < 8 * epsilon<R>() * (4 + abs(cells));
  R total = on_grid ? sum(own.panel, samples_[at.panel], cauchy_kernel)
                    : sum(own.panel, sample(at.panel, tau + step_ / 2), cauchy_kernel);
  if (line_) return (total + hilbert_of_others(at)) / pi<R>();
  for (std::size_t j = 0; j < density_.size(); ++j) {
    if (j == at.panel) continue;
    const bool to_the_right = j > at.panel;
    const R between = (to_the_right ? x.from_right : x.from_left) + distance_between(density_, j, at.panel);
    total += hilbert_of(j, to_the_right, between);
  }
  return total / pi<R>();
}

template <Real R>
R Grid<R>::hilbert_of(std::size_t j, bool to_the_right, const R& between) const {
  return sum(density_[j].panel, samples_[j], [&](const Node<R>& node) {
    return to_the_right ? 1 / (between + node.from_left) : -1 / (between + node.from_right);
  });
}

template <Real R>
R Grid<R>::hilbert_of_others(const PanelPoint<R>& at) const {
  if constexpr (std::same_as<R, double>) {
    const std::size_t leaf = line_->leaf_of[at.panel];
    CompensatedSum<R> total;
    for (const auto& [panel, between] : line_->sum.near_to(leaf)) {
      const bool to_the_right = panel > leaf;
      total.add(hilbert_of(line_->panel_of[panel], to_the_right,
                           between + (to_the_right ? at.node.from_right : at.node.from_left)));
    }
    total.add(line_->sum.far(0, leaf, at.node.from_left, at.node.from_right));
    return total.value();
  } else {
    return R(0);
  }
}

template <Real R>
R Grid<R>::cauchy(Side side, const R& distance) const {
  R total = 0;
  const std::size_t nearest = side == Side::left ? 0 : density_.size() - 1;
  for (std::size_t j = 0; j < density_.size(); ++j) {
    R between = distance;
    if (j != nearest) between += density_[nearest].panel.length + distance_between(density_, nearest, j);
    total += sum(density_[j].panel, samples_[j], [&](const Node<R>& node) {
      return side == Side::left ? 1 / (between + node.from_left) : -1 / (between + node.from_right);
    });
  }
  return total / pi<R>();
}

template <Real R>
R Grid<R>::displacement(std::size_t k, Side end, const R& distance) const {
  const PanelDensity<R>& own = density_[k];
  const auto from_end = [end](const Node<R>& node) { return end == Side::right ? node.from_right : node.from_left; };
  CompensatedSum<R> total;
  // On this panel the logarithm grows by h from term to term of the tail, which is an arithmetic-geometric series.
  const Samples& samples = samples_[k];
  for (const Sample& s : samples.inner) total.add(s.weighted * log1p(distance / from_end(s.node)));
  const R& near_tail = end == Side::right ? samples.right_tail : samples.left_tail;
  const R& far_tail = end == Side::right ? samples.left_tail : samples.right_tail;
  const Power<R>& power = end == Side::right ? own.right : own.left;
  const Node<R>& last = end == Side::right ? samples.inner.back().node : samples.inner.front().node;
  total.add(near_tail * (log1p(distance / from_end(last)) - step_ / expm1(-step_ * power.plus_one)));
  total.add(far_tail * log1p(distance / own.panel.length));
  if constexpr (std::same_as<R, double>) {
    if (line_) {
      using hierarchical::PanelTree;
      const PanelTree& tree = line_->sum.tree();
      const bool at_right = end == Side::right;
      const auto takes = [&](std::size_t cell, Side side, double from_end) {
        const double step = (side == Side::left) == at_right ? distance : -distance;
        if (!tree.is_far(cell, from_end) || !tree.is_far(cell, from_end + step)) return false;
        total.add(line_->sum.logarithmic_rise(0, cell, side, from_end, step));
        return true;
      };
      const auto near = [&](std::size_t leaf, double from_end, Side side) {
        total.add(displacement_of(line_->panel_of[leaf], (side == Side::left) == at_right, end, from_end, distance));
      };
      tree.around(line_->leaf_of[k], at_right ? own.panel.length : 0, at_right ? 0 : own.panel.length, takes, near);
      return -total.value() / pi<R>();
    }
  }
  for (std::size_t j = 0; j < density_.size(); ++j) {
    if (j == k) continue;
    const bool same_side = (j < k) == (end == Side::right);
    const R between = distance_between(density_, j, k);
    total.add(displacement_of(j, same_side, end, same_side ? own.panel.length + between : between, distance));
  }
  return -total.value() / pi<R>();
}

template <Real R>
R Grid<R>::displacement_of(std::size_t j, bool same_side, Side end, const R& between, const R& distance) const {
  return sum(density_[j].panel, samples_[j], [&](const Node<R>& node) {
    const R& from_left = node.from_left;
    const R& from_right = node.from_right;
    // On the same side as the point, |x - x'| is |e - x'| minus the distance.
    return same_side ? log1p(distance / (between + (end == Side::right ? from_right : from_left)))
                     : log1p(-distance / (between + (end == Side::right ? from_left : from_right)));
  });
}

STEADYSLIDE_INSTANTIATE_CLASS(Grid)

}  // namespace steadyslide::numeric::trapezoidal
