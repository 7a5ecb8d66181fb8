#pragma once
// Contact sets for checks of the Riemann-Hilbert form: arbitrary sets, which need not belong to a solution, and solved
// problems. Profile and friction are read from the problem here, not from the solver.

#include <memory>

#include "numeric/cauchy/residuals.hpp"
#include "numeric/riemann_hilbert/riemann_hilbert_solution.hpp"
#include "numeric/riemann_hilbert/traction_density.hpp"
#include "proofs_checks/instruments/tractions/surface.hpp"
#include "proofs_checks/kit/cases.hpp"

namespace steadyslide::proofs_checks {

using numeric::ContactInterval;
using numeric::ContactSet;
using numeric::SurfacePoint;
using numeric::TractionRepresentation;

struct Trial {
  std::string name;
  ContactProblem problem;
  std::vector<ContactInterval> zones;  ///< in the coordinate xi of frame()
  std::vector<Rational> q;             ///< the form uses the first ones, as many as it has coefficients
  Rational tilt;

  static Frame frame() { return {Rational(1, 8), 2}; }
  static double in_frame(const Rational& x) { return to_real<double>((x - frame().origin) / frame().unit); }
};

/// Returns the cases: one polynomial everywhere and any ends; a wedge; a wedge and a friction jump; steps; up to three
/// components. Cheap cases come first, `random` random ones last. A quick run with more than 16 digits has two cases:
/// one component, and two components or, with `corners`, a corner.
std::function<CaseList<Trial>(const Context&)> trials(std::string stream, const CountByDigits& random,
                                                      bool corners = false);
std::string text_of(const Trial& trial);
/// Returns a trial with one component over a friction jump for each pair. The pair states if the left end and the right
/// end are edges.
Trial with_ends(const std::vector<std::pair<bool, bool>>& edges);

/// Return psi/c and psi'/c at x in the user's units, with the profile's piece around another point.
template <Real R>
R height(const ContactProblem& problem, const R& around, const R& x);
template <Real R>
R slope(const ContactProblem& problem, const R& around, const R& x);

/// The form of a trial. It owns the data that the form points to.
template <class R>
class TrialForm {
 public:
  explicit TrialForm(const Trial& trial);
  TrialForm(const TrialForm&) = delete;
  TrialForm& operator=(const TrialForm&) = delete;

  const TractionRepresentation<R>& form() const { return *form_; }
  /// Returns the form on another contact set or with another tilt.
  TractionRepresentation<R> form_on(ContactSet<R> set, const R& tilt) const;

 private:
  ContactProblem problem_;
  numeric::RoundedProblem<R> reduced_;
  mutable numeric::JacobiRules<R> rules_;
  std::optional<TractionRepresentation<R>> form_;
};

/// Returns the coefficient of z^power of u'/c = Y (m_0/z + m_1/z^2 + ... + q/pi) at infinity.
template <Real R>
R coefficient_at_infinity(const TractionRepresentation<R>& form, int power);
/// Returns the coefficients of z^0, z^1, ... For a solution they are zero. In general A t = psi'/c + tilt - (the
/// polynomial with these coefficients).
template <Real R>
std::vector<R> excess(const TractionRepresentation<R>& form);

/// Returns an estimate of int |t|, the scale for int t, which may vanish.
template <Real R>
R load_scale(const TractionRepresentation<R>& form);

/// The factor in t = bracket |Y|; `weight` gives Y. Density panels are the contact's segments in order, see
/// segments_of.
template <class R>
using Bracket = std::function<R(std::size_t segment, const Node<R>&)>;
template <Real R>
PiecewiseDensity<R> density_of(const TractionRepresentation<R>& form, const numeric::FundamentalSolution<R>& weight,
                               const Bracket<R>& bracket);
template <Real R>
std::vector<std::size_t> segments_of(const TractionRepresentation<R>& form);
/// Returns s on the contact's panels in the convention of formulas, s_of().
template <Real R>
std::vector<R> friction_of(const TractionRepresentation<R>& form);

/// Returns the largest error of A t = psi'/c on the contact of a solution, at distances of at least 1e-6 of a segment's
/// length from its ends. The trapezoidal rule computes A t and does not use the form; s and psi come from the problem's
/// data.
template <Real R>
R equation_error(const TractionRepresentation<R>& solution);
/// Checks that a solution satisfies the equation.
template <Real R>
void check_equation(Findings& findings, const TractionRepresentation<R>& solution);

/// Returns the value at `to` h of the analytic function with the values f_1, ..., f_n at -h, ..., -nh. With this number
/// of values at such small distances the error stays far below the tolerance.
template <Real R>
R extrapolated(const std::vector<R>& f, int to);
template <Real R>
inline constexpr int extrapolation_values = std::same_as<R, Real100> ? 15 : 8;
template <Real R>
R extrapolation_step() {
  return R(1) / 100'000'000;
}

}  // namespace steadyslide::proofs_checks
