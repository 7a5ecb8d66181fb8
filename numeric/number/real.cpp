#include "numeric/number/real.hpp"

namespace steadyslide::numeric {

template <Real R>
R to_real(const Exponent& exponent) {
  const Exponent::Reduced reduced = exponent.reduced();
  return to_real<R>(Rational(reduced.halves) / 2) + atan(to_real<R>(reduced.slope)) / pi<R>();
}

template <Real R>
R cos_pi_alpha(const Rational& s) {
  return 1 / sqrt(to_real<R>(1 + s * s));
}

#define STEADYSLIDE_INSTANTIATE(R)     \
  template R to_real(const Exponent&); \
  template R cos_pi_alpha(const Rational&);
STEADYSLIDE_FOR_EACH_REAL(STEADYSLIDE_INSTANTIATE)
#undef STEADYSLIDE_INSTANTIATE

}  // namespace steadyslide::numeric
