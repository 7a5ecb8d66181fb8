#pragma once
// Solves contact problems in reduced data, and checks the properties of every solution.

#include "numeric/cauchy/residuals.hpp"
#include "numeric/riemann_hilbert/riemann_hilbert.hpp"
#include "numeric/riemann_hilbert/riemann_hilbert_solution.hpp"
#include "numeric/riemann_hilbert/traction_density.hpp"
#include "support/numeric_test.hpp"
#include "support/problems.hpp"

namespace steadyslide::testing {

/// The largest residuals that are allowed.
template <numeric::Real R>
R residual_tolerance() {
  if constexpr (std::same_as<R, double>) return 1e-11;
  return std::same_as<R, numeric::Real50> ? R(1e-45) : R(1e-100);
}

/// Returns "equation 1e-05; load 0.1": the residuals above a tolerance. NaN counts as above.
template <numeric::Real R>
std::string large_residuals(const numeric::ContactSolution<R>& solution, const R& tolerance) {
  const numeric::Residuals<R> r = solution.residuals();
  std::ostringstream text;
  for (const auto& [name, value] :
       {std::pair("equation", r.equation), {"load", r.load}, {"penetration", r.penetration}, {"tension", r.tension}}) {
    if (!(value <= tolerance)) text << (text.str().empty() ? "" : "; ") << name << ' ' << static_cast<double>(value);
  }
  return text.str();
}

/// Returns the property that a solution does not have; empty if it has all.
template <numeric::Real R>
std::string fault(const numeric::ContactSolution<R>& solution) {
  const std::string failed_condition = solution.failed_condition();
  return failed_condition.empty() ? large_residuals<R>(solution, residual_tolerance<R>()) : failed_condition;
}

template <numeric::Real R>
using Solved = std::shared_ptr<const numeric::RiemannHilbertSolution<R>>;

template <numeric::Real R>
Solved<R> solved(const ContactProblem& problem, const numeric::ContactSolution<R>* start = nullptr) {
  const numeric::Attempt<R> attempt = numeric::riemann_hilbert<R>(problem, start);
  REQUIRE_MESSAGE(attempt.solution, attempt.reason);
  CHECK(fault(*attempt.solution) == "");
  return std::dynamic_pointer_cast<const numeric::RiemannHilbertSolution<R>>(attempt.solution);
}

/// Checks that ends, intensities and tractions agree; b is a moved by `shift`.
template <numeric::Real A, numeric::Real B>
void solutions_agree(const numeric::ContactSolution<A>& a, const numeric::ContactSolution<B>& b, const B& tolerance,
                     const Rational& shift = 0) {
  using std::abs;
  const auto za = a.contact();
  const auto zb = b.contact();
  REQUIRE(za.size() == zb.size());
  const B rounding = tolerance * (1 + to_real<B>(abs(shift)));
  const auto close = [](const B& x, const B& y, const B& scale) { CHECK(abs(x - y) <= scale); };
  for (std::size_t k = 0; k < za.size(); ++k) {
    for (const auto& [p, q] : {std::pair(za[k].left, zb[k].left), {za[k].right, zb[k].right}}) {
      close(B(p.x.value) + to_real<B>(shift), q.x.value, rounding);
      close(B(p.intensity.value), q.intensity.value, 100 * tolerance * q.intensity.value);
    }
    for (const int part : {1, 37, 64, 99}) {
      const Rational left(za[k].left.x.value);
      const Rational x = left + (Rational(za[k].right.x.value) - left) * part / 100;
      const B t = b.at(x + shift).traction.left.value;
      close(B(a.at(x).traction.left.value), t, 100 * tolerance * (1 + abs(t)));
    }
  }
}

template <numeric::Real R>
numeric::SurfaceCheck<R> check_of(const numeric::TractionRepresentation<R>& form) {
  std::vector<R> s;
  std::vector<std::size_t> segments;
  for (std::size_t k = 0; k < form.set().segments(); ++k) {
    if (!form.set().in_contact(k)) continue;
    s.push_back(form.problem().s(form.friction_at(k)));
    segments.push_back(k);
  }
  return {traction_density(form), s, [&form, segments](std::size_t panel, const numeric::Node<R>& node) {
            return R(form.problem().slope(form.slope_at(segments[panel]), node.x) + form.tilt());
          }};
}

/// `density` times a factor.
template <numeric::Real R>
numeric::PanelDensity<R> scaled(const numeric::PanelDensity<R>& density, const R& factor) {
  numeric::PanelDensity<R> result = density;
  result.smooth = [smooth = density.smooth, factor](const numeric::Node<R>& node) { return R(factor * smooth(node)); };
  return result;
}

/// Calls act(j, side, surface) for each end of contact, point j, beside the gap of a place: `side` is the side of the
/// contact on which the gap lies, and `surface` the height of the surface at the place above that end, by an
/// independent quadrature.
template <class Act>
void from_ends_of_gap(const numeric::TractionRepresentation<double>& form, const numeric::SurfaceCheck<double>& check,
                      const numeric::SurfacePoint<double>& at, const Act& act) {
  const auto& set = form.set();
  const auto k = static_cast<std::size_t>(at.segment);
  std::size_t panels_before = 0;
  for (std::size_t i = 0; i < k; ++i) panels_before += set.in_contact(i);
  for (const End side : {End::left, End::right}) {
    const bool right = side == End::right;
    std::size_t j = right ? k : k + 1;
    while (j > 0 && j < set.segments() && !set.point(j).is_end()) right ? --j : ++j;
    if (!set.point(j).is_end()) continue;
    const double distance = std::abs(form.distance(at, j));
    act(j, side, check.displacement(right ? panels_before - 1 : panels_before, side, distance));
  }
}

}  // namespace steadyslide::testing
