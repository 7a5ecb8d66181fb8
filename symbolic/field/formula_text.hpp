#pragma once
// Formulas for readers, made from the canonical text of field elements: LaTeX, and products with the necessary
// parentheses. The canonical text is the same in every run, so these formulas are too. This header does not include
// GiNaC.

#include <functional>
#include <map>
#include <string>

#include "symbolic/field/angle_form.hpp"
#include "symbolic/field/derivation.hpp"

namespace steadyslide::symbolic {

/// Maps the name of a symbol in canonical text to its LaTeX. "sqrt7" becomes \sqrt{7} unless it is listed; other names
/// do not change.
using LatexNames = std::map<std::string, std::string>;

/// Converts "(2*s_l^2 - 1)/(3*pi)" to "\frac{2 s_-^{2}-1}{3 \pi}".
std::string latex_of(const std::string& canonical_text, const LatexNames& names);

/// Returns coefficient * factor, where the coefficient is canonical text: "", "-", "2*" or "(s + 1)*" before the
/// factor. Returns the factor alone if the coefficient is 1, "0" if it is 0, and the coefficient alone if the factor is
/// empty.
Formula product(const std::string& canonical_text, const Formula& factor, const LatexNames& names);

/// Returns a + b. If b begins with a minus sign, the result is "a - ..." with the rest of b.
Formula sum(const Formula& a, const Formula& b);

/// Returns a formula such as "1/2 - alpha_0"; `angle` names the angle of a friction.
Formula formula_of(const AngleForm& form, const std::function<Formula(std::size_t)>& angle);

}  // namespace steadyslide::symbolic
