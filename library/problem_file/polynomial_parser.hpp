#pragma once
// The profiles of a problem file:
//
//   expr  = term {("+"|"-") term}
//   term  = power {("*"|"/") power}
//   power = ["-"|"+"] atom ["^" digits]      -x^2 is -(x^2)
//   atom  = number | "x" | "(" expr ")"      a number is 2, 0.25 or 1e-3, without sign
//
// The polynomial is exact. A divisor must be constant. There is no implicit product. Spaces may stand between symbols.

#include <string_view>

#include "model/polynomial.hpp"

namespace steadyslide::library {

inline constexpr int max_degree = 64;

/// The remaining budget of work for one problem file, in operations on coefficients.
struct PolynomialBudget {
  long operations = 200000;
};

/// The bits of an exact number: for a rational, the sum of numerator and denominator. The cost of arithmetic grows with
/// it.
std::size_t bits(const Integer& value);
std::size_t bits(const Rational& value);

/// Throws InvalidData (field empty). Its message gives the position in the text, counted from 1.
Polynomial parse_polynomial(std::string_view text, PolynomialBudget& budget);

}  // namespace steadyslide::library
