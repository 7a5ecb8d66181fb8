#pragma once
// Resultants from the load under each friction value: normal, tangential, effective friction f = sum f_k P_k/P, shares.

#include <vector>

#include "numeric/solution/contact_solution.hpp"

namespace steadyslide::numeric {

/// `loads[k]` = -int t under friction[k]. The centre of pressure is left to the caller.
template <Real R>
Resultants<R> resultants_of(std::vector<Estimate<R>> loads, const std::vector<Rational>& friction) {
  Resultants<R> result;
  for (const Estimate<R>& load : loads) {
    result.normal.value += load.value;
    result.normal.error += load.error;
    if (load.convergence == Convergence::stalled) result.normal.convergence = Convergence::stalled;
  }
  const R& normal = result.normal.value;
  const R relative = result.normal.error / normal;
  Estimate<R>& mu = result.effective_friction;
  mu.convergence = result.normal.convergence;
  for (std::size_t k = 0; k < friction.size(); ++k) {
    Estimate<R>& share = loads[k];
    share.value /= normal;
    share.error = share.error / normal + relative * share.value;
    const R f = to_real<R>(friction[k]);
    mu.value += f * share.value;
    mu.error += f * share.error;
  }
  result.tangential = {mu.value * normal, mu.error * normal + mu.value * result.normal.error, mu.convergence};
  result.load_share = std::move(loads);
  return result;
}

}  // namespace steadyslide::numeric
