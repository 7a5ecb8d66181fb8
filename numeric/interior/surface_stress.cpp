#include "numeric/interior/surface_stress.hpp"

#include "numeric/interior/hookes_law.hpp"

namespace steadyslide::numeric {

template <Real R>
StressState<R> surface_stress(const Elasticity& elasticity, const DetailedSample<R>& sample) {
  const auto side = sample.traction.right.value < sample.traction.left.value ? &TwoSided<R>::right : &TwoSided<R>::left;
  const Estimate<R>&t = sample.traction.*side, &shear = sample.shear.*side;
  const R c = to_real<R>(elasticity.compliance()), gamma = to_real<R>(elasticity.gamma());
  const Estimate<R> of_shear = sample.shear_slope.*side / c - gamma * t;
  const Estimate<R> of_pressure = sample.slope.*side / c + gamma * shear;
  return HookesLaw<R>(elasticity).completed(t + R(2) * of_shear, t, -shear, pi<R>() * (shear - of_pressure));
}

#define STEADYSLIDE_INSTANTIATE(R) template StressState<R> surface_stress(const Elasticity&, const DetailedSample<R>&);
STEADYSLIDE_FOR_EACH_REAL(STEADYSLIDE_INSTANTIATE)
#undef STEADYSLIDE_INSTANTIATE

}  // namespace steadyslide::numeric
