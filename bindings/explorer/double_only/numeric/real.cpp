#include "numeric/number/real.hpp"

namespace steadyslide::numeric {

template <Real R>
R pi() {
  return 0x1.921fb54442d18p+1;
}

/// Correctly rounded, like all conversions from rationals that are not GMP's.
template <Real R>
R to_real(const Rational& value) {
  return value.convert_to<R>();
}

#define STEADYSLIDE_INSTANTIATE(R) \
  template R pi();                 \
  template R to_real(const Rational&);
STEADYSLIDE_FOR_EACH_REAL(STEADYSLIDE_INSTANTIATE)
#undef STEADYSLIDE_INSTANTIATE

}  // namespace steadyslide::numeric
