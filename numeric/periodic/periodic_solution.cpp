#include "numeric/periodic/periodic_solution.hpp"

#include <algorithm>

#include "numeric/cauchy/sliding_operator.hpp"
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
  if (!traction().has_gap()) return jump_exponent(s((point + gap() - 1) % gap()), s(point % gap()));
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
  const std::size_t own = point % weight().size();
  const auto [value, size] = traction().polynomial(weight().point(own));
  R theta = weight().amplitude(own) * value;
  // At an end theta contains cos(pi alpha) of the contact side; at a jump its definition does not contain it.
  if (traction().has_gap() && point == 0) theta *= traction().cosines.front();
  if (traction().has_gap() && point == gap()) theta *= traction().cosines.back();
  const std::size_t arc = min(point, gap() - 1);
  const R half = weight().arc(arc) / 2;
  const R rounding = 32 * static_cast<double>(weight().size()) * epsilon<R>() * size / abs(value);
  return {theta, theta * (rounding + 4 * relative_error(arc, half, half))};
}

template <Real R>
std::vector<ContactComponent<R>> PeriodicSolution<R>::contact() const {
  const std::size_t last = gap();
  const R width = this->width(), error = 2 * found_.end_error + 4 * epsilon<R>() * width;
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
  for (std::size_t j = 0; j < weight().size(); ++j) {
    const bool is_end = traction().has_gap() && (j == 0 || j == last);
    const Exponent power = exponent(j);
    if (!is_end && power.sign() == 0) continue;
    const Estimate<R> theta = intensity(j);
    const auto on_side = [&](std::size_t arc) {
      return stress_intensity_of<R>((is_end ? R(1) : traction().cosines[arc]) * theta, weight().power(j).value);
    };
    StressIntensity<R> k;
    if (j > 0 || !is_end) k.left = on_side((j + last - 1) % last);
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
  const R middle = weight().point(0) + width() / 2;
  Estimate<R> moment;
  for (std::size_t k = 0; k < gap(); ++k) {
    PanelDensity<R> density = traction().density(k);
    density.smooth = [smooth = density.smooth, middle](const Node<R>& node) -> R {
      return -(node.x - middle) * smooth(node);
    };
    const R half = weight().arc(k) / 2;
    Estimate<R> part = tanh_sinh::panel_integral(density);
    part.error += 8 * relative_error(k, half, half) * width() * abs(loads()[k].value);
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
  EstimatedError<R> worst{max(found_.end_error / width(), epsilon<R>()), R(0), R(0)};
  for (std::size_t k = 0; k < gap(); ++k) {
    const R half = weight().arc(k) / 2;
    worst.traction = max(worst.traction, relative_error(k, half, half));
  }
  const Resultants<R> r = resultants();
  worst.resultants = r.normal.error / r.normal.value;
  return worst;
}

/// Returns int value() kernel over a part of an arc, by the trapezoidal rule, which the solver does not use. The rule needs
/// panels that are short against the waves of T. The kernel takes the distances from both ends of the arc.
template <Real R>
template <class Kernel>
R PeriodicSolution<R>::trapezoidal_integral(std::size_t k, const R& from_left, const R& from_right,
                                            const Kernel& kernel) const {
  const R length = weight().arc(k) - (from_left + from_right);
  const double waves = static_cast<double>(length / weight().period()) * static_cast<double>(4 * found_.g.size());
  const int parts = 1 + static_cast<int>(waves);
  R sum = 0;
  for (int i = 0; i < parts; ++i) {
    const R left = from_left + i * length / parts, right = from_right + (parts - 1 - i) * length / parts;
    PanelDensity<R> density = traction().density(k, left, right);
    density.smooth = [smooth = density.smooth, &kernel, left, right](const Node<R>& node) -> R {
      return smooth(node) * kernel(left + node.from_left, right + node.from_right);
    };
    sum += trapezoidal::Grid<R>({density}).integral();
  }
  return sum;
}

/// Returns H_L t at a place inside an arc of the contact. Next to the place it takes t(x + v) - t(x - v).
template <Real R>
R PeriodicSolution<R>::hilbert(std::size_t k, const R& from_left, const R& from_right) const {
  const PeriodicTraction<R>& t = traction();
  const R y = weight().wave_number(), period = weight().period();
  const R d = min(min(from_left, from_right) / 2, R(period / static_cast<double>(4 + 4 * found_.g.size())));
  const auto difference = [&t, &from_left, &from_right, k, y](const Node<R>& node) -> R {
    const R& v = node.from_left;
    return (t.value(k, from_left + v, from_right - v) - t.value(k, from_left - v, from_right + v)) / tan(y * v);
  };
  R sum = trapezoidal::Grid<R>({PanelDensity<R>{{R(0), d, d}, {}, {}, difference}}).integral();
  // The cotangent of the distance from the place, going right and left from it.
  const auto cotangent = [&y](const R& to_right, const R& to_left) {
    return to_right < to_left ? R(1 / tan(y * to_right)) : R(-1 / tan(y * to_left));
  };
  sum += trapezoidal_integral(k, R(0), R(from_right + d), [&](const R& left, const R& right) -> R {
    return cotangent(R(period - from_left + left), R(right - from_right));
  });
  sum += trapezoidal_integral(k, R(from_left + d), R(0), [&](const R& left, const R& right) -> R {
    return cotangent(R(left - from_left), R(period - from_right + right));
  });
  for (std::size_t j = 0; j < gap(); ++j) {
    if (j == k) continue;
    const R to_arc = from_right + way(k + 1, j), from_arc = from_left + way(j + 1, k);
    sum += trapezoidal_integral(j, R(0), R(0), [&](const R& left, const R& right) -> R {
      return cotangent(R(to_arc + left), R(from_arc + right));
    });
  }
  return sum / period;
}

template <Real R>
R PeriodicSolution<R>::way(std::size_t from, std::size_t to) const {
  R length = 0;
  for (std::size_t j = from % weight().size(); j != to; j = (j + 1) % weight().size()) length += weight().arc(j);
  return length;
}

template <Real R>
Residuals<R> PeriodicSolution<R>::residuals() const {
  Residuals<R> result{R(0), R(0), R(0), R(0)};
  const R applied = to_real<R>(problem_.load());
  R load = 0;
  // On all arcs, or on some if there are many: each place needs an integral over every arc.
  const std::size_t every = (gap() + 7) / 8;
  for (std::size_t k = 0; k < gap(); ++k) {
    load -= trapezoidal_integral(k, R(0), R(0), [](const R&, const R&) { return R(1); });
    for (const double part : {0.001, 0.4, 0.97}) {
      const R length = weight().arc(k), from_left = length * part, from_right = length - from_left;
      const R t = traction().value(k, from_left, from_right), s = to_real<R>(problem_.coupled_friction(piece(k)));
      result.tension = max(result.tension, R(t * width() / applied));
      if (k % every != 0) continue;
      R slope = -mean_friction().value;
      for (std::size_t n = 1; n <= found_.g.size(); ++n) {
        const R angle = 2 * static_cast<double>(n) * weight().wave_number() * (weight().point(k) + from_left);
        slope += found_.g[n - 1].re * cos(angle) + found_.g[n - 1].im * sin(angle);
      }
      const SlidingTerms<R> terms{t, {hilbert(k, from_left, from_right)}, s * t};
      result.equation = max(result.equation, terms.residual(slope));
    }
  }
  result.load = abs(load - applied) / applied;
  if (!traction().has_gap()) return result;
  for (const Rational& x : sampled_places(8)) {
    const Place place = locate(x);
    if (!place.is_point && place.arc == gap())
      result.penetration = max(result.penetration, R(-gap_at(place).value / (compliance_ * applied)));
  }
  // The surface is one curve: its rise over the whole gap is that of the profile.
  result.penetration =
      max(result.penetration, R(abs(tanh_sinh::panel_integral(traction().density(gap())).value) / applied));
  return result;
}

template <Real R>
const PiecewiseTraction<R>& PeriodicSolution<R>::panels() const {
  return panels_([this] {
    // The waves of T are resolved like a polynomial.
    PiecewiseTraction<R> result(problem_.elasticity(), static_cast<int>(4 * found_.g.size()));
    for (std::size_t k = 0; k < gap(); ++k) {
      const std::size_t before = (k + weight().size() - 1) % weight().size(), next = (k + 1) % weight().size();
      const Surroundings<R> around{weight().power(k).value != 0, weight().power(k + 1).value != 0, weight().arc(before),
                                   weight().arc(next)};
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
