#pragma once
// Why a polynomial is zero in the exact field, for a reader who trusts none of our normal forms: it is written as
//
//   P = sum_k c_k (root_k^2 - square_k) + sum_j e_j (divisor_j inverse_j - 1) + remainder
//
// in independent generators. The identity is one between polynomials, whatever the generators are; where roots have their
// squares and inverses are inverses, P is the remainder, and that is zero if and only if P is zero in the field.

#include <vector>

#include "symbolic/coq/polynomial.hpp"

namespace steadyslide::symbolic {

struct Root {
  std::size_t generator;
  Polynomial square;  ///< without roots and inverses
};

struct Inverse {
  std::size_t generator;
  Polynomial divisor;  ///< without inverses that stand behind this one
};

struct Cofactors {
  std::vector<Polynomial> roots;
  std::vector<Polynomial> inverses;
  Polynomial remainder;
};

/// By successive division, the last inverse first.
Cofactors cofactors(const Polynomial& polynomial, const std::vector<Root>& roots, const std::vector<Inverse>& inverses);

}  // namespace steadyslide::symbolic
