#pragma once
// Resultants from the load under each friction value: normal, tangential, effective friction f = sum f_k P_k/P, shares.

#include <vector>

#include "numeric/solution/contact_solution.hpp"

namespace steadyslide::numeric {

/// `loads[k]` = -int t under friction[k]. The centre of pressure is left to the caller.
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

}  // namespace steadyslide::numeric
