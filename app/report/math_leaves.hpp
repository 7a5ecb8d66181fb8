#pragma once
// The smallest parts of a formula as MathML: names, numbers, signs, brackets, scripts.

#include <string>
#include <string_view>
#include <vector>

#include "app/report/math_row.hpp"

namespace steadyslide::app {

MathItem number_item(std::string_view digits);
/// A letter, alpha, dx, or a longer name, which is set upright.
MathItem name_item(std::string_view name);
/// What is no operand: a function, a word, the sign of an operation or a relation. Signs say their spaces: MathML takes
/// an operator at the beginning of a row, where a line may have been broken, for a prefix.
MathItem symbol_item(const MathSymbol& symbol, bool small);
/// A sign before an operand, or after one: -x, c+.
MathItem prefix_item(const MathSymbol& symbol);
MathItem postfix_item(const MathSymbol& symbol);
MathItem group_item(std::string_view open, MathRow row, std::string_view close);

struct Scripts {
  std::vector<std::string> sub, sup;
  std::size_t primes = 0;

  bool empty() const { return sub.empty() && sup.empty() && primes == 0; }
};
MathItem scripted(MathItem base, const Scripts& scripts);
MathItem accented(MathItem base, std::string_view accent);

/// A name inside a script, without braces: xx of sigma_xx is two letters, poly a word.
std::string script_name(std::string_view name);

}  // namespace steadyslide::app
