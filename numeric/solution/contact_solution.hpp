#pragma once
// The solution of a contact problem, as closed forms and all solvers return it. All values are in the user's units and
// x.
//
// Signs: traction t <= 0; shear is the tangential traction's component along +x; gap = psi - u - C >= 0; slope = u'.
// Intensities: theta >= 0 where t <= 0 requires it. t = -theta d^lambda at ends, t = constant - theta |x-c|^beta cos(pi
// alpha) at friction jumps.
//
// u is 0 at x = 0, or at the support's left end if x = 0 lies outside the support. T is the load up to a place:
//
//   u(x) = psi + tilt x - gap - C on the support, int u' dx beyond it,   T(x) = -int_-inf^x t dx',
//   u_t'/c = (1/pi) PV int t_t/(x'-x) dx' + gamma t,   t_t = -f t sliding towards +x, f t towards -x.  [Bal16, (2)]

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "model/approximate_contact.hpp"
#include "model/contact_problem.hpp"
#include "model/contact_values.hpp"
#include "numeric/number/estimate.hpp"
#include "numeric/solution/average_pressure.hpp"
#include "numeric/solution/piecewise_traction.hpp"

namespace steadyslide::numeric {

template <Real R>
using ContactEnd = ContactEndOf<Estimate<R>>;
template <Real R>
using ContactComponent = ContactComponentOf<Estimate<R>>;
template <Real R>
using StressIntensity = StressIntensityOf<Estimate<R>>;
template <Real R>
using SolvedSingularPoint = SingularPointOf<Estimate<R>>;
template <Real R>
using TwoSided = TwoSidedOf<Estimate<R>>;

/// A gap over a notch of the profile, inside the contact, that is too short to have its own ends. The solution has
/// contact there, with a traction that changes to tension within about this length of x.
template <Real R>
struct UnresolvedGap {
  Estimate<R> x;
  double log10_length;  ///< order of magnitude
};

/// Returns theta' (2 pi)^-lambda, with theta' = theta at an end and theta' = theta cos(pi alpha) at a jump.
template <Real R>
Estimate<R> stress_intensity_of(const Estimate<R>& coefficient, const R& exponent) {
  return pow(R(2 * pi<R>()), -exponent) * coefficient;
}

template <Real R>
struct Resultants {
  Estimate<R> normal;                       ///< -int t, the load computed from the traction
  Estimate<R> tangential;                   ///< |int f t| >= 0
  Estimate<R> centre_of_pressure;           ///< int x t / int t
  Estimate<R> effective_friction;           ///< tangential / normal
  std::vector<Estimate<R>> load_share;      ///< load share under each friction value, left to right; their sum is 1
  std::vector<Estimate<R>> component_load;  ///< -int t over each contact component, left to right
};

/// The supremum of the pressure -t. If it is infinite, x is the place of the strongest blow-up: compared by power, then
/// by intensity; among those equal within their errors the leftmost place.
template <Real R>
struct LargestPressure {
  Estimate<R> value;
  Estimate<R> x;
  std::optional<Exponent> exponent;  ///< if infinite: its exponent; absent for a logarithm
};

/// Returns the resultants without the centre of pressure, from `loads[k]` = -int t under friction[k].
template <Real R>
Resultants<R> resultants_of(const std::vector<Estimate<R>>& loads, const std::vector<Rational>& friction) {
  Resultants<R> result;
  for (const Estimate<R>& load : loads) result.normal += load;
  for (std::size_t k = 0; k < friction.size(); ++k) {
    result.load_share.push_back(loads[k] / result.normal);
    result.effective_friction += to_real<R>(friction[k]) * result.load_share[k];
  }
  result.tangential = result.effective_friction * result.normal;
  return result;
}

/// Relative residuals, measured by a quadrature rule that is independent of the one that found the solution.
template <Real R>
struct Residuals {
  R equation;     ///< max |A t - u'/c| / max(|u'/c|, |s t|, |H t|, |t|) over points of every panel
  R load;         ///< |int t + P| / P
  R penetration;  ///< max(-gap, 0) / (c P)
  R tension;      ///< max(t, 0) (contact length) / P
};

/// The largest relative errors, as the method itself estimates them.
template <Real R>
struct EstimatedError {
  R ends;
  R traction;
  R resultants;
};

/// Returns the tangential traction under friction piece k. Without friction it is 0, also under an infinite pressure.
template <Real R>
Estimate<R> shear_of(const ContactProblem& problem, std::size_t k, const Estimate<R>& traction) {
  const R ratio = to_real<R>(problem.shear_ratio(k));
  if (ratio == 0) return {};
  // The ratio and the product are both rounded.
  return ratio * (isinf(traction.value) ? traction : traction.widened(epsilon<R>()));
}

template <Real R>
struct Sample {
  R x;
  TwoSided<R> traction;
  TwoSided<R> shear;
  std::optional<Estimate<R>> gap;  ///< absent outside the support
  TwoSided<R> slope;
};

/// A sample with integrals of the traction. Each integral costs a quadrature.
template <Real R>
struct DetailedSample : Sample<R> {
  Estimate<R> displacement;     ///< u
  TwoSided<R> shear_slope;      ///< u_t', the slope of the tangential displacement
  Estimate<R> cumulative_load;  ///< T

  /// The friction pieces on both sides of x; absent outside the support.
  struct Friction {
    std::size_t left;
    std::size_t right;
  };
  std::optional<Friction> friction;
};

/// Equal cells between two places.
struct EqualCells {
  std::size_t count;
  Rational left;
  Rational right;
};

template <Real R>
class ContactSolution {
 public:
  virtual ~ContactSolution() = default;

  virtual std::string method() const = 0;
  /// Returns the condition that the best state violates, in words; empty if every condition of the problem holds.
  virtual std::string failed_condition() const { return {}; }
  /// Returns the cells on which the traction is constant; absent for a method without cells.
  virtual std::optional<EqualCells> equal_cells() const { return std::nullopt; }
  virtual std::vector<ContactComponent<R>> contact() const = 0;
  /// Returns the gaps from left to right.
  virtual std::vector<UnresolvedGap<R>> unresolved_gaps() const { return {}; }
  /// Returns the contact in exact numbers. A proof starts from it.
  virtual ApproximateContact approximate_contact() const { return {}; }
  virtual std::vector<SolvedSingularPoint<R>> singular_points() const = 0;
  virtual Resultants<R> resultants() const = 0;
  /// Returns the largest pressure. Between singular points it compares the pressure's critical points; according to the
  /// error estimates none is missed.
  virtual LargestPressure<R> largest_pressure() const = 0;
  /// Returns the largest mean pressure over windows of this length, which is positive, inside the contact.
  virtual AveragePressure<R> largest_average_pressure(const R& length) const {
    return numeric::largest_average_pressure(piecewise_traction(), length);
  }
  /// Returns the slope that is added to psi; absent if the indenter may not tilt.
  virtual std::optional<Estimate<R>> tilt() const { return std::nullopt; }
  virtual EstimatedError<R> estimated_error() const = 0;
  virtual Residuals<R> residuals() const = 0;
  /// Returns all values at one place of the surface, inside or outside the support.
  virtual Sample<R> at(const Rational& x) const = 0;
  /// Computes tractions and the shear along +x at many places, without gap, slope and errors. If the limits of at()
  /// differ, it takes the limits of the larger pressure. The spans have the same length.
  virtual void tractions(std::span<const R> x, std::span<R> normal, std::span<R> shear) const {
    for (std::size_t i = 0; i < x.size(); ++i) {
      const Sample<R> there = at(Rational(x[i]));
      const auto larger =
          there.traction.right.value < there.traction.left.value ? &TwoSided<R>::right : &TwoSided<R>::left;
      normal[i] = (there.traction.*larger).value;
      shear[i] = (there.shear.*larger).value;
    }
  }
  /// Returns the traction panel by panel. Stresses below the surface and loads on a mesh are computed from it.
  virtual PiecewiseTraction<R> piecewise_traction() const = 0;
  /// Returns `count` places in each contact component and in each gap of the support, denser towards singular points.
  virtual std::vector<Sample<R>> samples(int count) const = 0;
  /// The same as at() and samples(), with all quantities.
  virtual DetailedSample<R> details_at(const Rational& x) const = 0;
  virtual std::vector<DetailedSample<R>> detailed_samples(int count) const = 0;
};

/// Returns the sum of the components' widths.
template <Real R>
Estimate<R> real_contact_length(const std::vector<ContactComponent<R>>& contact) {
  Estimate<R> length;
  for (const ContactComponent<R>& component : contact) length += component.width;
  return length;
}

/// A solution, or the reason why the method does not apply to the problem.
template <Real R>
struct Attempt {
  std::shared_ptr<const ContactSolution<R>> solution;
  std::string reason;
};

/// Solves by a closed form: the flat punch in full contact, or the parabola whose contact stays inside the support,
/// both with any number of friction jumps.
template <Real R>
Attempt<R> closed_form(const ContactProblem& problem);

}  // namespace steadyslide::numeric
