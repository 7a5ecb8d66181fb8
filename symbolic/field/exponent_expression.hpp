#pragma once
// Exact numbers as LaTeX. This header does not include GiNaC. The text is made from the exact number, because GiNaC
// orders terms by memory address and its text may change from run to run.

#include <string>

#include "model/exponent.hpp"
#include "model/rational.hpp"

namespace steadyslide::symbolic {

/// Returns a fraction in lowest terms, for math mode: "-\frac{1}{2}", "3".
std::string latex(const Rational& value);

/// Returns the exponent (its offset, then its angles in their order) for math mode:
/// "-\frac{1}{2}-\frac{1}{\pi}\arctan\frac{3}{35}". The same exponent always gives the same text.
std::string latex(const Exponent& exponent);

}  // namespace steadyslide::symbolic
