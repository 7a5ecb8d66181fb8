#pragma once
// Q(x_1, ..., x_n): rational functions with rational coefficients in symbols that nothing relates to each other. There,
// and only there, GiNaC's normal() decides equality: a quotient is zero if and only if its expanded numerator is.

#include <ginac/ginac.h>

#include <set>
#include <string>
#include <vector>

namespace steadyslide::symbolic {

/// Built from symbols and rational numbers by sums, products and integer powers, and nothing else.
bool is_rational_function(const GiNaC::ex& expression);

/// The divisors of the expression as it is written, outer ones first: the bases of negative powers.
void collect_divisors(const GiNaC::ex& expression, std::vector<GiNaC::ex>& divisors);

struct RationalDecision {
  bool identical;
  /// Numerators of the divisors on either side as it was written, up to a factor: where one vanishes, nothing is said.
  std::set<std::string> nonvanishing;
};

/// Is lhs = rhs in Q(symbols)? Throws std::domain_error where a side is no rational function or divides by a zero.
RationalDecision decide_equal(const GiNaC::ex& lhs, const GiNaC::ex& rhs);

/// The limit as the symbol tends to infinity, the others generic. Throws std::domain_error where there is none.
GiNaC::ex limit_at_infinity(const GiNaC::ex& expression, const GiNaC::symbol& symbol);

/// The function in lowest terms, integers as coefficients, the denominator's first one positive, terms by degree and
/// then by symbol name: equal functions print alike, in every run. Throws std::domain_error outside Q(symbols), and
/// where two symbols have one name.
std::string canonical_text(const GiNaC::ex& expression);

}  // namespace steadyslide::symbolic
