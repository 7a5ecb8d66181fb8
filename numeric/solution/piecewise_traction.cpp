#include "numeric/solution/piecewise_traction.hpp"

#include <algorithm>
#include <cmath>

#include "numeric/number/power_product.hpp"

namespace steadyslide::numeric {
namespace {

/// Divides a part with a corner at one end: halves it towards the corner until the rest is negligible. The result is
/// ordered from left to right.
template <Real R>
std::vector<GradedPanel<R>> towards_corner(GradedPanel<R> part) {
  const Side corner = *part.singular_end;
  std::vector<GradedPanel<R>> result;
  const R last = epsilon<R>() * part.length;
  while (part.length > last) {
    const R half = part.length / 2;
    GradedPanel<R> outer = part;
    outer.length = part.length = half;
    outer.singular_end.reset();
    (corner == Side::left ? outer.from_left : outer.from_right) += half;
    (corner == Side::left ? part.from_right : part.from_left) += half;
    result.push_back(outer);
  }
  result.push_back(part);
  if (corner == Side::left) std::reverse(result.begin(), result.end());
  return result;
}

/// Replaces values[i] by g(values[i]), where g is a series of Chebyshev's polynomials of 2y - 1.
template <Real R>
void evaluate(std::span<const R> coefficients, std::span<R> values) {
  if (coefficients.size() == 1) {
    std::fill(values.begin(), values.end(), coefficients[0]);
    return;
  }
  // Clenshaw's recurrence, for several places together.
  constexpr std::size_t most = 32;
  R one[most], two[most], twice[most];
  for (std::size_t begin = 0; begin < values.size(); begin += most) {
    const std::size_t n = std::min(most, values.size() - begin);
    R* y = values.data() + begin;
    for (std::size_t i = 0; i < n; ++i) {
      twice[i] = 4 * y[i] - 2;
      one[i] = two[i] = 0;
    }
    for (std::size_t k = coefficients.size() - 1; k > 0; --k) {
      const R& c = coefficients[k];
      for (std::size_t i = 0; i < n; ++i) {
        const R next = (c - two[i]) + twice[i] * one[i];
        two[i] = one[i];
        one[i] = next;
      }
    }
    for (std::size_t i = 0; i < n; ++i) y[i] = (coefficients[0] - two[i]) + twice[i] * one[i] / 2;
  }
}

/// Computes y^power; in double by vectorised logarithms.
template <Real R>
std::vector<R> powers_of(std::span<const R> y, const R& power) {
  std::vector<R> result(y.begin(), y.end());
  if constexpr (std::same_as<R, double>) {
    const PowerFactor factor(0, power);
    power_products({&factor, 1}, {}, y, y, result);
  } else {
    for (R& value : result) value = pow(value, power);
  }
  return result;
}

}  // namespace

template <Real R>
PiecewiseTraction<R>::PiecewiseTraction(Elasticity elasticity, int degree)
    : elasticity_(std::move(elasticity)), rules_(std::make_shared<JacobiRules<R>>()) {
  const R digits = -log(epsilon<R>());
  degree_ = static_cast<std::size_t>(static_cast<int>(digits / log(3 + sqrt(R(8)))) + 4 + degree);
  // For a double pole at one panel length above the middle.
  rule_size_ = static_cast<int>(digits / (2 * log(2 + sqrt(R(5))))) + 5 + (degree + 1) / 2;
  legendre_ = &rules_->get({}, {}, rule_size_);
  const int n = static_cast<int>(degree_) + 1;
  for (int k = 0; k < 4 * n; ++k) cosines_.push_back(cos(pi<R>() * k / (2 * n)));
  for (int i = 0; i < n; ++i) positions_.push_back(chebyshev_position<R>(i, n));
}

template <Real R>
std::vector<R> PiecewiseTraction<R>::chebyshev_series(const std::vector<R>& values) const {
  const std::size_t n = values.size();
  std::vector<R> series(n);
  for (std::size_t k = 0; k < n; ++k) {
    // 2y - 1 = -cos((2i + 1) pi/2n).
    for (std::size_t i = 0; i < n; ++i) series[k] += values[i] * cosines_[k * (2 * i + 1) % (4 * n)];
    series[k] *= R(k % 2 == 0 ? 2 : -2) / static_cast<double>(n);
  }
  series[0] /= 2;
  return series;
}

template <Real R>
void PiecewiseTraction<R>::add(const SurfacePlace<R>& left, const SurfacePlace<R>& right, const R& length,
                               const R& traction, const R& shear_ratio) {
  segments_.push_back(panels_.size());
  panels_.push_back({left,
                     right,
                     length,
                     std::nullopt,
                     {},
                     legendre_,
                     coefficients_.size(),
                     1,
                     shear_ratio,
                     R(16 * epsilon<R>()),
                     R(0)});
  coefficients_.push_back(traction);
}

template <Real R>
void PiecewiseTraction<R>::add(const TractionSegment<R>& segment) {
  segments_.push_back(panels_.size());
  for (const GradedPanel<R>& part : graded_panels(segment.length, segment.around)) {
    const bool at_left = part.singular_end == Side::left;
    const Power<R> power = !part.singular_end ? Power<R>{} : at_left ? segment.left_power : segment.right_power;
    if (!part.singular_end || !(at_left ? segment.left_corner : segment.right_corner)) {
      add_panel(segment, part, power);
      continue;
    }
    add_corner(segment, part);
  }
}

template <Real R>
void PiecewiseTraction<R>::add_corner(const TractionSegment<R>& segment, const GradedPanel<R>& part) {
  const bool at_left = part.singular_end == Side::left;
  const Power<R>& power = at_left ? segment.left_power : segment.right_power;
  const auto& q = at_left ? segment.left_corner : segment.right_corner;
  // Written as y^p g + q (1 - y^p), or g + q log y, nothing cancels, also for a large q.
  const auto beside = [&](const R& y) {
    const R logarithm = log(y);
    const R factor = power.value == 0 ? logarithm : R(-expm1(R(power.value * logarithm)));
    return R(q(y * part.length) * factor);
  };
  std::vector<R> y, from_left, from_right, values(degree_ + 1);
  for (const auto& [near, far] : positions_) {
    y.push_back(near);
    from_left.push_back(part.from_left + part.length * (at_left ? near : far));
    from_right.push_back(part.from_right + part.length * (at_left ? far : near));
  }
  segment.tractions(from_left, from_right, values);
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = (values[i] - beside(y[i])) / pow(y[i], power.value);
  const std::vector<R> series = chebyshev_series(values);

  TractionSegment<R> local = segment;
  local.tractions = [&](std::span<const R> left, std::span<const R> right, std::span<R> result) {
    for (std::size_t i = 0; i < result.size(); ++i) result[i] = (at_left ? left[i] : right[i]) / part.length;
    std::vector<R> ys(result.begin(), result.end());
    evaluate<R>(series, result);
    for (std::size_t i = 0; i < result.size(); ++i) result[i] = pow(ys[i], power.value) * result[i] + beside(ys[i]);
  };
  // Beside a constant, a power that vanishes is negligible.
  const Power<R> kept = power.value < 0 ? power : Power<R>{};
  for (const GradedPanel<R>& smaller : towards_corner(part)) add_panel(local, smaller, kept);
}

template <Real R>
void PiecewiseTraction<R>::add_panel(const TractionSegment<R>& segment, const GradedPanel<R>& part,
                                     const Power<R>& power) {
  const bool mirrored = part.singular_end == Side::right;
  const bool is_power = part.singular_end && power.value != 0;
  std::vector<R> y, from_left, from_right, values(degree_ + 1);
  for (const auto& [near, far] : positions_) {
    y.push_back(near);
    from_left.push_back(part.from_left + part.length * (mirrored ? far : near));
    from_right.push_back(part.from_right + part.length * (mirrored ? near : far));
  }
  segment.tractions(from_left, from_right, values);
  for (std::size_t i = 0; is_power && i < values.size(); ++i) values[i] /= pow(y[i], power.value);
  values = chebyshev_series(values);
  const R half = part.length / 2;
  const R end_error = !is_power ? R(0) : mirrored ? segment.right_error : segment.left_error;
  // The error at the middle, and the change due to displaced ends.
  const R error = segment.relative_error(part.from_left + half, part.from_right + half) + 2 * end_error / part.length;
  const auto place = [&](const R& left, const R& right) {
    return left <= right ? segment.left.moved(left) : segment.right.moved(-right);
  };
  TractionPanel<R> panel{place(part.from_left, part.from_right + part.length),
                         place(part.from_left + part.length, part.from_right),
                         part.length,
                         is_power ? part.singular_end : std::nullopt,
                         is_power ? power : Power<R>{},
                         legendre_,
                         coefficients_.size(),
                         values.size(),
                         segment.shear_ratio,
                         error,
                         end_error};
  if (is_power) panel.rule = &rules_->get(power, {}, rule_size_);
  // If there is no power, y is measured from the left.
  for (std::size_t k = 1; mirrored && !is_power && k < values.size(); k += 2) values[k] = -values[k];
  coefficients_.insert(coefficients_.end(), values.begin(), values.end());
  panels_.push_back(std::move(panel));
}

template <Real R>
void PiecewiseTraction<R>::append_rule(const TractionPanel<R>& panel, const PanelPart<R>& part,
                                       const GradedPanel<R>& of_part, TractionNodes<R>& nodes) const {
  const bool touches = of_part.singular_end.has_value();
  const bool mirrored = of_part.singular_end == Side::right;
  const UnitRule<R>& rule = touches ? *panel.rule : *legendre_;
  const bool from_right = panel.singular_end == Side::right;
  const std::span<const R> series = std::span(coefficients_).subspan(panel.first, panel.count);
  const std::size_t begin = nodes.forces.size();
  for (std::size_t i = 0; i < rule.size(); ++i) {
    const R left = of_part.from_left + of_part.length * (mirrored ? rule.from_right[i] : rule.from_left[i]);
    const R right = of_part.from_right + of_part.length * (mirrored ? rule.from_left[i] : rule.from_right[i]);
    nodes.from_left.push_back(left);
    nodes.from_right.push_back(right);
    nodes.forces.push_back((from_right ? part.from_right + right : part.from_left + left) / panel.length);
  }
  const std::span<R> forces = std::span(nodes.forces).subspan(begin);
  R factor = of_part.length;
  if (touches) {
    if (of_part.length != panel.length) factor *= pow(R(of_part.length / panel.length), panel.power.value);
    evaluate<R>(series, forces);
    for (std::size_t i = 0; i < rule.size(); ++i) forces[i] *= factor * rule.weights[i];
    return;
  }
  std::vector<R> powers;
  if (panel.singular_end) powers = powers_of<R>(forces, panel.power.value);
  evaluate<R>(series, forces);
  for (std::size_t i = 0; i < rule.size(); ++i) {
    forces[i] *= factor * rule.weights[i];
    if (panel.singular_end) forces[i] *= powers[i];
  }
}

template <Real R>
void PiecewiseTraction<R>::append_nodes(const TractionPanel<R>& panel, TractionNodes<R>& nodes) const {
  append_rule(panel, {R(0), panel.length, R(0)}, {R(0), R(0), panel.length, panel.singular_end}, nodes);
}

template <Real R>
void PiecewiseTraction<R>::append_nodes(const TractionPanel<R>& panel, const PanelPart<R>& part,
                                        TractionNodes<R>& nodes) const {
  Surroundings<R> around{false, false, part.beyond_left, part.beyond_right};
  if (panel.singular_end == Side::left) {
    around.left_singular = part.from_left == 0;
    if (part.from_left > 0) around.beyond_left = std::min(around.beyond_left, part.from_left);
  }
  if (panel.singular_end == Side::right) {
    around.right_singular = part.from_right == 0;
    if (part.from_right > 0) around.beyond_right = std::min(around.beyond_right, part.from_right);
  }
  for (const GradedPanel<R>& graded : graded_panels(part.length, around)) append_rule(panel, part, graded, nodes);
}

STEADYSLIDE_INSTANTIATE_CLASS(PiecewiseTraction)

}  // namespace steadyslide::numeric
