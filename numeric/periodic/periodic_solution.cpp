#include "numeric/periodic/periodic_solution.hpp"

#include <algorithm>

#include "numeric/cauchy/residuals.hpp"
#include "numeric/number/mapped.hpp"
#include "numeric/quadrature/tanh_sinh.hpp"
#include "numeric/solution/largest_pressure.hpp"

namespace steadyslide::numeric {
template <Real R>
PeriodicSolution<R>::PeriodicSolution(ContactProblem problem, PeriodicContact<R> found)
    : problem_(std::move(problem)),
      compliance_(to_real<R>(problem_.elasticity().compliance())),
      found_(std::move(found)) {}

template <Real R>
bool PeriodicSolution<R>::is_free(std::size_t point) const {
  return point == 0 ? found_.left_is_free : point == gap() && found_.right_is_free;
}

template <Real R>
Estimate<R> PeriodicSolution<R>::place(std::size_t point) const {
  const R x = to_real<R>(found_.points[point]);
  return {x, epsilon<R>() * abs(x) + (is_free(point) ? found_.end_error : R(0))};
}

template <Real R>
Exponent PeriodicSolution<R>::exponent(std::size_t point) const {
  const auto s = [&](std::size_t arc) { return problem_.coupled_friction(piece(arc)); };
  const auto of_end = is_free(point) ? free_exponent : edge_exponent;
  if (point == 0) return of_end(End::left, s(0));
  if (point == gap()) return of_end(End::right, s(point - 1));
  return jump_exponent(s(point - 1), s(point));
}

template <Real R>
R PeriodicSolution<R>::relative_error(std::size_t arc, const R& from_left, const R& from_right) const {
  const R middle = weight().point(arc) + from_left;
  const auto [value, size] = traction().polynomial(middle);
  const R terms = R(static_cast<double>(4 * weight().size() + 4 * traction().tau.size() + 8));
  R error = terms * epsilon<R>() * max(R(1), size / abs(value));
  if (found_.end_error == 0) return error;
  // The nearer free end; T changes with the ends, too.
  R nearest = weight().period() / static_cast<double>(1 + 2 * traction().tau.size());
  for (const std::size_t end : {std::size_t{0}, gap()}) {
    if (!is_free(end)) continue;
    R distance = end == (arc == gap() ? gap() : 0) ? from_left : from_right;
    if (arc != gap()) {
      distance = end == 0 ? R(middle - weight().point(0)) : R(weight().point(gap()) - middle);
      if (end == 0 && arc == 0) distance = from_left;
      if (end == gap() && arc + 1 == gap()) distance = from_right;
    }
    nearest = min(nearest, abs(distance));
  }
  return error + 2 * found_.end_error / nearest;
}

template <Real R>
Estimate<R> PeriodicSolution<R>::intensity(std::size_t point) const {
  const auto [value, size] = traction().polynomial(weight().point(point));
  R theta = weight().amplitude(point) * value;
  // At an end theta contains cos(pi alpha) of the contact side; at a jump its definition does not contain it.
  if (point == 0) theta *= traction().cosines.front();
  if (point == gap()) theta *= traction().cosines.back();
  const std::size_t arc = min(point, gap() - 1);
  const R half = weight().arc(arc) / 2;
  const R rounding = 32 * static_cast<double>(weight().size()) * epsilon<R>() * size / abs(value);
  return {theta, theta * (rounding + 4 * relative_error(arc, half, half))};
}

template <Real R>
std::vector<ContactComponent<R>> PeriodicSolution<R>::contact() const {
  const std::size_t last = gap();
  const R width = weight().period() - weight().arc(last);
  const R error = 2 * found_.end_error + 4 * epsilon<R>() * width;
  return {{{place(0), end_of(0), exponent(0), intensity(0)},
           {place(last), end_of(last), exponent(last), intensity(last)},
           {width, error}}};
}

template <Real R>
ApproximateContact PeriodicSolution<R>::approximate_contact() const {
  if (begin() != problem_.indenter().left()) return {};
  const auto end = [&](std::size_t point) {
    if (is_free(point)) return ApproximateContact::free_end(problem_, found_.points[point]);
    return ApproximateContact::End{found_.points[point]};
  };
  return {{end(0), end(gap())}};
}

template <Real R>
std::vector<SolvedSingularPoint<R>> PeriodicSolution<R>::singular_points() const {
  std::vector<SolvedSingularPoint<R>> points;
  const std::size_t last = gap();
  for (std::size_t j = 0; j <= last; ++j) {
    const bool is_end = j == 0 || j == last;
    const Exponent power = exponent(j);
    if (!is_end && power.sign() == 0) continue;
    const Estimate<R> theta = intensity(j);
    const auto on_side = [&](std::size_t arc) {
      return stress_intensity_of<R>((is_end ? R(1) : traction().cosines[arc]) * theta, weight().power(j).value);
    };
    StressIntensity<R> k;
    if (j > 0) k.left = on_side(j - 1);
    if (j < last) k.right = on_side(j);
    points.push_back({place(j), is_end ? end_of(j) : SingularKind::friction_jump, power, theta, Estimate<R>{}, k});
  }
  return points;
}

template <Real R>
const std::vector<Estimate<R>>& PeriodicSolution<R>::loads() const {
  return loads_([this] {
    std::vector<Estimate<R>> result;
    for (std::size_t k = 0; k < gap(); ++k) {
      const R half = weight().arc(k) / 2;
      result.push_back((-tanh_sinh::panel_integral(traction().density(k))).widened(8 * relative_error(k, half, half)));
    }
    return result;
  });
}

template <Real R>
Estimate<R> PeriodicSolution<R>::mean_friction() const {
  Estimate<R> sum;
  for (std::size_t k = 0; k < gap(); ++k) sum += to_real<R>(problem_.coupled_friction(piece(k))) * loads()[k];
  return sum / weight().period();
}

template <Real R>
Resultants<R> PeriodicSolution<R>::resultants() const {
  std::vector<Estimate<R>> on_pieces(problem_.friction().values().size());
  for (std::size_t k = 0; k < gap(); ++k) on_pieces[piece(k)] += loads()[k];
  Resultants<R> result = resultants_of(on_pieces, problem_.friction().values());
  result.component_load = {result.normal};
  const R middle = (weight().point(0) + weight().point(gap())) / 2;
  Estimate<R> moment;
  for (std::size_t k = 0; k < gap(); ++k) {
    PanelDensity<R> density = traction().density(k);
    density.smooth = [smooth = density.smooth, middle](const Node<R>& node) -> R {
      return -(node.x - middle) * smooth(node);
    };
    const R half = weight().arc(k) / 2;
    const R width = weight().period() - weight().arc(gap());
    Estimate<R> part = tanh_sinh::panel_integral(density);
    part.error += 8 * relative_error(k, half, half) * width * abs(loads()[k].value);
    moment += part;
  }
  const R origin = to_real<R>(found_.origin) + middle;
  result.centre_of_pressure = Estimate<R>{origin, 2 * epsilon<R>() * abs(origin)} + moment / result.normal;
  return result;
}

template <Real R>
LargestPressure<R> PeriodicSolution<R>::largest_pressure() const {
  if (const auto infinite = infinite_pressure(singular_points())) return *infinite;
  std::vector<R> lengths;
  for (std::size_t k = 0; k < gap(); ++k) lengths.push_back(weight().arc(k));
  const PanelFunction<R> pressure = [this](std::size_t k, const R& left, const R& right) {
    return Estimate<R>{-traction().value(k, left, right), R(0)}.widened(relative_error(k, left, right));
  };
  return finite_pressure<R>({}, lengths, pressure, [&](const Peak<R>& peak) -> Estimate<R> {
    const R x = to_real<R>(found_.origin) + weight().point(peak.panel) + peak.from_left;
    return {x, peak.place_error + found_.end_error + 2 * epsilon<R>() * abs(x)};
  });
}

template <Real R>
EstimatedError<R> PeriodicSolution<R>::estimated_error() const {
  const R width = weight().period() - weight().arc(gap());
  EstimatedError<R> worst{max(found_.end_error / width, epsilon<R>()), R(0), R(0)};
  for (std::size_t k = 0; k < gap(); ++k) {
    const R half = weight().arc(k) / 2;
    worst.traction = max(worst.traction, relative_error(k, half, half));
  }
  const Resultants<R> r = resultants();
  worst.resultants = r.normal.error / r.normal.value;
  return worst;
}

/// The equation is checked in X = tan(pi (x - x_0)/L), x_0 the middle of the contact, where the periodic problem is that
/// of the half-plane: A_X t = g + kappa, kappa = (1/L) int t (X + s) dx.
template <Real R>
Residuals<R> PeriodicSolution<R>::residuals() const {
  const R y = weight().wave_number(), middle = (weight().point(0) + weight().point(gap())) / 2;
  const auto mapped_place = [&](const R& x) { return R(tan(y * (x - middle))); };
  PiecewiseDensity<R> in_x, in_X;
  std::vector<R> s;
  Estimate<R> kappa = -mean_friction();
  for (std::size_t k = 0; k < gap(); ++k) {
    s.push_back(to_real<R>(problem_.coupled_friction(piece(k))));
    const PanelDensity<R> density = traction().density(k);
    in_x.push_back(density);
    const R left = mapped_place(density.panel.left), right = mapped_place(weight().point(k + 1));
    const R length = sin(y * density.panel.length) * sqrt((1 + left * left) * (1 + right * right));
    const R full = density.panel.length;
    const auto smooth = [density, left, right, length, full, y](const Node<R>& node) -> R {
      // Distances in x, and the powers of their ratios to those in X.
      const auto distance = [&](const R& from, const R& end) { return R(atan2(from, 1 + node.x * end) / y); };
      const auto ratio = [&](const R& from, const R& d, const R& end) -> R {
        return from < epsilon<R>() * epsilon<R>() * length ? R(1 / (y * (1 + end * end))) : R(d / from);
      };
      const R from_left = distance(node.from_left, left), from_right = distance(node.from_right, right);
      const Node<R> place{density.panel.left + from_left, min(from_left, full), min(from_right, full)};
      return density.smooth(place) * pow(ratio(node.from_left, from_left, left), density.left.value) *
             pow(ratio(node.from_right, from_right, right), density.right.value);
    };
    in_X.push_back({{left, left + length, length}, density.left, density.right, smooth});
    PanelDensity<R> moment = density;
    moment.smooth = [density, middle, y](const Node<R>& node) -> R {
      return density.smooth(node) * tan(y * (node.x - middle));
    };
    kappa += tanh_sinh::panel_integral(moment) / weight().period();
  }
  const auto slope = [&](std::size_t, const Node<R>& node) -> R {
    R sum = kappa.value;
    const R x = middle + atan(node.x) / y;
    for (std::size_t n = 1; n <= found_.g.size(); ++n) {
      const R angle = 2 * static_cast<double>(n) * y * x;
      sum += found_.g[n - 1].re * cos(angle) + found_.g[n - 1].im * sin(angle);
    }
    return sum;
  };
  const SurfaceCheck<R> equation(std::move(in_X), s, slope), load(std::move(in_x), s, slope);
  const R applied = to_real<R>(problem_.load());
  const R width = weight().period() - weight().arc(gap());
  Residuals<R> result{equation.equation(), abs(load.integral() + applied) / applied, R(0),
                      max(load.highest_traction(), R(0)) * width / applied};
  for (const Rational& x : sampled_places(8)) {
    const Place place = locate(x);
    if (!place.is_point && place.arc == gap())
      result.penetration = max(result.penetration, -gap_at(place).value / (compliance_ * applied));
  }
  // The surface is one curve: its rise over the whole gap is that of the profile.
  result.penetration =
      max(result.penetration, abs(tanh_sinh::panel_integral(traction().density(gap())).value) / applied);
  return result;
}

template <Real R>
const PiecewiseTraction<R>& PeriodicSolution<R>::panels() const {
  return panels_([this] {
    PiecewiseTraction<R> result(problem_.elasticity());
    for (std::size_t k = 0; k < gap(); ++k) {
      const std::size_t before = k == 0 ? gap() : k - 1;
      const Surroundings<R> around{weight().power(k).value != 0, weight().power(k + 1).value != 0, weight().arc(before),
                                   weight().arc(k + 1)};
      const auto end_error = [&](std::size_t point) { return is_free(point) ? found_.end_error : R(0); };
      result.add({SurfacePlace<R>::of(found_.points[k]), SurfacePlace<R>::of(found_.points[k + 1]), weight().arc(k),
                  around, weight().power(k), weight().power(k + 1), nullptr, nullptr,
                  to_real<R>(problem_.shear_ratio(piece(k))),
                  [&, k](std::span<const R> from_left, std::span<const R> from_right, std::span<R> values) {
                    for (std::size_t i = 0; i < values.size(); ++i)
                      values[i] = traction().value(k, from_left[i], from_right[i]);
                  },
                  [&, k](const R& from_left, const R& from_right) { return relative_error(k, from_left, from_right); },
                  end_error(k), end_error(k + 1)});
    }
    return result;
  });
}

template <Real R>
Attempt<R> periodic_closed_form(const ContactProblem& problem) {
  std::variant<PeriodicContact<R>, std::string> found = periodic_contact<R>(problem);
  if (auto* reason = std::get_if<std::string>(&found)) return {nullptr, std::move(*reason)};
  return {std::make_shared<const PeriodicSolution<R>>(problem, std::get<PeriodicContact<R>>(std::move(found))), {}};
}

#define STEADYSLIDE_INSTANTIATE(R) template Attempt<R> periodic_closed_form(const ContactProblem&);
STEADYSLIDE_FOR_EACH_REAL(STEADYSLIDE_INSTANTIATE)
#undef STEADYSLIDE_INSTANTIATE
STEADYSLIDE_INSTANTIATE_CLASS(PeriodicSolution)

}  // namespace steadyslide::numeric
