// The traction of a Riemann-Hilbert form as panels with a power and a polynomial.

#include <algorithm>
#include <cmath>

#include "numeric/number/polynomial.hpp"
#include "numeric/riemann_hilbert/riemann_hilbert_solution.hpp"

namespace steadyslide::numeric {

template <Real R>
std::function<R(const R&)> RiemannHilbertSolution<R>::corner(std::size_t j, Side side) const {
  if (!form_.changes_polynomial(j)) return nullptr;
  const Rational& x = reduced_.place(*contact_set().point(j).anchor);
  const Indenter& indenter = problem_.indenter();
  const Rational s = problem_.coupled_friction(form_.friction_at(j - 1));
  Rational divisor = problem_.elasticity().compliance() * (problem_.coupled_friction(form_.friction_at(j)) - s);
  R factor = 1;
  if (form_.power(j).value == 0) {
    divisor = problem_.elasticity().compliance() * (1 + s * s);
    factor = 1 / pi<R>();
  }
  // D in powers of d, exactly.
  const Polynomial jump = (indenter.profile(x, Side::right) - indenter.profile(x, Side::left)).derivative();
  const Polynomial beside = jump.composed(side == Side::left ? -1 : 1, x);
  std::vector<R> coefficients;
  for (const Rational& a : beside.coefficients()) coefficients.push_back(factor * to_real<R>(a / divisor));
  return [coefficients](const R& d) { return value_of(coefficients, d); };
}

template <Real R>
PiecewiseTraction<R> RiemannHilbertSolution<R>::piecewise_traction() const {
  const ContactSet<R>& set = contact_set();
  const R unit = to_real<R>(reduced_.frame().unit);
  const std::vector<Rational> points = places();
  const auto is_singular = [&](std::size_t j) { return form_.power(j).value != 0 || form_.changes_polynomial(j); };
  const auto displaced = [&](std::size_t j) { return set.point(j).is_movable() ? R(unit * end_error()) : R(0); };
  PiecewiseTraction<R> result(problem_.elasticity(), reduced_.highest_degree());
  for (std::size_t k = 0; k < set.segments(); ++k) {
    if (!set.in_contact(k)) continue;
    Surroundings<R> around = surroundings<R>(set, k, is_singular);
    around.beyond_left *= unit;
    around.beyond_right *= unit;
    result.add({SurfacePlace<R>::of(points[k]), SurfacePlace<R>::of(points[k + 1]), R(unit * set.length(k)), around,
                form_.power(k), form_.power(k + 1), corner(k, Side::right), corner(k + 1, Side::left), shear_ratio(k),
                [&, k](std::span<const R> from_left, std::span<const R> from_right, std::span<R> values) {
                  std::vector<R> left(from_left.begin(), from_left.end());
                  std::vector<R> right(from_right.begin(), from_right.end());
                  for (std::vector<R>* distances : {&left, &right}) {
                    for (R& d : *distances) d /= unit;
                  }
                  form_.tractions(k, left, right, values);
                },
                [&, k](const R& from_left, const R& from_right) {
                  using std::abs;
                  const SurfacePoint<R> at = surface_point(set, k, R(from_left / unit), R(from_right / unit));
                  const Estimate<R> t = traction(at);
                  // The place of x among the free ends is as uncertain as they are: twice their error.
                  return R(16 * epsilon<R>() + 2 * relative_end_error(at) +
                           (t.value == 0 ? R(0) : R(t.error / abs(t.value))));
                },
                displaced(k), displaced(k + 1)});
  }
  return result;
}

#define STEADYSLIDE_INSTANTIATE(R)                                                                       \
  template std::function<R(const R&)> RiemannHilbertSolution<R>::corner(std::size_t j, Side side) const; \
  template PiecewiseTraction<R> RiemannHilbertSolution<R>::piecewise_traction() const;
STEADYSLIDE_FOR_EACH_REAL(STEADYSLIDE_INSTANTIATE)
#undef STEADYSLIDE_INSTANTIATE

}  // namespace steadyslide::numeric
