#include "proofs_checks/instruments/identities/gamma_range.hpp"

namespace steadyslide::proofs_checks::gamma_range {

Claim claim() {
  return gamma_claim(
             "gamma-range", Plane::strain, [](const Rational& nu) { return Rational((1 - 2 * nu) / (2 * (1 - nu))); },
             0, Rational(3, 4))
      .wrong("a factor 2 missing: `(1-2nu)/(1-nu)`",
             with_gamma([](const Rational& nu) { return Rational((1 - 2 * nu) / (1 - nu)); }))
      .wrong("the sign of `nu`: `(1+2nu)/(2(1+nu))`",
             with_gamma([](const Rational& nu) { return Rational((1 + 2 * nu) / (2 * (1 + nu))); }))
      .wrong("the constant of plane stress: `(1-nu)/2`",
             with_gamma([](const Rational& nu) { return Rational((1 - nu) / 2); }))
      .wrong("the interval ]0, 1[", with_range(0, 1))
      .wrong("the interval ]0, 1/2[", with_range(0, Rational(1, 2)))
      .wrong("the interval ]1/4, 3/4[", with_range(Rational(1, 4), Rational(3, 4)))
      .near_misses();
}

}  // namespace steadyslide::proofs_checks::gamma_range
