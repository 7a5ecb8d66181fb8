#pragma once
// The format of statements in the texts of this folder. A line without indentation names a statement. Below it:
//
//   # a comment
//   says FACTS :: WORDS               the statement in words, and the facts of proofs that it decides; without FACTS ::
//                                     none; says WORD continues the statement of the facts with this word
//   field s_l, s_r                    frictions: r(s), cos(s), sin(s), angle(s) and phase(form) then have a meaning
//   let a = EXPR, f(x) = EXPR         names
//   for e = 1, -1, 3..7               the lines up to `end`, or to the end of the statement, for each value
//   equal NAME :: LHS = RHS           an equation in the field of phases; without NAME :: of rational functions
//   wrong WORDS :: a = EXPR, ...      a variant: other values of names that `let` gives; in EXPR all names have their
//                                     right values
//
// A line with deeper indentation continues the line before it. Several lines `says` make several statements, each of the
// equations after it; an id is then the name, a dash and the word of the first fact. A wrong variant is a control of the
// statements that it breaks. Each statement needs one. A statement without lines is decided in C++.
//
// Other lines without indentation:
//
//   file equation.txt                 the name of the file that follows; build files write this line
//   symbols x, e_*                    in the rest of the file x and e_0, e_1, ... are symbols; other names are errors
//   definitions                       the lines below it are added to each later statement, up to the next
//                                     `definitions`: lines from the first `equal` or `for` on go after the statement,
//                                     the others before it
//
// Lists: [a, 0..3] and [f(j) | j = 0..3]; the first entry of p is p[0]. e_{j} is the name e_2 if j = 2, and {j} in the
// name of an equation is replaced by its value. `i` is the imaginary unit, `edge` and `free` are 0 and 1,
// phase(form) = exp(i pi form), alpha_k the angle of the k-th friction of the field.
//
// Functions of every text: expand(f), normal(f), log(f), diff(f, x), coeff(f, x, n), integral(f, x, a, b) of a
// polynomial, chebyshev_T(n, x), chebyshev_U(n, x), max(a, ...), sum(list), polynomial(coefficients, x); same(a, b) is
// 1 or 0; at(f, x, v, y, w, ...) replaces x by v, y by w, ...; squares(f, p, v, q, w, ...) replaces p^2 by v, q^2 by w,
// ... in the expanded f; ratio(s, h, d), source(s, h, d): jump_relation, with default values h = i and d = 1;
// left_edge(alpha), right_edge(alpha), left_free(alpha), right_free(alpha), jump(alpha_l, alpha_r): the derived
// exponents; powers(left, right, jumps, ...): the powers of Y for components from left to right; sign(f): 1 or -1,
// decided in the field. With lists of powers, places, power sums and coefficients, as in polynomial_slope.hpp:
// power_sums(powers, places, n), binomials(powers, places, n), series_of_Y(sums), series_of_reciprocal(sums),
// N_of(order, slope, sums, load over pi), conditions(the same), F_of(order, slope, N, series, n).

#include <ginac/ginac.h>

#include <string>
#include <string_view>
#include <vector>

#include "symbolic/field/exact_identity.hpp"
#include "symbolic/statements/written_functions.hpp"

namespace steadyslide::symbolic {

/// Returns the statements of the text in its order. Statements without lines come from `decided_elsewhere`. `more` are
/// functions that its expressions may use in addition to the functions of every text. Throws std::logic_error with file
/// and line if the text cannot be read, if a statement is missing, or if a statement in `decided_elsewhere` is not in
/// the text.
std::vector<DecidedStatement> written_statements(std::string_view text,
                                                 const std::vector<DecidedStatement>& decided_elsewhere = {},
                                                 const WrittenFunctions& more = {});

}  // namespace steadyslide::symbolic
