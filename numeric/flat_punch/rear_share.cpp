#include <arb_hypgeom.h>

#include "model/exponent.hpp"
#include "numeric/flat_punch/flat_punch.hpp"

namespace steadyslide::numeric {
namespace {

/// Returns I_u(a, b), the regularised incomplete beta function, computed by Arb. Boost.Math's function has tables of
/// MPFR numbers, which every program would compute at its start.
template <Real R>
R regularised_beta(const R& a, const R& b, const R& u) {
  constexpr slong spare = 64;
  const Real100 numbers[] = {Real100(a), Real100(b), Real100(u)};
  arb_t balls[3];
  for (int i = 0; i < 3; ++i) {
    arb_init(balls[i]);
    arf_set_mpfr(arb_midref(balls[i]), numbers[i].backend().data());
  }
  arb_hypgeom_beta_lower(balls[0], balls[0], balls[1], balls[2], 1, std::numeric_limits<Real100>::digits + spare);
  Real100 value;
  arf_get_mpfr(value.backend().data(), arb_midref(balls[0]), MPFR_RNDN);
  for (auto& ball : balls) arb_clear(ball);
  return static_cast<R>(value);
}

}  // namespace

template <Real R>
Estimate<R> rear_share(const Rational& s_left, const Rational& s_right, const Rational& u) {
  const R a = to_real<R>(half - Exponent::angle(s_right));
  const R b = to_real<R>(half + Exponent::angle(s_left));
  return Estimate<R>{regularised_beta(a, b, to_real<R>(u)), R(0)}.widened(1000 * epsilon<R>());
}

#define STEADYSLIDE_INSTANTIATE(R) template Estimate<R> rear_share(const Rational&, const Rational&, const Rational&);
STEADYSLIDE_FOR_EACH_REAL(STEADYSLIDE_INSTANTIATE)
#undef STEADYSLIDE_INSTANTIATE

}  // namespace steadyslide::numeric
