#pragma once
// A proof that a polynomial is zero in the exact field, which does not rely on our normal forms. The polynomial is
// written as
//
//   P = sum_k c_k (root_k^2 - square_k) + sum_j e_j (divisor_j inverse_j - 1) + remainder
//
// in independent generators. This is an identity between polynomials and holds for all values of the generators. If
// root_k^2 = square_k and divisor_j inverse_j = 1, then P is the remainder; it is zero if and only if P is zero in the
// field.

#include <vector>

#include "symbolic/coq/polynomial.hpp"

namespace steadyslide::symbolic {

struct Root {
  std::size_t generator;
  Polynomial square;  ///< without roots and inverses
};

struct Inverse {
  std::size_t generator;
  Polynomial divisor;  ///< contains no inverse that follows this one
};

struct Cofactors {
  std::vector<Polynomial> roots;
  std::vector<Polynomial> inverses;
  Polynomial remainder;
};

/// Computes the cofactors by successive division, the last inverse first.
Cofactors cofactors(const Polynomial& polynomial, const std::vector<Root>& roots, const std::vector<Inverse>& inverses);

}  // namespace steadyslide::symbolic
