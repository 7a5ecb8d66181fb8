#pragma once
// Decides if a polynomial with rational coefficients is positive on a product of intervals. The decision is exact and
// takes no samples.
//
// Each interval is mapped to [0, oo[ or ]0, oo[: x = a + y, x = b - y, x = (a + b y)/(1 + y). If the numerator then has
// no negative coefficient, the polynomial is positive wherever the monomials that remain at y = 0 do not all vanish. If
// it has a negative coefficient, an interval is halved. In one variable this ends for every polynomial without zeros in
// the closed interval (Vincent's theorem in Bernstein's form). This header does not include GiNaC.

#include <map>
#include <optional>
#include <string>

#include "model/rational.hpp"
#include "model/truth.hpp"

namespace steadyslide::symbolic {

struct ParameterRange {
  std::optional<Rational> from, to;  ///< absent: unbounded
  bool with_from = false, with_to = false;
};

/// Decides a text in GiNaC's syntax, such as "1 - 4*alpha^2" for alpha in ]-1/2, 1/2[. Returns `unknown` if some
/// thousand boxes do not decide it. Throws std::domain_error if the text is not a polynomial in names that have a
/// range.
Truth is_positive(const std::string& polynomial, const std::map<std::string, ParameterRange>& ranges);

}  // namespace steadyslide::symbolic
