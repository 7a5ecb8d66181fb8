#pragma once
// Contact sets on which the Riemann-Hilbert form is tried: any set, whether or not it is the solution's, and solved
// problems. What the profile and the friction are is read from the problem here, not from the solver.

#include <memory>

#include "numeric/cauchy/residuals.hpp"
#include "numeric/cauchy/traction_density.hpp"
#include "numeric/riemann_hilbert/riemann_hilbert_solution.hpp"
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
  std::vector<ContactInterval> zones;  ///< in xi of frame()
  std::vector<Rational> q;             ///< as many of them as the form has coefficients are used
  Rational tilt;

  static Frame frame() { return {Rational(1, 8), 2}; }
  static double in_frame(const Rational& x) { return to_real<double>((x - frame().origin) / frame().unit); }
};

/// Everywhere one polynomial and any ends; a wedge; a wedge and jump; steps; up to three components. The cheap ones
/// first, `random` random ones last. At more than 16 digits a quick run has two of them: one component, and two or, if
/// `corners`, a corner.
std::function<CaseList<Trial>(const Context&)> trials(std::string stream, const CountByDigits& random,
                                                      bool corners = false);
std::string text_of(const Trial& trial);
/// A component under a friction jump for every pair: is there an edge at its left end, at its right one?
Trial with_ends(const std::vector<std::pair<bool, bool>>& edges);

/// psi/c and psi'/c in the user's x, on the piece around another place.
template <Real R>
R height(const ContactProblem& problem, const R& around, const R& x);
template <Real R>
R slope(const ContactProblem& problem, const R& around, const R& x);

/// The form of a trial, with all that it points to.
template <class R>
class TrialForm {
 public:
  explicit TrialForm(const Trial& trial);
  TrialForm(const TrialForm&) = delete;
  TrialForm& operator=(const TrialForm&) = delete;

  const TractionRepresentation<R>& form() const { return *form_; }
  /// On another contact set, or with another tilt.
  TractionRepresentation<R> form_on(ContactSet<R> set, const R& tilt) const;

 private:
  ContactProblem problem_;
  numeric::RoundedProblem<R> reduced_;
  mutable numeric::JacobiRules<R> rules_;
  std::optional<TractionRepresentation<R>> form_;
};

/// The coefficient of z^power of u'/c = Y (m_0/z + m_1/z^2 + ... + q/pi) at infinity.
template <Real R>
R coefficient_at_infinity(const TractionRepresentation<R>& form, int power);
/// Those of z^0, z^1, ...: none for a solution. What t leaves of psi'/c is A t = psi'/c + tilt - these.
template <Real R>
std::vector<R> excess(const TractionRepresentation<R>& form);

/// The size of int |t|: int t may vanish.
template <Real R>
R load_scale(const TractionRepresentation<R>& form);

/// t = bracket |Y|, Y from `weight`, panel by panel of the contact; segments_of says which they are.
template <class R>
using Bracket = std::function<R(std::size_t segment, const Node<R>&)>;
template <Real R>
PiecewiseDensity<R> density_of(const TractionRepresentation<R>& form, const numeric::FundamentalSolution<R>& weight,
                               const Bracket<R>& bracket);
template <Real R>
std::vector<std::size_t> segments_of(const TractionRepresentation<R>& form);
/// s of the contact's panels, as formulas have it: s_of().
template <Real R>
std::vector<R> friction_of(const TractionRepresentation<R>& form);

/// The largest error of A t = psi'/c on the contact of a solution, from 1e-6 of each segment's length on, by the trapezoidal
/// rule, which knows nothing of the form; s and psi from the problem's data.
template <Real R>
R equation_error(const TractionRepresentation<R>& solution);
/// That a solution is one.
template <Real R>
void check_equation(Findings& findings, const TractionRepresentation<R>& solution);

/// The analytic function with values f_1, ..., f_n at -h, ..., -nh, at `to` times h. With so many values at distances
/// so small the error stays far below the tolerance.
template <Real R>
R extrapolated(const std::vector<R>& f, int to);
template <Real R>
inline constexpr int extrapolation_values = std::same_as<R, Real100> ? 15 : 8;
template <Real R>
R extrapolation_step() {
  return R(1) / 100'000'000;
}

}  // namespace steadyslide::proofs_checks
