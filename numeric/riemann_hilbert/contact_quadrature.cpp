#include "numeric/riemann_hilbert/contact_quadrature.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "numeric/cauchy/second_kind.hpp"
#include "numeric/number/compensated_sum.hpp"
#include "numeric/number/mapped.hpp"

namespace steadyslide::numeric {
namespace {

/// All densities are kept up to this many numbers.
constexpr std::size_t most_kept = 4'000'000;

/// After this number of sums over all sources, moments are not more expensive.
constexpr std::size_t worth_while = 48;

/// Adds -term x^j to sum j.
template <Real R>
void subtract_powers(std::vector<EstimateSum<R>>& moments, Estimate<R> term, const R& x) {
  for (EstimateSum<R>& m : moments) {
    m.add(-term);
    term *= x;
  }
}

template <Real R>
std::vector<Estimate<R>> values_of(const std::vector<EstimateSum<R>>& sums) {
  return mapped(sums, [](const EstimateSum<R>& sum) { return sum.value(); });
}

/// Returns the limit of int_0^1 y^a/(y + d) dy for d -> 0 without its singular term, which is -pi d^a/sin(pi a), or
/// -log(d length) for a = 0.
template <Real R>
R regular_second_kind(const Power<R>& a, const R& length) {
  return a.value == 0 ? log(length) : 1 / a.value;
}

/// Returns eps cos(pi alpha), where eps is that of Y.
template <Real R>
R common_factor(const SignedFundamentalSolution<R>& y, std::size_t segment) {
  const R own = y.traction_factor(segment);
  if (y.pivots().empty()) return own;
  const auto& pivot = y.pivots()[y.component_of(segment)];
  return pivot.order != 0 && segment < pivot.point ? R(-own) : own;
}

}  // namespace

template <Real R>
ContactQuadrature<R>::ContactQuadrature(const SignedFundamentalSolution<R>& y, JacobiRules<R>& rules)
    : y_(&y), densities_(y.problem().slopes().size()), distant_(densities_.size()) {
  const ContactSet<R>& set = y.set();
  if (y.problem().slopes().size() <= 1 && set.components() <= 1) return;
  const auto power_at = [&y](std::size_t j) {
    const R& p = y.highest_power(j).value;
    return Power<R>{-p, 1 - p};
  };
  for (std::size_t segment = 0; segment < set.segments(); ++segment) {
    first_panel_.push_back(panels_.size());
    if (!set.in_contact(segment)) continue;
    // Y is the Y_i of the component, without pivots and for all components beyond them.
    const R amplitude = common_factor(y, segment);
    for (const JacobiPanel<R>& panel :
         jacobi_panels<R>(y, whole_segment(set, segment), SmoothFactor::polynomial, power_at, rules)) {
      panels_.push_back({panel, nodes_.size()});
      for (std::size_t i = 0; i < panel.rule->size(); ++i) {
        nodes_.push_back(panel.node(set, i));
        node_weights_.push_back(amplitude * panel.node_weight(i) / y.common_modulus(nodes_.back()));
      }
    }
  }
  first_panel_.push_back(panels_.size());
}

template <Real R>
std::vector<R> ContactQuadrature<R>::distances_to(std::size_t point, std::size_t first, std::size_t end) const {
  const ContactSet<R>& set = y_->set();
  const std::size_t from = first_node(first);
  std::vector<R> result(first_node(end) - from);
  R between = 0;
  for (std::size_t k = point; k-- > first;) {
    for (std::size_t i = first_node(k); k < end && i < first_node(k + 1); ++i) {
      result[i - from] = -(between + nodes_[i].node.from_right);
    }
    between += set.length(k);
  }
  between = 0;
  for (std::size_t k = point; k < end; ++k) {
    for (std::size_t i = first_node(k); k >= first && i < first_node(k + 1); ++i) {
      result[i - from] = between + nodes_[i].node.from_left;
    }
    between += set.length(k);
  }
  return result;
}

template <Real R>
std::vector<R> ContactQuadrature<R>::weights_beside(std::size_t component, std::size_t first, std::size_t end) const {
  const auto begin = node_weights_.begin();
  std::vector<R> result(begin + static_cast<std::ptrdiff_t>(first_node(first)),
                        begin + static_cast<std::ptrdiff_t>(first_node(end)));
  const auto& pivot = y_->pivots()[component];
  if (pivot.order == 0) return result;
  const std::vector<R> distances = distances_to(pivot.point, first, end);
  for (std::size_t i = 0; i < result.size(); ++i) {
    pivot.order > 0 ? result[i] /= distances[i] : result[i] *= distances[i];
  }
  return result;
}

template <Real R>
auto ContactQuadrature<R>::density(std::size_t slope, const R* weights, std::size_t first, std::size_t count) const
    -> Density {
  Density result{std::vector<R>(count, R(0)), std::vector<double>(count, 0)};
  const RoundedProblem<R>& problem = y_->problem();
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t own = y_->slope_at(static_cast<std::size_t>(nodes_[first + i].segment));
    if (own == slope) continue;
    const R& x = nodes_[first + i].node.x;
    result.values[i] = weights[i] * (problem.slope(own, x) - problem.slope(slope, x));
    const double size = problem.slope_size(own, x) + problem.slope_size(slope, x);
    result.rounding[i] = abs(static_cast<double>(weights[i])) * size / 4;
  }
  return result;
}

template <Real R>
auto ContactQuadrature<R>::density(std::size_t slope, std::size_t component) const -> const Density& {
  const bool has_pivots = !y_->pivots().empty();
  Density& result = has_pivots ? last_density_ : densities_[slope];
  if (nodes_.empty()) return result;
  if (!has_pivots) {
    if (!result.values.empty()) return result;
    if (densities_.size() * nodes_.size() > most_kept && slope != last_slope_) densities_[last_slope_] = {};
    last_slope_ = slope;
    return result = density(slope, node_weights_.data(), 0, nodes_.size());
  }
  if (last_component_ != component || last_weights_.empty()) {
    last_component_ = component;
    last_weights_ = weights_beside(component, 0, y_->set().segments());
    result = {};
  }
  if (last_slope_ != slope) result = {};
  last_slope_ = slope;
  if (result.values.empty()) result = density(slope, last_weights_.data(), 0, nodes_.size());
  return result;
}

template <Real R>
const DistantSum<R>* ContactQuadrature<R>::distant_sum(const Panel& panel, std::size_t slope, const R* density) const {
  if constexpr (!std::same_as<R, double>) {
    if (!y_->pivots().empty() || densities_.size() * nodes_.size() > most_kept) return nullptr;
    std::vector<DistantPanel>& of_slope = distant_[slope];
    of_slope.resize(panels_.size());
    DistantPanel& distant = of_slope[static_cast<std::size_t>(&panel - panels_.data())];
    if (++distant.asked == worth_while) {
      const bool mirrored = panel.rule.singular_end == Side::right;
      const UnitRule<R>& rule = *panel.rule.rule;
      distant.sum = DistantSum<R>(mirrored ? rule.from_right : rule.from_left, density);
    }
    if (distant.asked >= worth_while) return &distant.sum;
  }
  return nullptr;
}

template <Real R>
GradedSum<R>* ContactQuadrature<R>::graded_sum(std::size_t segment, Side end, std::size_t slope,
                                               const Density& density) const {
  if constexpr (!std::same_as<R, double>) {
    constexpr std::size_t many_panels = 48;
    const std::size_t first = first_panel_[segment];
    const std::size_t count = first_panel_[segment + 1] - first;
    if (!y_->pivots().empty() || count < many_panels) return nullptr;
    GradedSegment& graded = graded_[{slope, segment, end}];
    if (++graded.asked == worth_while) {
      const bool from_left = end == Side::left;
      std::vector<typename GradedSum<R>::Panel> panels;
      for (std::size_t n = 0; n < count; ++n) {
        const Panel& panel = panels_[from_left ? first + n : first + count - 1 - n];
        const R& begin = from_left ? panel.rule.part.from_left : panel.rule.part.from_right;
        auto& made =
            panels.emplace_back(typename GradedSum<R>::Panel{begin, begin + panel.rule.part.length, {}, {}, {}});
        for (std::size_t i = panel.first; i < panel.first + panel.rule.rule->size(); ++i) {
          made.y.push_back(from_left ? nodes_[i].node.from_left : nodes_[i].node.from_right);
          made.f.push_back(density.values[i]);
          made.rounding.push_back(density.rounding[i]);
        }
      }
      graded.sum = GradedSum<R>(std::move(panels));
    }
    if (graded.asked >= worth_while) return &graded.sum;
  }
  return nullptr;
}

template <Real R>
auto ContactQuadrature<R>::local_sum(std::size_t slope, std::size_t component, const SurfacePoint<R>& at,
                                     const Density& density) const -> const Local* {
  if constexpr (!std::same_as<R, double>) {
    constexpr std::size_t worth_a_series = 24;
    const ContactSet<R>& set = y_->set();
    const auto segments = static_cast<std::ptrdiff_t>(set.segments());
    if (y_->pivots().empty() || at.segment < 0 || at.segment >= segments) return nullptr;
    if (local_.segment != at.segment || local_.component != component || local_.slope != slope) {
      local_ = {at.segment, component, slope, 0, R(0), R(0), {}, {}, 0};
    }
    if (++local_.asked < worth_a_series) return nullptr;
    if (!local_.is_far.empty()) return &local_;
    const auto here = static_cast<std::size_t>(at.segment);
    const bool left = y_->component_at(beside(set, here, Side::right, R(0))) == component;
    const bool right = y_->component_at(beside(set, here + 1, Side::left, R(0))) == component;
    const R half = set.length(here) / 2;
    local_.begin = left ? R(0) : half;
    local_.length = left && right ? set.length(here) : half;
    local_.is_far.assign(set.segments(), 0);
    const auto add = [&](std::size_t k, const R& between, bool is_right) {
      if (!set.in_contact(k) || y_->slope_at(k) == slope || 2 * between < local_.length) return;
      local_.is_far[k] = 1;
      for (std::size_t i = first_node(k); i < first_node(k + 1); ++i) {
        const R d = between + (is_right ? nodes_[i].node.from_left : nodes_[i].node.from_right);
        local_.sum.add(density.values[i], d / local_.length, is_right);
        local_.rounding += density.rounding[i] / static_cast<double>(d);
      }
    };
    R between = set.length(here) - local_.begin - local_.length;
    for (std::size_t k = here + 1; k < set.segments(); between += set.length(k++)) add(k, between, true);
    between = local_.begin;
    for (std::size_t k = here; k-- > 0; between += set.length(k)) add(k, between, false);
    return &local_;
  }
  return nullptr;
}

template <Real R>
Estimate<R> ContactQuadrature<R>::panel_cauchy(const Panel& panel, std::size_t slope, std::size_t component,
                                               const SurfacePoint<R>& at, const R& between, const R* density,
                                               const double* rounding) const {
  const SegmentPart<R>& part = panel.rule.part;
  const UnitRule<R>& rule = *panel.rule.rule;
  const bool panel_is_right = at.segment < static_cast<std::ptrdiff_t>(part.segment);
  const std::size_t count = rule.size();
  const R gap = between + (panel_is_right ? part.from_left : part.from_right);
  R sum = 0;
  double size = 0;  // double is sufficient for sizes
  if (2 * gap >= part.length) {
    if (const DistantSum<R>* distant = distant_sum(panel, slope, density)) {
      sum = distant->value(gap / part.length, !panel_is_right) / part.length;
      size = distant->size() / static_cast<double>(gap);
    } else {
      R to_node, term;
      for (std::size_t i = 0; i < count; ++i) {
        const Node<R>& node = nodes_[panel.first + i].node;
        to_node = between;
        to_node += panel_is_right ? node.from_left : node.from_right;
        term = density[i];
        term /= to_node;
        sum += term;
        size += abs(static_cast<double>(term));
      }
    }
    size += std::accumulate(rounding, rounding + count, 0.0) / static_cast<double>(gap);
  } else {
    // Integrate phi(y) y^a over the unit interval. y is measured from the end that faces the point; a power is at this
    // end: int y^a (phi(y) - phi(-d))/(y + d) + phi(-d) int y^a/(y + d), the last integral is the function of the
    // second kind.
    const R d = gap / part.length;
    const auto facing = static_cast<std::size_t>(panel_is_right ? part.segment : part.segment + 1);
    const R& p = y_->highest_power(facing).value;
    // At the end itself d^-p/|Y| is replaced by its limit.
    R phi = gap == 0 ? 1 / (y_->amplitude(facing) * pow(part.length, p)) : 1 / y_->modulus(at);
    if (gap > 0 && p != 0) phi *= pow(d, p);
    // If a is not the power of 1/|Y_i| at this end, the power of y^a phi is a + 1.
    if (y_->power(facing, component).value < p) phi = gap == 0 ? R(0) : R(-phi);
    const RoundedProblem<R>& problem = y_->problem();
    const std::size_t own = y_->slope_at(part.segment);
    phi *= y_->traction_factor(part.segment, component);
    const R& x = at.node.x;
    const double slope_size = problem.slope_size(own, x) + problem.slope_size(slope, x);
    const double phi_size = abs(static_cast<double>(phi)) * slope_size / 4;
    phi *= problem.slope(own, x) - problem.slope(slope, x);
    const R scaled = phi * part.length;
    const double scaled_size = phi_size * static_cast<double>(part.length);
    for (std::size_t i = 0; i < count; ++i) {
      const Node<R>& node = nodes_[panel.first + i].node;
      const R to_node = between + (panel_is_right ? node.from_left : node.from_right);
      const R term = (density[i] - scaled * rule.weights[i]) / to_node;
      sum += term;
      size += abs(static_cast<double>(term)) +
              (rounding[i] + scaled_size * static_cast<double>(rule.weights[i])) / static_cast<double>(to_node);
    }
    const R rest =
        gap == 0 ? regular_second_kind(panel.rule.power, part.length) : second_kind::left_of(panel.rule.power, d);
    sum += phi * rest;
    size += (abs(static_cast<double>(phi)) + phi_size) * abs(static_cast<double>(rest));
  }
  return {panel_is_right ? sum : -sum, R(size)};
}

template <Real R>
Estimate<R> ContactQuadrature<R>::sum_of_panels(std::size_t slope, std::size_t component, const SurfacePoint<R>& at,
                                                std::size_t first, std::size_t end, const Density& density) const {
  EstimateSum<R> total;
  const ContactSet<R>& set = y_->set();
  const Local* const local = local_sum(slope, component, at, density);
  if (local) {
    const R value = local->sum.value((at.node.from_left - local->begin) / local->length) / local->length;
    total.add({value, R(local->sum.size()) / local->length + local->rounding});
  }
  const auto add = [&](std::size_t segment, const R& between) {
    if (segment < first || segment >= end || !set.in_contact(segment) || y_->slope_at(segment) == slope) return;
    if (local && local->is_far[segment]) return;
    const std::size_t panel = first_panel_[segment];
    std::pair<std::size_t, std::size_t> near{panel, first_panel_[segment + 1]};
    const bool is_right = at.segment < static_cast<std::ptrdiff_t>(segment);
    if (auto* graded = graded_sum(segment, is_right ? Side::left : Side::right, slope, density)) {
      const auto far = graded->at(between);
      total.add({is_right ? far.value : R(-far.value), R(far.size)});
      near = is_right ? std::pair(panel + far.first, panel + far.end)
                      : std::pair(near.second - far.end, near.second - far.first);
    }
    for (std::size_t k = near.first; k < near.second; ++k) {
      const std::size_t node = panels_[k].first - first_node(first);
      total.add(
          panel_cauchy(panels_[k], slope, component, at, between, &density.values[node], &density.rounding[node]));
    }
  };
  R between = at.node.from_right;
  for (auto k = static_cast<std::size_t>(at.segment + 1); k < end; ++k) {
    add(k, between);
    between += set.length(k);
  }
  between = at.node.from_left;
  for (std::ptrdiff_t k = at.segment; k-- > static_cast<std::ptrdiff_t>(first);) {
    add(static_cast<std::size_t>(k), between);
    between += set.length(static_cast<std::size_t>(k));
  }
  return total.value();
}

template <Real R>
Estimate<R> ContactQuadrature<R>::cauchy(std::size_t slope, const SurfacePoint<R>& at) const {
  if (panels_.empty()) return {R(0), R(0)};
  const std::lock_guard lock(*making_);
  if constexpr (std::same_as<R, double>) {
    if (Cells* const by_cells = cells()) return cauchy_by_cells(*by_cells, slope, at);
  }
  const std::size_t component = y_->component_at(at);
  return sum_of_panels(slope, component, at, 0, y_->set().segments(), density(slope, component));
}

template <Real R>
std::vector<Estimate<R>> ContactQuadrature<R>::moments(const R& tilt, std::size_t count) const {
  std::vector<EstimateSum<R>> sums(count);
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const R& x = nodes_[i].node.x;
    const std::size_t own = y_->slope_at(static_cast<std::size_t>(nodes_[i].segment));
    const Estimate<R> g = y_->problem().slope_estimate(own, x) + Estimate<R>{tilt, R(0)};
    subtract_powers(sums, node_term<R>(node_weights_[i] / pi<R>(), g), x);
  }
  return values_of(sums);
}

template <Real R>
Estimate<R> ContactQuadrature<R>::pivot_moment(std::size_t component, const R& tilt) const {
  const std::lock_guard lock(*making_);
  if constexpr (std::same_as<R, double>) {
    if (const Cells* by_cells = cells()) return pivot_moment_by_cells(*by_cells, component, tilt);
  }
  const std::vector<R> distances = distances_to(y_->pivots()[component].point, 0, y_->set().segments());
  EstimateSum<R> sum;
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const std::size_t own = y_->slope_at(static_cast<std::size_t>(nodes_[i].segment));
    const Estimate<R> g = y_->problem().slope_estimate(own, nodes_[i].node.x) + Estimate<R>{tilt, R(0)};
    sum.add(node_term<R>(-node_weights_[i] / distances[i], g));
  }
  return sum.value() / pi<R>();
}

template <Real R>
std::vector<Estimate<R>> ContactQuadrature<R>::difference_moments(std::size_t slope, std::size_t count) const {
  const std::lock_guard lock(*making_);
  const Density& f = density(slope);
  std::vector<EstimateSum<R>> sums(count);
  for (std::size_t i = 0; i < f.values.size(); ++i) {
    const Estimate<R> term{f.values[i], 4 * epsilon<R>() * f.rounding[i]};
    subtract_powers(sums, node_term<R>(1 / pi<R>(), term), nodes_[i].node.x);
  }
  return values_of(sums);
}

STEADYSLIDE_INSTANTIATE_CLASS(ContactQuadrature)

}  // namespace steadyslide::numeric
