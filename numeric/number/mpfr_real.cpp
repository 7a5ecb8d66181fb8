#include "numeric/number/real.hpp"

#include <mpfr.h>

namespace steadyslide::numeric {
namespace {

/// Returns the correctly rounded double. Boost's conversion of a rational truncates.
double nearest_double(const Rational& value) {
  mpfr_t rounded;
  mpfr_init2(rounded, 53);
  mpfr_set_q(rounded, value.backend().data(), MPFR_RNDN);
  const double result = mpfr_get_d(rounded, MPFR_RNDN);
  mpfr_clear(rounded);
  return result;
}

/// MPFR keeps constants and memory for each thread. They are given back when the thread ends.
struct ThreadMemory {
  ~ThreadMemory() { mpfr_free_cache2(MPFR_FREE_LOCAL_CACHE); }
};

template <class R>
bool touch_limits() {
  using Limits = std::numeric_limits<R>;
  return Limits::epsilon() < Limits::round_error() && (Limits::min)() < (Limits::max)() &&
         (Limits::max)() < Limits::infinity() && isnan(Limits::quiet_NaN());
}

}  // namespace

bool make_limits() { return touch_limits<Real50>() && touch_limits<Real100>(); }

template <Real R>
R pi() {
  if constexpr (std::same_as<R, double>) {
    return 0x1.921fb54442d18p+1;
  } else {
    static const R value = [] {
      R made;
      mpfr_const_pi(made.backend().data(), MPFR_RNDN);
      return made;
    }();
    return value;
  }
}

template <Real R>
R to_real(const Rational& value) {
  if constexpr (std::same_as<R, double>) {
    return nearest_double(value);
  } else {
    // Here, because every calculation converts its data.
    thread_local const ThreadMemory memory;
    R result;
    mpfr_set_q(result.backend().data(), value.backend().data(), MPFR_RNDN);
    return result;
  }
}

#define STEADYSLIDE_INSTANTIATE(R) \
  template R pi();                 \
  template R to_real(const Rational&);
STEADYSLIDE_FOR_EACH_REAL(STEADYSLIDE_INSTANTIATE)
#undef STEADYSLIDE_INSTANTIATE

}  // namespace steadyslide::numeric
