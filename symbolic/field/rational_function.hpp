#pragma once
// Q(x_1, ..., x_n): rational functions with rational coefficients in independent symbols. Only for these does GiNaC's
// normal() decide equality: a quotient is zero if and only if its expanded numerator is zero.

#include <ginac/ginac.h>

#include <set>
#include <string>
#include <vector>

namespace steadyslide::symbolic {

/// True if the expression contains only symbols, rational numbers, sums, products and integer powers.
bool is_rational_function(const GiNaC::ex& expression);

/// Appends the divisors of the expression as written (the bases of negative powers), outer ones first.
void collect_divisors(const GiNaC::ex& expression, std::vector<GiNaC::ex>& divisors);

struct RationalDecision {
  bool identical;
  /// Numerators of the divisors on both sides as written, up to a factor. The decision does not apply where one
  /// vanishes.
  std::set<std::string> nonvanishing;
};

/// Decides if lhs = rhs in Q(symbols). Throws std::domain_error if a side is not a rational function or divides by
/// zero.
RationalDecision decide_equal(const GiNaC::ex& lhs, const GiNaC::ex& rhs);

/// Returns the limit as the symbol tends to infinity, for generic values of the others. Throws std::domain_error if
/// there is none.
GiNaC::ex limit_at_infinity(const GiNaC::ex& expression, const GiNaC::symbol& symbol);

/// Returns the function in lowest terms, with integer coefficients, a positive first coefficient of the denominator,
/// and terms ordered by degree and then by symbol name. Equal functions have equal texts, in every run. Throws
/// std::domain_error if the expression is not in Q(symbols), or if two symbols have the same name.
std::string canonical_text(const GiNaC::ex& expression);

}  // namespace steadyslide::symbolic
