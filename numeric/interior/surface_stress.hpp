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

/// Returns the stress on the side of the larger pressure. Numbers are NaN where the pressure is infinite and they are sums
/// of infinite terms.
template <Real R>
StressState<R> surface_stress(const Elasticity& elasticity, const DetailedSample<R>& sample);

}  // namespace steadyslide::numeric
