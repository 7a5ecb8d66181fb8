#include "numeric/closed_form/closed_form.hpp"

#include <algorithm>

#include "numeric/quadrature/tanh_sinh.hpp"
#include "numeric/solution/largest_pressure.hpp"

namespace steadyslide::numeric {
template <Real R>
ClosedForm<R>::ClosedForm(ContactProblem problem, ClosedFormData<R> data)
    : problem_(std::move(problem)), data_(std::move(data)) {}

template <Real R>
Estimate<R> ClosedForm<R>::coordinate(std::size_t j) const {
  using std::abs;
  if (data_.exact[j]) {
    const R x = to_real<R>(data_.origin + *data_.exact[j]);
    return {x, epsilon<R>() * abs(x)};
  }
  const R x = to_real<R>(data_.origin) + weight().point(j);
  return {x, data_.end_error + epsilon<R>() * (abs(x) + abs(weight().point(j)))};
}

/// Of |Y| in the middle of a panel, the ends' own error counted `times`.
template <Real R>
R ClosedForm<R>::relative_error(std::size_t panel, int times) const {
  const Panel<R>& p = weight().panel(panel);
  return weight().relative_error(panel, p.node_from_left(p.length / 2), times * data_.end_error);
}

template <Real R>
Estimate<R> ClosedForm<R>::intensity(std::size_t j) const {
  using std::abs, std::log;
  const std::size_t last = weight().panel_count();
  R theta = abs(data_.factor) * weight().amplitude(j);
  // At an end theta carries the cos(pi alpha) of the contact side; at a jump the definition takes it out.
  if (j == 0) theta = abs(data_.traction.amplitudes.front()) * weight().amplitude(j);
  if (j == last) theta = abs(data_.traction.amplitudes.back()) * weight().amplitude(j);
  return {theta, theta * relative_error(std::min(j, last - 1), 4)};
}

template <Real R>
std::vector<ContactComponent<R>> ClosedForm<R>::contact() const {
  const std::size_t last = weight().panel_count();
  const R width = weight().point(last) - weight().point(0);
  return {{{coordinate(0), data_.ends, data_.exponents.front(), intensity(0)},
           {coordinate(last), data_.ends, data_.exponents.back(), intensity(last)},
           {width, 2 * data_.end_error + 4 * epsilon<R>() * width}}};
}

template <Real R>
ApproximateContact ClosedForm<R>::approximate_contact() const {
  if (data_.ends == SingularKind::edge) return {{{problem_.indenter().left()}, {problem_.indenter().right()}}};
  const auto end = [&](std::size_t j) { return ApproximateContact::free_end(problem_, Rational(coordinate(j).value)); };
  return {{end(0), end(weight().panel_count())}};
}

template <Real R>
std::vector<SolvedSingularPoint<R>> ClosedForm<R>::singular_points() const {
  std::vector<SolvedSingularPoint<R>> points;
  const std::size_t last = weight().panel_count();
  for (std::size_t j = 0; j <= last; ++j) {
    const bool is_end = j == 0 || j == last;
    if (!is_end && data_.exponents[j].sign() == 0) continue;
    const Estimate<R> theta = intensity(j);
    const auto on_side = [&](std::size_t piece) {
      const R factor = is_end ? R(1) : cos_pi_alpha<R>(problem_.coupled_friction(data_.first_piece + piece));
      return stress_intensity_of<R>(factor * theta, weight().powers()[j].value);
    };
    StressIntensity<R> k;
    if (j > 0) k.left = on_side(j - 1);
    if (j < last) k.right = on_side(j);
    points.push_back({coordinate(j), is_end ? data_.ends : SingularKind::friction_jump, data_.exponents[j], theta,
                      Estimate<R>{}, k});
  }
  return points;
}

template <Real R>
const SurfaceCheck<R>& ClosedForm<R>::check() const {
  return check_([this] {
    std::vector<R> s;
    for (std::size_t k = 0; k < weight().panel_count(); ++k) {
      s.push_back(to_real<R>(problem_.coupled_friction(data_.first_piece + k)));
    }
    return SurfaceCheck<R>(data_.traction.density(), std::move(s),
                           [this](std::size_t, const Node<R>& node) { return profile_slope(node.x); });
  });
}

template <Real R>
Resultants<R> ClosedForm<R>::resultants() const {
  return resultants_([this] { return integrated(); });
}

template <Real R>
Resultants<R> ClosedForm<R>::integrated() const {
  using std::abs;
  std::vector<Estimate<R>> on_pieces(problem_.friction().values().size());
  for (std::size_t k = 0; k < loads().size(); ++k) on_pieces[data_.first_piece + k] = -loads()[k];
  Resultants<R> result = resultants_of(on_pieces, problem_.friction().values());
  result.component_load = {result.normal};

  // The moments of t are the coefficients of u' at infinity, and those are power sums of the singular points.
  R sum1 = 0, sum2 = 0, sum3 = 0, size = 0;
  for (std::size_t j = 0; j < data_.exponents.size(); ++j) {
    const R& p = weight().powers()[j].value;
    const R x = weight().point(j);
    sum1 += p * x;
    sum2 += p * x * x;
    sum3 += p * x * x * x;
    size = std::max(size, abs(x));
  }
  const R offset = data_.ends == SingularKind::edge ? -sum1 : 2 * sum3 / (3 * sum2);
  const R points = R(static_cast<double>(data_.exponents.size()));
  result.centre_of_pressure = {to_real<R>(data_.origin) + offset, 8 * points * (epsilon<R>() * size + data_.end_error) +
                                                                      epsilon<R>() * abs(to_real<R>(data_.origin))};
  return result;
}

template <Real R>
const std::vector<Estimate<R>>& ClosedForm<R>::loads() const {
  return loads_([this] {
    const PiecewiseDensity<R> density = data_.traction.density();
    std::vector<Estimate<R>> result;
    for (std::size_t k = 0; k < density.size(); ++k) {
      std::optional<Estimate<R>> load;
      if constexpr (!std::same_as<R, double>) load = check().panel_integral(k);
      if (!load) load = tanh_sinh::panel_integral(density[k]);
      result.push_back(load->widened(relative_error(k, 8)));
    }
    return result;
  });
}

template <Real R>
LargestPressure<R> ClosedForm<R>::largest_pressure() const {
  using std::abs;
  if (const auto infinite = infinite_pressure(singular_points())) return *infinite;
  std::vector<R> lengths;
  for (std::size_t k = 0; k < weight().panel_count(); ++k) lengths.push_back(weight().panel(k).length);
  // The pressure is 0 at free ends, and where friction falls.
  const PanelFunction<R> pressure = [this](std::size_t k, const R& left, const R& right) {
    const Node<R> node{weight().panel(k).left + left, left, right};
    return Estimate<R>{-traction(k, node), R(0)}.widened(weight().relative_error(k, node, data_.end_error));
  };
  const std::optional<Peak<R>> peak = highest_peak(lengths, pressure);
  if (!peak) return {};
  const R x = to_real<R>(data_.origin) + weight().panel(peak->panel).left + peak->from_left;
  return {peak->value, {x, peak->place_error + data_.end_error + 2 * epsilon<R>() * abs(x)}, std::nullopt};
}

template <Real R>
EstimatedError<R> ClosedForm<R>::estimated_error() const {
  using std::abs, std::max;
  EstimatedError<R> worst{0, 0, 0};
  const R width = weight().point(weight().panel_count()) - weight().point(0);
  worst.ends = max(data_.end_error / width, epsilon<R>());
  for (std::size_t k = 0; k < weight().panel_count(); ++k) {
    worst.traction = max(worst.traction, relative_error(k, 1));
  }
  const Resultants<R> r = resultants();
  worst.resultants = r.normal.error / r.normal.value;
  return worst;
}

template <Real R>
R ClosedForm<R>::profile_slope(const R& from_origin) const {
  return data_.ends == SingularKind::edge ? R(0) : data_.factor * from_origin;
}

template <Real R>
R ClosedForm<R>::gap_length(Side side) const {
  if (data_.ends == SingularKind::edge) return 0;
  const Indenter& indenter = problem_.indenter();
  const R length = side == Side::left
                       ? weight().point(0) - to_real<R>(indenter.left() - data_.origin)
                       : to_real<R>(indenter.right() - data_.origin) - weight().point(weight().panel_count());
  return std::max(length, R(0));
}

template <Real R>
Residuals<R> ClosedForm<R>::residuals() const {
  using std::abs, std::max;
  const R load = to_real<R>(problem_.load());
  const R width = weight().point(weight().panel_count()) - weight().point(0);
  Residuals<R> result;
  result.equation = check().equation();
  result.load = abs(check().integral() + load) / load;
  R deepest = 0;
  for (const Side side : {Side::left, Side::right}) {
    const R length = gap_length(side);
    if (length == 0) continue;
    for (const R& part : gap_places<R>()) {
      const R distance = length * part;
      const std::size_t panel = side == Side::left ? 0 : weight().panel_count() - 1;
      const R end = weight().point(side == Side::left ? 0 : weight().panel_count());
      const R x = side == Side::left ? end - distance : end + distance;
      const R rise = distance * (side == Side::left ? R(-1) : R(1)) * (profile_slope(end) + profile_slope(x)) / 2;
      deepest = max(deepest, check().penetration(panel, side, distance, rise));
    }
  }
  // Reduced (divided by c), and so is the bound c P / c.
  result.penetration = deepest / load;
  result.tension = max(check().highest_traction(), R(0)) * width / load;
  return result;
}

template <Real R>
PiecewiseTraction<R> ClosedForm<R>::piecewise_traction() const {
  const std::vector<Power<R>>& powers = weight().powers();
  const std::size_t panels = weight().panel_count();
  std::vector<SurfacePlace<R>> places;
  for (std::size_t j = 0; j <= panels; ++j) {
    places.push_back(SurfacePlace<R>::of(data_.origin + data_.exact[j].value_or(Rational(weight().point(j)))));
  }
  const auto length = [&](std::size_t k) { return k < panels ? weight().panel(k).length : infinity<R>(); };
  PiecewiseTraction<R> result(problem_.elasticity());
  for (std::size_t k = 0; k < panels; ++k) {
    const Surroundings<R> around{powers[k].value != 0, powers[k + 1].value != 0, length(k == 0 ? panels : k - 1),
                                 length(k + 1)};
    result.add({places[k], places[k + 1], length(k), around, powers[k], powers[k + 1], nullptr, nullptr,
                to_real<R>(problem_.shear_ratio(data_.first_piece + k)),
                [&, k](std::span<const R> from_left, std::span<const R> from_right, std::span<R> values) {
                  data_.traction(k, from_left, from_right, values);
                },
                [&, k](const R& from_left, const R& from_right) {
                  const Node<R> node{weight().point(k) + from_left, from_left, from_right};
                  return R(16 * epsilon<R>() + weight().relative_error(k, node, 2 * data_.end_error));
                },
                k == 0 ? data_.end_error : R(0), k + 1 == panels ? data_.end_error : R(0)});
  }
  return result;
}

template <Real R>
const TractionIntegrals<R>& ClosedForm<R>::integrals() const {
  return integrals_([this] {
    std::vector<typename TractionIntegrals<R>::OnPanel> on_panels;
    for (std::size_t k = 0; k < weight().panel_count(); ++k) {
      // An eighth of a panel from its ends.
      R error = 0;
      for (const R& part : {R(0.125), R(0.875)}) {
        const Panel<R>& panel = weight().panel(k);
        error = std::max(error, weight().relative_error(k, panel.node_from_left(part * panel.length), data_.end_error));
      }
      on_panels.push_back({loads()[k], error, to_real<R>(problem_.coupled_friction(data_.first_piece + k)),
                           problem_.shear_ratio(data_.first_piece + k)});
    }
    return TractionIntegrals<R>(data_.traction.density(), std::move(on_panels),
                                to_real<R>(problem_.elasticity().gamma()), *this, R(1));
  });
}

#define STEADYSLIDE_INSTANTIATE(R) template class ClosedForm<R>;
STEADYSLIDE_FOR_EACH_REAL(STEADYSLIDE_INSTANTIATE)
#undef STEADYSLIDE_INSTANTIATE

}  // namespace steadyslide::numeric
