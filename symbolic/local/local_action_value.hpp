#pragma once
// The local action of the operator as numbers: what the symbols of local_action.hpp say of one density, cut off at
// |x| = 1, their far part included. Without GiNaC in this header. Not thread-safe, as GiNaC is not.

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

/// One wrong symbol: the variants a check has to refute.
enum class WrongSymbol { cotangent_sign, cosecant_sign, sides_exchanged, pi_missing };

/// H of it at 0 < |x| <= 1/4. Throws std::domain_error elsewhere, for lambda <= -1 or an integer, and digits < 1.
Decimal local_action_value(const LocalAction& action, const Rational& x, int digits,
                           std::optional<WrongSymbol> wrong = std::nullopt);

}  // namespace steadyslide::symbolic
