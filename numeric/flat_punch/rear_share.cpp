#include "numeric/flat_punch/rear_share.hpp"

#include <boost/math/special_functions/beta.hpp>

#include "model/exponent.hpp"

namespace steadyslide::numeric {

template <Real R>
Estimate<R> rear_share(const Rational& s_left, const Rational& s_right, const Rational& u) {
  const R a = to_real<R>(half - Exponent::angle(s_right));
  const R b = to_real<R>(half + Exponent::angle(s_left));
  return Estimate<R>{boost::math::ibeta(a, b, to_real<R>(u)), R(0)}.widened(1000 * epsilon<R>());
}

template Estimate<double> rear_share(const Rational&, const Rational&, const Rational&);
template Estimate<Real50> rear_share(const Rational&, const Rational&, const Rational&);
template Estimate<Real100> rear_share(const Rational&, const Rational&, const Rational&);

}  // namespace steadyslide::numeric
