#pragma once
// The surface symbols of one layer to any number of digits, in CLN, by the decided formulas of layer_formulas.hpp. Not
// thread-safe, because CLN is not.

#include <optional>

#include "model/body.hpp"
#include "symbolic/cln/decimal.hpp"

namespace steadyslide::symbolic {

struct ClnLayerSymbols {
  Decimal normal;    ///< W
  Decimal coupling;  ///< gamma V
};

/// Returns the symbols of a layer on an elastic half-plane, or on a rigid base if `base` is absent, at the wave number
/// k. Throws std::domain_error unless k > 0 and digits >= 1.
ClnLayerSymbols cln_layer_symbols(const Layer& layer, const std::optional<Solid>& base, Plane plane, const Rational& k,
                                  int digits);

}  // namespace steadyslide::symbolic
