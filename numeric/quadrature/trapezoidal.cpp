#include "numeric/quadrature/trapezoidal.hpp"

#include <cstdlib>

#include "numeric/quadrature/trapezoidal_nodes.hpp"

namespace steadyslide::numeric::trapezoidal {
namespace {

/// Neumaier's summation: next to a zero of the traction principal values cancel by three digits and more.
template <Real R>
class CompensatedSum {
 public:
  void add(const R& term) {
    using std::abs;
    const R sum = sum_ + term;
    compensation_ += abs(sum_) >= abs(term) ? R((sum_ - sum) + term) : R((term - sum) + sum_);
    sum_ = sum;
  }
  R value() const { return sum_ + compensation_; }

 private:
  R sum_ = 0;
  R compensation_ = 0;
};

}  // namespace

template <Real R>
Grid<R>::Grid(PiecewiseDensity<R> density) : density_(std::move(density)), step_(step_length<R>()) {
  samples_.reserve(density_.size());
  for (const PanelDensity<R>& panel : density_) samples_.push_back(sample(panel, R(0)));
}

template <Real R>
R Grid<R>::reach_for_others(const PanelDensity<R>& density) const {
  // A panel's neighbour, a short one, sees the density at distances of its own length.
  using std::log;
  R shortest = density.panel.length;
  for (const PanelDensity<R>& other : density_) shortest = std::min(shortest, other.panel.length);
  return log(density.panel.length / shortest);
}

template <Real R>
typename Grid<R>::Samples Grid<R>::sample(const PanelDensity<R>& density, const R& offset) const {
  using std::ceil, std::min;
  const Panel<R>& panel = density.panel;
  // Beyond this tau the density is its end power to full accuracy, and so is its product with a Cauchy kernel.
  const R constant_beyond = accuracy<R>() + margin<R>() + reach_for_others(density);
  const auto reach = [&](const Power<R>& power) {
    return R(min(constant_beyond, R((5 + constant_beyond) / power.plus_one)));
  };
  const auto lowest = static_cast<long>(ceil(R((-reach(density.left) - offset) / step_)));
  const auto highest = static_cast<long>(ceil(R((reach(density.right) - offset) / step_)));

  Samples samples;
  samples.inner.reserve(static_cast<std::size_t>(highest - lowest + 1));
  const R factor = step_ / panel.length;
  const EndPowers<R> powers(density);
  const std::vector<UnitNode<R>>& units = unit_nodes<R>();
  for (long k = lowest; k <= highest; ++k) {
    using std::abs;
    const R tau = offset + static_cast<int>(k) * step_;
    const auto index = static_cast<std::size_t>(std::labs(k));
    const UnitNode<R> unit = offset == 0 && index < units.size() ? units[index] : UnitNode<R>::at(abs(tau));
    const Node<R> node = node_at(panel, unit, tau > 0);
    samples.inner.push_back({node, R(factor * density.smooth(node) * powers.at(node, unit, tau))});
  }
  const auto tail = [&](const R& last, const Power<R>& power) {
    using std::expm1;
    // q + q^2 + ... with q = exp(-h (1 + lambda)).
    return R(last / expm1(R(step_ * power.plus_one)));
  };
  samples.left_tail = tail(samples.inner.front().weighted, density.left);
  samples.right_tail = tail(samples.inner.back().weighted, density.right);
  return samples;
}

template <Real R>
template <class Kernel>
R Grid<R>::sum(const Panel<R>& panel, const Samples& samples, const Kernel& kernel) const {
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
    total += sum(density_[k].panel, samples_[k], [&](const Node<R>& node) { return R(node.x - origin); });
  }
  return total;
}

template <Real R>
PanelPoint<R> Grid<R>::midpoint_near(std::size_t k, const R& fraction) const {
  using std::floor, std::log;
  const R tau = log(fraction / (1 - fraction));
  const R cell = floor(R(tau / step_));
  return {k, node_at(density_[k].panel, R((cell + R(0.5)) * step_))};
}

template <Real R>
R Grid<R>::hilbert(const PanelPoint<R>& at) const {
  using std::abs, std::floor, std::log;
  const PanelDensity<R>& own = density_[at.panel];
  const Node<R>& x = at.node;
  const R tau = log(x.from_left / x.from_right);
  const R cells = tau / step_ - R(0.5);
  const R off_grid = cells - floor(R(cells + R(0.5)));
  const bool left_is_near = x.from_left < x.from_right;
  const auto cauchy_kernel = [&](const Node<R>& node) {
    return R(1 / (left_is_near ? R(node.from_left - x.from_left) : R(x.from_right - node.from_right)));
  };
  // Off the staggered position by delta the principal value is off by pi^2 t delta/h: only rounding may be let pass.
  const bool on_grid = abs(off_grid) < 8 * epsilon<R>() * (4 + abs(cells));
  R total = on_grid ? sum(own.panel, samples_[at.panel], cauchy_kernel)
                    : sum(own.panel, sample(own, R(tau + step_ / 2)), cauchy_kernel);
  for (std::size_t j = 0; j < density_.size(); ++j) {
    if (j == at.panel) continue;
    const bool to_the_right = j > at.panel;
    const R between = (to_the_right ? x.from_right : x.from_left) + distance_between(density_, j, at.panel);
    total += sum(density_[j].panel, samples_[j], [&](const Node<R>& node) {
      return to_the_right ? R(1 / (between + node.from_left)) : R(-1 / (between + node.from_right));
    });
  }
  return total / pi<R>();
}

template <Real R>
R Grid<R>::cauchy(Side side, const R& distance) const {
  R total = 0;
  const std::size_t nearest = side == Side::left ? 0 : density_.size() - 1;
  for (std::size_t j = 0; j < density_.size(); ++j) {
    R between = distance;
    if (j != nearest) between += density_[nearest].panel.length + distance_between(density_, nearest, j);
    total += sum(density_[j].panel, samples_[j], [&](const Node<R>& node) {
      return side == Side::left ? R(1 / (between + node.from_left)) : R(-1 / (between + node.from_right));
    });
  }
  return total / pi<R>();
}

template <Real R>
R Grid<R>::displacement(std::size_t k, Side end, const R& distance) const {
  using std::expm1, std::log1p;
  const PanelDensity<R>& own = density_[k];
  const auto from_end = [end](const Node<R>& node) { return end == Side::right ? node.from_right : node.from_left; };
  CompensatedSum<R> total;
  // On the own panel the logarithm grows by h from term to term of the tail: an arithmetic-geometric series.
  const Samples& samples = samples_[k];
  for (const Sample& s : samples.inner) total.add(s.weighted * log1p(R(distance / from_end(s.node))));
  const R& near_tail = end == Side::right ? samples.right_tail : samples.left_tail;
  const R& far_tail = end == Side::right ? samples.left_tail : samples.right_tail;
  const Power<R>& power = end == Side::right ? own.right : own.left;
  const Node<R>& last = end == Side::right ? samples.inner.back().node : samples.inner.front().node;
  total.add(near_tail * (log1p(R(distance / from_end(last))) - step_ / expm1(R(-step_ * power.plus_one))));
  total.add(far_tail * log1p(R(distance / own.panel.length)));
  for (std::size_t j = 0; j < density_.size(); ++j) {
    if (j == k) continue;
    const R between = distance_between(density_, j, k);
    const bool same_side = (j < k) == (end == Side::right);
    total.add(sum(density_[j].panel, samples_[j], [&](const Node<R>& node) {
      // On the side of the point, |x - x'| is what is left of |e - x'|.
      return same_side ? R(log1p(R(distance / (own.panel.length + between + from_end(node)))))
                       : R(log1p(R(-distance / (between + (end == Side::right ? node.from_left : node.from_right)))));
    }));
  }
  return -total.value() / pi<R>();
}

template class Grid<double>;
template class Grid<Real50>;
template class Grid<Real100>;

}  // namespace steadyslide::numeric::trapezoidal
