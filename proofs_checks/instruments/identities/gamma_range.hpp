#pragma once
// The coupling constant gamma of a rigid indenter for all Poisson's ratios. A formula, and the interval of its values
// for -1 < nu < 1/2, are compared with the result from Kolosov's constants.

#include <functional>
#include <string>

#include "model/elasticity.hpp"
#include "proofs_checks/kit/claim_builder.hpp"

namespace steadyslide::proofs_checks {

struct PoissonRatio {
  Rational nu;
  enum class Where { inside, next_to_minus_one, next_to_one_half } where = Where::inside;
};
std::string text_of(const PoissonRatio& c);

/// Returns 29 values from -19/20 to 9/20, and random values.
std::vector<Rational> poisson_ratios(const Context& context, std::string_view stream);

using GammaFormula = std::function<Rational(const Rational& nu)>;

/// Returns a claim about "gamma" at every nu, "supremum" close to -1, "infimum" close to 1/2, and the decrease of
/// gamma.
ComparedClaim<PoissonRatio> gamma_claim(std::string id, Plane plane, GammaFormula gamma, const Rational& infimum,
                                        const Rational& supremum);

/// Change the prediction: another formula, or another interval.
std::function<void(Values&, const PoissonRatio&)> with_gamma(GammaFormula gamma);
std::function<void(Values&, const PoissonRatio&)> with_range(const Rational& infimum, const Rational& supremum);

}  // namespace steadyslide::proofs_checks
