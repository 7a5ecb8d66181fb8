#include "numeric/riemann_hilbert/contact_quadrature.hpp"

#include <algorithm>
#include <cmath>

#include "numeric/cauchy/second_kind.hpp"

namespace steadyslide::numeric {
namespace {

/// More numbers than this are not kept of all densities.
constexpr std::size_t most_kept = 4'000'000;
/// Sums over all panels that cost about as much as the cells for all places.
constexpr std::size_t direct_evaluations = 500;

/// Subtracts term x^j from entry j.
template <Real R>
void subtract_powers(std::vector<R>& moments, R term, const R& x) {
  for (R& m : moments) {
    m -= term;
    term *= x;
  }
}

/// What is left of int_0^1 y^a/(y + d) dy as d -> 0 without its singular term: -pi d^a/sin(pi a); -log(d length) at a =
/// 0.
template <Real R>
R regular_second_kind(const Power<R>& a, const R& length) {
  using std::log;
  return a.value == 0 ? log(length) : 1 / a.value;
}

}  // namespace

template <Real R>
ContactQuadrature<R>::ContactQuadrature(const SignedFundamentalSolution<R>& y, JacobiRules<R>& rules)
    : y_(&y), densities_(y.problem().slopes().size()) {
  const ContactSet<R>& set = y.set();
  if (y.problem().slopes().size() <= 1 && set.components() <= 1) return;
  const auto power_at = [&y](std::size_t j) {
    const R& p = y.power(j).value;
    return Power<R>{-p, 1 - p};
  };
  for (std::size_t segment = 0; segment < set.segments(); ++segment) {
    first_panel_.push_back(panels_.size());
    if (!set.in_contact(segment)) continue;
    const R amplitude = y.traction_factor(segment);
    for (const JacobiPanel<R>& panel :
         jacobi_panels<R>(y, whole_segment(set, segment), SmoothFactor::polynomial, power_at, rules)) {
      panels_.push_back({panel, nodes_.size()});
      for (std::size_t i = 0; i < panel.rule->size(); ++i) {
        nodes_.push_back(panel.node(set, i));
        node_weights_.push_back(amplitude * panel.node_weight(i) / y.modulus(nodes_.back()));
      }
    }
  }
  first_panel_.push_back(panels_.size());
}

template <Real R>
const std::vector<R>& ContactQuadrature<R>::density(std::size_t slope) const {
  std::vector<R>& result = densities_[slope];
  if (!result.empty() || nodes_.empty()) return result;
  if (densities_.size() * nodes_.size() > most_kept && slope != last_density_) densities_[last_density_] = {};
  last_density_ = slope;
  result = density(slope, 0, nodes_.size());
  return result;
}

template <Real R>
std::vector<R> ContactQuadrature<R>::density(std::size_t slope, std::size_t first, std::size_t count) const {
  std::vector<R> result;
  const ReducedProblem<R>& problem = y_->problem();
  result.reserve(count);
  for (std::size_t i = first; i < first + count; ++i) {
    const std::size_t own = y_->slope_at(static_cast<std::size_t>(nodes_[i].segment));
    const R& x = nodes_[i].node.x;
    result.push_back(own == slope ? R(0) : node_weights_[i] * (problem.slope(own, x) - problem.slope(slope, x)));
  }
  return result;
}

template <Real R>
Estimate<R> ContactQuadrature<R>::panel_cauchy(const Panel& panel, std::size_t slope, const SurfacePoint<R>& at,
                                               const R& between, const R* density) const {
  using std::abs, std::pow;
  const SegmentPart<R>& part = panel.rule.part;
  const JacobiRule<R>& rule = *panel.rule.rule;
  const bool panel_is_right = at.segment < static_cast<std::ptrdiff_t>(part.segment);
  const std::size_t count = rule.size();
  const R gap = between + (panel_is_right ? part.from_left : part.from_right);
  R sum = 0;
  R size = 0;
  if (2 * gap >= part.length) {
    for (std::size_t i = panel.first; i < panel.first + count; ++i) {
      const R term = density[i - panel.first] /
                     (between + (panel_is_right ? nodes_[i].node.from_left : nodes_[i].node.from_right));
      sum += term;
      size += abs(term);
    }
  } else {
    // phi(y) y^a over the unit interval, y from the end that faces the point, where the power sits if there is any:
    // int y^a (phi(y) - phi(-d))/(y + d) + phi(-d) int y^a/(y + d), exactly the function of the second kind.
    const R d = gap / part.length;
    const auto facing = static_cast<std::size_t>(panel_is_right ? part.segment : part.segment + 1);
    const R& p = y_->power(facing).value;
    // At the end itself d^-p/|Y| is known by its limit.
    R phi = gap == 0 ? 1 / (y_->fundamental_solution().amplitude(facing) * pow(part.length, p)) : 1 / y_->modulus(at);
    if (gap > 0 && p != 0) phi *= pow(d, p);
    const ReducedProblem<R>& problem = y_->problem();
    phi *= y_->traction_factor(part.segment) *
           (problem.slope(y_->slope_at(part.segment), at.node.x) - problem.slope(slope, at.node.x));
    const bool mirrored = !panel.rule.singular_end && !panel_is_right;
    for (std::size_t i = 0; i < count; ++i) {
      const R& y = mirrored ? rule.from_right[i] : rule.from_left[i];
      const R term = (density[i] / part.length - phi * rule.weights[i]) / (y + d);
      sum += term;
      size += abs(term) + abs(phi * rule.weights[i]);
    }
    const R rest = phi * (gap == 0 ? regular_second_kind(panel.rule.power, part.length)
                                   : second_kind::left_of(panel.rule.power, d));
    sum += rest;
    size += abs(rest);
  }
  return {panel_is_right ? sum : -sum, size};
}

template <Real R>
Estimate<R> ContactQuadrature<R>::cauchy(std::size_t slope, const SurfacePoint<R>& at) const {
  Estimate<R> total{R(0), R(0)};
  if (panels_.empty()) return total;
  const ContactSet<R>& set = y_->set();
  if constexpr (std::same_as<R, double>) {
    if (const DistantNodes* nodes = distant()) {
      const auto near = [&](std::size_t k, double gap) {
        const SegmentPart<double>& part = panels_[k].rule.part;
        if (y_->slope_at(part.segment) == slope) return;
        const bool panel_is_right = at.segment < static_cast<std::ptrdiff_t>(part.segment);
        const double between = std::max(gap - (panel_is_right ? part.from_left : part.from_right), 0.0);
        const std::vector<double> f = density(slope, panels_[k].first, panels_[k].rule.rule->size());
        const Estimate<double> sum = panel_cauchy(panels_[k], slope, at, between, f.data());
        total.value += sum.value;
        total.error += sum.error;
      };
      const Estimate<double> far = nodes->around(y_->problem().slopes()[slope], at, near);
      return {total.value + far.value, total.error + far.error};
    }
  }
  const std::vector<R>& f = density(slope);
  const auto add = [&](std::size_t segment, const R& between) {
    if (!set.in_contact(segment) || y_->slope_at(segment) == slope) return;
    for (std::size_t k = first_panel_[segment]; k < first_panel_[segment + 1]; ++k) {
      const Estimate<R> part = panel_cauchy(panels_[k], slope, at, between, &f[panels_[k].first]);
      total.value += part.value;
      total.error += part.error;
    }
  };
  R between = at.node.from_right;
  for (auto k = static_cast<std::size_t>(at.segment + 1); k < set.segments(); ++k) {
    add(k, between);
    between += set.length(k);
  }
  between = at.node.from_left;
  for (std::ptrdiff_t k = at.segment; k-- > 0;) {
    add(static_cast<std::size_t>(k), between);
    between += set.length(static_cast<std::size_t>(k));
  }
  return total;
}

template <Real R>
const DistantNodes* ContactQuadrature<R>::distant() const {
  if constexpr (std::same_as<R, double>) {
    if (distant_ || panels_.size() < hierarchical::fewest_panels || ++evaluations_ <= direct_evaluations) {
      return distant_.get();
    }
    DistantNodes::Panels panels;
    for (const Panel& panel : panels_) {
      panels.parts.push_back(panel.rule.part);
      panels.first_node.push_back(panel.first);
    }
    distant_ = std::make_shared<const DistantNodes>(*y_, panels, nodes_, node_weights_);
    return distant_.get();
  } else {
    return nullptr;
  }
}

template <Real R>
std::vector<R> ContactQuadrature<R>::moments(const R& tilt, std::size_t count) const {
  std::vector<R> result(count, R(0));
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const R& x = nodes_[i].node.x;
    const std::size_t own = y_->slope_at(static_cast<std::size_t>(nodes_[i].segment));
    subtract_powers(result, node_weights_[i] * (y_->problem().slope(own, x) + tilt) / pi<R>(), x);
  }
  return result;
}

template <Real R>
void ContactQuadrature<R>::add_difference_moments(std::size_t slope, std::vector<R>& moments) const {
  const std::vector<R>& f = density(slope);
  for (std::size_t i = 0; i < f.size(); ++i) subtract_powers(moments, f[i] / pi<R>(), nodes_[i].node.x);
}

template class ContactQuadrature<double>;
template class ContactQuadrature<Real50>;
template class ContactQuadrature<Real100>;

}  // namespace steadyslide::numeric
