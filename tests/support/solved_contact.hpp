#pragma once
// Contact problems in reduced data, solved, with all that every solution promises checked.

#include "numeric/cauchy/residuals.hpp"
#include "numeric/cauchy/traction_density.hpp"
#include "numeric/riemann_hilbert/riemann_hilbert.hpp"
#include "numeric/riemann_hilbert/riemann_hilbert_solution.hpp"
#include "support/numeric_test.hpp"
#include "support/problems.hpp"

namespace steadyslide::testing {

/// How far residuals may be from zero.
template <numeric::Real R>
R residual_tolerance() {
  if constexpr (std::same_as<R, double>) return 1e-11;
  return std::same_as<R, numeric::Real50> ? R(1e-45) : R(1e-100);
}

/// "equation 1e-05; load 0.1": the residuals above a tolerance. One that is no number is above all.
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

/// What a solution does not keep of its promises, or nothing.
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

}  // namespace steadyslide::testing
