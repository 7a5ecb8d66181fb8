// The solution's residuals, by the trapezoidal rule on its traction.

#include <algorithm>
#include <cmath>

#include "numeric/cauchy/residuals.hpp"
#include "numeric/cauchy/traction_density.hpp"
#include "numeric/number/chebyshev_position.hpp"
#include "numeric/riemann_hilbert/gap_integral.hpp"
#include "numeric/riemann_hilbert/local_signs.hpp"
#include "numeric/riemann_hilbert/riemann_hilbert_solution.hpp"

namespace steadyslide::numeric {

template <Real R>
Residuals<R> RiemannHilbertSolution<R>::residuals() const {
  using std::abs, std::max;
  PiecewiseDensity<R> density;
  std::vector<R> s;
  std::vector<std::size_t> segments;
  R contact_length = 0;
  for (std::size_t k = 0; k < contact_set().segments(); ++k) {
    if (!contact_set().in_contact(k)) continue;
    density.push_back(panel_density(*form_, k));
    s.push_back(reduced_.s(form_->friction_at(k)));
    segments.push_back(k);
    contact_length += contact_set().length(k);
  }
  const SurfaceCheck<R> check(std::move(density), s, [&](std::size_t panel, const Node<R>& node) {
    return R(reduced_.slope(form_->slope_at(segments[panel]), node.x) + form_->tilt());
  });
  const R& load = reduced_.load();
  Residuals<R> result;
  result.equation = check.equation();
  result.load = abs(check.integral() + load) / load;
  // Places show what is there; the limits decide what no place may show.
  const R limit = highest_limit(*form_, found_->end_error);
  result.tension = max({check.highest_traction(), limit, R(0)}) * contact_length / load;

  // Gaps: the profile against the displacement, both from the end of the contact that is next to the place.
  R deepest = 0;
  constexpr int places = 8;
  for (std::size_t k = 0; k < contact_set().segments(); ++k) {
    if (contact_set().in_contact(k)) continue;
    std::vector<SurfacePoint<R>> all = form_->profile_extrema(k);
    for (int i = 0; i < places; ++i) {
      const auto [left, right] = chebyshev_position<R>(i, places);
      const R& length = contact_set().length(k);
      all.push_back(surface_point(contact_set(), k, R(left * length), R(right * length)));
    }
    for (const SurfacePoint<R>& at : all) {
      const std::optional<std::size_t> end = nearest_end(at);
      if (!end) continue;
      const bool on_left = contact_set().point(*end).kind == ContactSet<R>::Kind::ends;
      const std::size_t segment = on_left ? *end - 1 : *end;
      const auto panel =
          static_cast<std::size_t>(std::find(segments.begin(), segments.end(), segment) - segments.begin());
      const R distance = abs(form_->distance(at, *end));
      const R surface = check.displacement(panel, on_left ? Side::right : Side::left, distance);
      const R gap = GapIntegral<R>(*form_, *end).profile_increment(at) - surface;
      deepest = max(deepest, R(-gap));
    }
  }
  result.penetration = deepest / load;
  return result;
}

template Residuals<double> RiemannHilbertSolution<double>::residuals() const;
template Residuals<Real50> RiemannHilbertSolution<Real50>::residuals() const;
template Residuals<Real100> RiemannHilbertSolution<Real100>::residuals() const;

}  // namespace steadyslide::numeric
