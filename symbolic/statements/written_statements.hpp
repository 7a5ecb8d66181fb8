#pragma once
// Statements as they are written in the texts of this folder. A line that is not indented names a statement; below it:
//
//   # a comment
//   says WORDS                        the statement in words
//   field s_l, s_r                    frictions: r(s), cos(s), sin(s), angle(s) and phase(form) then have a meaning
//   let a = EXPR, f(x) = EXPR         names; any other name is a symbol
//   for e = 1, -1                     the lines up to `end` for each value
//   equal NAME :: LHS = RHS           an equation in the field of phases; without NAME :: one between rational functions
//   wrong WORDS :: a = EXPR, ...      a variant: other values of names that `let` gives; in EXPR all names have their right values
//
// Functions of every text: expand(f), normal(f), log(f), diff(f, x), coeff(f, x, n); at(f, x, v, y, w, ...) puts v for x, w
// for y, ...; squares(f, p, v, q, w, ...) puts v for p^2, w for q^2, ... in the expanded f; ratio(s, h, d), source(s, h, d):
// jump_relation, h = i and d = 1 where they are left out; left_edge(alpha), right_edge(alpha), left_free(alpha),
// right_free(alpha), jump(alpha_l, alpha_r): the derived exponents; power_sum(k, p_1, e_1, p_2, e_2, ...); series_of_Y(n,
// sigma_1, sigma_2, ...), the coefficient of z^(S-n). `i` is the imaginary unit, phase(form) = exp(i pi form).
//
// A line that is indented deeper continues the one before. A statement without lines is one that C++ decides. The lines
// below `definitions` are put before the lines of each later statement; the next `definitions` replaces them.

#include <ginac/ginac.h>

#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "symbolic/field/exact_identity.hpp"

namespace steadyslide::symbolic {

using WrittenFunctions = std::map<std::string, std::function<GiNaC::ex(const std::vector<GiNaC::ex>&)>>;

/// The statements of the text in its order, those without lines from `decided_elsewhere`; `more`: functions that its
/// expressions may use besides those of every text. Throws std::logic_error where the text cannot be read, where a
/// statement is missing, and where one that was decided elsewhere is not in the text.
std::vector<DecidedStatement> written_statements(std::string_view text,
                                                 const std::vector<DecidedStatement>& decided_elsewhere = {},
                                                 const WrittenFunctions& more = {});

}  // namespace steadyslide::symbolic
