#pragma once
// The stress at the surface itself, from the limits of a sample (contact_solution.hpp), all in the user's units:
//
//   sigma_zz = t,   sigma_xz = -t_t,   sigma_xx = t + 2 H t_t,   H t_t = u_t'/c - gamma t,   H t = u'/c + gamma t_t
//
// [Bal16, (2) and (3)]. H is (1/pi) PV int t/(x'-x) dx'. At the surface W of force_sums.hpp is t_t - H t.

#include "model/elasticity.hpp"
#include "numeric/interior/stress_state.hpp"
#include "numeric/solution/contact_solution.hpp"

namespace steadyslide::numeric {

/// Returns the stress on the side of the larger pressure. Numbers are NaN if the pressure is infinite and they are sums of
/// infinite terms.
template <Real R>
StressState<R> surface_stress(const Elasticity& elasticity, const DetailedSample<R>& sample) {
  const auto side = sample.traction.right.value < sample.traction.left.value ? &TwoSided<R>::right : &TwoSided<R>::left;
  const Estimate<R>&t = sample.traction.*side, &shear = sample.shear.*side;
  const R c = to_real<R>(elasticity.compliance()), gamma = to_real<R>(elasticity.gamma());
  const Estimate<R> of_shear = sample.shear_slope.*side / c - gamma * t;
  const Estimate<R> of_pressure = sample.slope.*side / c + gamma * shear;
  return HookesLaw<R>(elasticity).completed(t + R(2) * of_shear, t, -shear, pi<R>() * (shear - of_pressure));
}

}  // namespace steadyslide::numeric
