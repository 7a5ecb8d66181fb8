#include "proofs_checks/instruments/identities/gamma_range.hpp"

namespace steadyslide::proofs_checks::gamma_plane_stress {

Claim claim() {
  return gamma_claim(
             "gamma-plane-stress", Plane::stress, [](const Rational& nu) { return Rational((1 - nu) / 2); },
             Rational(1, 4), 1)
      .wrong("the sign of `nu`: `(1+nu)/2`", with_gamma([](const Rational& nu) { return Rational((1 + nu) / 2); }))
      .wrong("the constant of plane strain: `(1-2nu)/(2(1-nu))`",
             with_gamma([](const Rational& nu) { return Rational((1 - 2 * nu) / (2 * (1 - nu))); }))
      .wrong("the interval ]0, 3/4[ of plane strain", with_range(0, Rational(3, 4)))
      .near_misses();
}

}  // namespace steadyslide::proofs_checks::gamma_plane_stress
