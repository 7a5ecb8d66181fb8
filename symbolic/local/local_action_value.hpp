#pragma once
// Numbers for the local action of the operator: the formulas of local_action.hpp for one density that is cut off at
// |x| = 1, with the far part. This header does not include GiNaC. Not thread-safe, because GiNaC is not.

#include <optional>

#include "model/direction.hpp"
#include "symbolic/cln/decimal.hpp"

namespace steadyslide::symbolic {

/// x^order |x|^lambda log(|x|)^logs on 0 < +-x < 1; lambda is ignored unless `fractional`.
struct LocalAction {
  Side side;
  bool fractional;
  int order;
  int logs;
  Rational lambda;
};

/// A wrong variant of one formula, which a check must refute.
enum class WrongSymbol { cotangent_sign, cosecant_sign, sides_exchanged, pi_missing };

/// Returns H of the density at x, 0 < |x| <= 1/4. Throws std::domain_error for any other x, if lambda <= -1, if lambda
/// is an integer, or if digits < 1.
Decimal local_action_value(const LocalAction& action, const Rational& x, int digits,
                           std::optional<WrongSymbol> wrong = std::nullopt);

}  // namespace steadyslide::symbolic
