#pragma once
// Hooke's law of the half-space: from the stresses in the plane and W (force_sums.hpp) it finds sigma_yy and the
// displacement gradient (interior_stress.hpp).

#include "model/elasticity.hpp"
#include "numeric/interior/stress_state.hpp"

namespace steadyslide::numeric {

template <Real R>
class HookesLaw {
 public:
  explicit HookesLaw(const Elasticity& elasticity);

  /// Returns all stresses, from the stresses in the plane and pi W. For reduced data sigma_yy and the gradient are absent.
  StressState<R> completed(const Estimate<R>& xx, const Estimate<R>& zz, const Estimate<R>& xz,
                           const Estimate<R>& pi_w) const;

 private:
  bool known_ = false;
  R poisson_ = 0;     ///< sigma_yy/(sigma_xx + sigma_zz)
  R trace_part_ = 0;  ///< (3-kappa)/4
  R rotation_ = 0;    ///< (kappa+1)/(2 pi)
  R twice_shear_modulus_ = 0;
};

}  // namespace steadyslide::numeric
