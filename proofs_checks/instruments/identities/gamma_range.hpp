#pragma once
// The coupling constant gamma of a rigid indenter over all Poisson ratios: a formula, and the interval it fills for
// -1 < nu < 1/2, against what Kolosov's constants give.

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

/// 29 values from -19/20 to 9/20, and random ones.
std::vector<Rational> poisson_ratios(const Context& context, std::string_view stream);

using GammaFormula = std::function<Rational(const Rational& nu)>;

/// "gamma" at every nu, "supremum" next to -1, "infimum" next to 1/2, and that gamma decreases.
ComparedClaim<PoissonRatio> gamma_claim(std::string id, Plane plane, GammaFormula gamma, const Rational& infimum,
                                        const Rational& supremum);

/// The prediction with another formula, or another interval.
std::function<void(Values&, const PoissonRatio&)> with_gamma(GammaFormula gamma);
std::function<void(Values&, const PoissonRatio&)> with_range(const Rational& infimum, const Rational& supremum);

}  // namespace steadyslide::proofs_checks
