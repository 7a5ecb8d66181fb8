#include "symbolic/cln/cln_evaluation.hpp"

#include <stdexcept>

#include "symbolic/cln/cln_number.hpp"

namespace steadyslide::symbolic {
namespace {

/// The formulas as printed in [Bal16, section 2]. The model uses others, with Kolosov's constant.
Rational gamma(const Rational& nu, Plane plane) {
  if (nu <= -1 || 2 * nu >= 1) throw std::domain_error("gamma: -1 < nu < 1/2; " + to_string(nu));
  return plane == Plane::strain ? Rational((1 - 2 * nu) / (2 * (1 - nu))) : Rational((1 - nu) / 2);
}

}  // namespace

Decimal cln_value(const Exponent& exponent, int digits) {
  if (digits < 1) throw std::domain_error("CLN evaluation: at least one digit; " + std::to_string(digits));
  return rounded(from_cln(to_cln(exponent, digits)), digits);
}

Decimal cln_alpha(const Rational& nu, const Rational& friction, Plane plane, int digits) {
  return cln_value(Exponent::angle(gamma(nu, plane) * friction), digits);
}

}  // namespace steadyslide::symbolic
