#pragma once
// Is a polynomial with rational coefficients positive on a product of intervals? Decided, not sampled.
//
// Each interval is carried onto [0, oo[ or ]0, oo[: x = a + y, x = b - y, x = (a + b y)/(1 + y). If the numerator then has no
// negative coefficient, the polynomial is positive wherever the monomials that are left at y = 0 do not all vanish; if it has
// a negative one, an interval is halved. In one variable this ends for every polynomial without zeros in the closed
// interval (Vincent's theorem in Bernstein's form). Without GiNaC in this header.

#include <map>
#include <optional>
#include <string>

#include "model/rational.hpp"
#include "model/truth.hpp"

namespace steadyslide::symbolic {

struct ParameterRange {
  std::optional<Rational> from, to;  ///< none: unbounded
  bool with_from = false, with_to = false;
};

/// Of "1 - 4*alpha^2" for alpha in ]-1/2, 1/2[, written as GiNaC reads it. `unknown` where some thousand boxes do not decide
/// it. Throws std::domain_error where the text is no polynomial in names that have a range.
Truth is_positive(const std::string& polynomial, const std::map<std::string, ParameterRange>& ranges);

}  // namespace steadyslide::symbolic
