// Sums over panels far from a place, by cells, in double.

#include <algorithm>
#include <cmath>

#include "numeric/number/compensated_sum.hpp"
#include "numeric/riemann_hilbert/contact_quadrature.hpp"
#include "numeric/riemann_hilbert/distant_nodes.hpp"

namespace steadyslide::numeric {

template <Real R>
struct ContactQuadrature<R>::Cells {
  /// The nodes with the weights of one component. Without pivots there is one such object for all components.
  struct Own {
    NodeLine::Segments segments;
    std::vector<double> weights;
    std::size_t first_node;
    std::unique_ptr<const DistantNodes> far;  ///< null if there are few panels
    // For few panels: the density of the last slope.
    std::size_t slope;
    Density density;
  };
  std::vector<std::unique_ptr<Own>> own;       ///< computed at first use
  std::unique_ptr<const PivotedNodes> others;  ///< null without pivots
};

template <Real R>
NodeLine ContactQuadrature<R>::node_line(std::size_t first, std::size_t end,
                                         std::span<const R> weights) const requires std::same_as<R, double> {
  return {*y_, NodeLine::Segments{first, end}, [&](std::size_t segment, const auto& add) {
            for (std::size_t k = first_panel_[segment]; k < first_panel_[segment + 1]; ++k) {
              const std::size_t count = panels_[k].rule.rule->size();
              add(k, panels_[k].rule.part, std::span(nodes_).subspan(panels_[k].first, count),
                  weights.subspan(panels_[k].first - first_node(first), count));
            }
          }};
}

template <Real R>
typename ContactQuadrature<R>::Cells* ContactQuadrature<R>::cells() const requires std::same_as<R, double> {
  // The number of sums over all panels that costs as much as the cells for all places. With pivots every solution needs
  // more sums.
  constexpr std::size_t direct_evaluations = 500;
  if (cells_ || panels_.size() < hierarchical::fewest_panels) return cells_.get();
  const std::size_t components = y_->pivots().size();
  if (components == 0 && ++evaluations_ <= direct_evaluations) return nullptr;
  cells_ = std::make_shared<Cells>();
  cells_->own.resize(std::max<std::size_t>(components, 1));
  if (components > 0) {
    cells_->others = std::make_unique<const PivotedNodes>(*y_, node_line(0, y_->set().segments(), node_weights_));
  }
  return cells_.get();
}

template <Real R>
void ContactQuadrature<R>::make_own(Cells& cells, std::size_t component) const requires std::same_as<R, double> {
  typename Cells::Own made{{0, y_->set().segments()}, node_weights_, 0, nullptr, 0, {}};
  if (cells.others) {
    made.segments = cells.others->segments(component);
    made.weights = weights_beside(component, made.segments.first, made.segments.end);
    made.first_node = first_node(made.segments.first);
  }
  const auto& [first, end] = made.segments;
  if (first_panel_[end] - first_panel_[first] >= hierarchical::fewest_panels) {
    made.far = std::make_unique<const DistantNodes>(node_line(first, end, made.weights));
  }
  cells.own[component] = std::make_unique<typename Cells::Own>(std::move(made));
}

template <Real R>
Estimate<R> ContactQuadrature<R>::cauchy_by_cells(Cells& cells, std::size_t slope,
                                                  const SurfacePoint<R>& at) const requires std::same_as<R, double> {
  const std::size_t component = y_->component_at(at);
  const std::vector<R>& polynomial = y_->problem().slopes()[slope];
  if (!cells.own[component]) make_own(cells, component);
  auto& own = *cells.own[component];
  const auto is_right = [&at](const Panel& panel) {
    return at.segment < static_cast<std::ptrdiff_t>(panel.rule.part.segment);
  };
  // The distance from a panel's nearer end to the end of its segment.
  const auto start = [&](const Panel& panel) {
    return is_right(panel) ? panel.rule.part.from_left : panel.rule.part.from_right;
  };
  EstimateSum<R> total;
  // Adds a near panel, with the weights at its nodes.
  const auto add = [&](const Panel& panel, double gap, const R* weights) {
    if (y_->slope_at(panel.rule.part.segment) == slope) return;
    const Density f = density(slope, weights, panel.first, panel.rule.rule->size());
    const double between = std::max(gap - start(panel), 0.0);
    total.add(panel_cauchy(panel, slope, component, at, between, f.values.data(), f.rounding.data()));
  };

  if (own.far) {
    total.add(own.far->around(polynomial, at, [&](std::size_t k, double gap) {
      add(panels_[k], gap, &own.weights[panels_[k].first - own.first_node]);
    }));
  } else {
    if (own.density.values.empty() || own.slope != slope) {
      own.slope = slope;
      own.density = density(slope, own.weights.data(), own.first_node, own.weights.size());
    }
    total.add(sum_of_panels(slope, component, at, own.segments.first, own.segments.end, own.density));
  }
  if (!cells.others) return total.value();
  const int sigma = y_->pivots()[component].order;
  const auto others = [&](std::size_t k, double gap, double to_pivot) {
    const Panel& panel = panels_[k];
    const auto first = node_weights_.begin() + static_cast<std::ptrdiff_t>(panel.first);
    std::vector<R> weights(first, first + static_cast<std::ptrdiff_t>(panel.rule.rule->size()));
    for (std::size_t i = 0; sigma != 0 && i < weights.size(); ++i) {
      const R d = node_distance(panel, i, is_right(panel), to_pivot);
      sigma > 0 ? weights[i] /= d : weights[i] *= d;
    }
    add(panel, gap, weights.data());
  };
  total.add(cells.others->around(polynomial, at, component, sigma, others));
  return total.value();
}

template <Real R>
Estimate<R> ContactQuadrature<R>::pivot_moment_by_cells(const Cells& cells, std::size_t component,
                                                        const R& tilt) const requires std::same_as<R, double> {
  const ContactSet<R>& set = y_->set();
  const std::size_t e = y_->pivots()[component].point;
  EstimateSum<R> sum;
  const auto add = [&](std::size_t i, const R& distance) {
    const std::size_t own = y_->slope_at(static_cast<std::size_t>(nodes_[i].segment));
    const Estimate<R> g = y_->problem().slope_estimate(own, nodes_[i].node.x) + Estimate<R>{tilt, R(0)};
    sum.add(node_term<R>(node_weights_[i] / distance, g));
  };
  const auto& [first, end] = cells.others->segments(component);
  const std::vector<R> own = distances_to(e, first, end);
  for (std::size_t i = 0; i < own.size(); ++i) add(first_node(first) + i, own[i]);
  const Estimate<R> others = cells.others->around({-tilt}, beside(set, e, set.contact_side(e), 0.0), component, 0,
                                                  [&](std::size_t k, double, double to_pivot) {
                                                    const Panel& panel = panels_[k];
                                                    const bool is_right = e <= panel.rule.part.segment;
                                                    for (std::size_t i = 0; i < panel.rule.rule->size(); ++i) {
                                                      add(panel.first + i, node_distance(panel, i, is_right, to_pivot));
                                                    }
                                                  });
  return -(sum.value() + Estimate<R>{others.value, 8 * epsilon<R>() * others.error}) / pi<R>();
}

/// Returns xi - e at a node, computed from the distance of the panel's end that is nearer to e.
template <Real R>
R ContactQuadrature<R>::node_distance(const Panel& panel, std::size_t i, bool is_right, const R& to_panel) const {
  const SegmentPart<R>& part = panel.rule.part;
  const Node<R>& node = nodes_[panel.first + i].node;
  return is_right ? to_panel - part.from_left + node.from_left : -(to_panel - part.from_right + node.from_right);
}

template ContactQuadrature<double>::Cells* ContactQuadrature<double>::cells() const;
template Estimate<double> ContactQuadrature<double>::cauchy_by_cells(Cells&, std::size_t,
                                                                     const SurfacePoint<double>&) const;
template Estimate<double> ContactQuadrature<double>::pivot_moment_by_cells(const Cells&, std::size_t,
                                                                           const double&) const;

}  // namespace steadyslide::numeric
