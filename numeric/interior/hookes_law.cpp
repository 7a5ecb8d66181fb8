#include "numeric/interior/hookes_law.hpp"

namespace steadyslide::numeric {

template <Real R>
HookesLaw<R>::HookesLaw(const Elasticity& elasticity) {
  const auto& body = elasticity.half_space();
  if (!body) return;
  known_ = true;
  const Rational kolosov = body->kolosov(elasticity.plane());
  poisson_ = elasticity.plane() == Plane::strain ? to_real<R>(body->poisson()) : R(0);
  trace_part_ = to_real<R>((3 - kolosov) / 4);
  rotation_ = to_real<R>((kolosov + 1) / 2) / pi<R>();
  twice_shear_modulus_ = to_real<R>(2 * body->shear_modulus());
}

template <Real R>
StressState<R> HookesLaw<R>::completed(const Estimate<R>& xx, const Estimate<R>& zz, const Estimate<R>& xz,
                                       const Estimate<R>& pi_w) const {
  StressState<R> state{xx, zz, xz, std::nullopt, std::nullopt};
  if (!known_) return state;
  const Estimate<R> trace = xx + zz, rotation = rotation_ * pi_w;
  const R& twice_mu = twice_shear_modulus_;
  state.yy = poisson_ * trace;
  state.gradient = DisplacementGradient<R>{(xx - trace_part_ * trace) / twice_mu, (xz - rotation) / twice_mu,
                                           (xz + rotation) / twice_mu, (zz - trace_part_ * trace) / twice_mu};
  return state;
}

STEADYSLIDE_INSTANTIATE_CLASS(HookesLaw)

}  // namespace steadyslide::numeric
