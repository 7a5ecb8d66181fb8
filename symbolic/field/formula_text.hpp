#pragma once
// Formulas for readers, from the canonical text of field elements: LaTeX, and products with the parentheses they need.
// The text of an element is the same in every run, so these are too. Without GiNaC in this header.

#include <functional>
#include <map>
#include <string>

#include "symbolic/field/angle_form.hpp"
#include "symbolic/field/derivation.hpp"

namespace steadyslide::symbolic {

/// A symbol's name in canonical text to its LaTeX; "sqrt7" becomes \sqrt{7} unless named here, other names stay.
using LatexNames = std::map<std::string, std::string>;

/// "(2*s_l^2 - 1)/(3*pi)" to "\frac{2 s_-^{2}-1}{3 \pi}".
std::string latex_of(const std::string& canonical_text, const LatexNames& names);

/// coefficient * factor, where the coefficient is canonical text: "", "-", "2*", "(s + 1)*" before the factor; the
/// factor alone where the coefficient is 1, "0" where it is 0, the coefficient alone where the factor is empty.
Formula product(const std::string& canonical_text, const Formula& factor, const LatexNames& names);

/// a + b, with the sign of b drawn out.
Formula sum(const Formula& a, const Formula& b);

/// "1/2 - alpha_0", where `angle` names the angle of a friction.
Formula formula_of(const AngleForm& form, const std::function<Formula(std::size_t)>& angle);

}  // namespace steadyslide::symbolic
