#include "numeric/number/real.hpp"

namespace steadyslide::numeric {

template <>
double pi() {
  return 0x1.921fb54442d18p+1;
}

/// Correctly rounded, as of all rationals that are not GMP's.
template <>
double to_real(const Rational& value) {
  return value.convert_to<double>();
}

}  // namespace steadyslide::numeric
