#pragma once
// Exact numbers as LaTeX, without GiNaC in this header. The text is made from the exact number itself: GiNaC orders
// terms by memory address, so that its own text may change from run to run.

#include <string>

#include "model/exponent.hpp"
#include "model/rational.hpp"

namespace steadyslide::symbolic {

/// A fraction in lowest terms, for math mode: "-\frac{1}{2}", "3".
std::string latex(const Rational& value);

/// The exponent as it is written (its offset, then its angles in their order), for math mode:
/// "-\frac{1}{2}-\frac{1}{\pi}\arctan\frac{3}{35}". The same exponent gives the same text, always.
std::string latex(const Exponent& exponent);

}  // namespace steadyslide::symbolic
