#pragma once
// Decided identities as lemmas of Coq, so that an independent kernel checks them. A lemma states
//
//   for all symbols, roots and inverses in a commutative algebra over Q:
//   r_k^2 = 1 + s_k^2, i^2 = -1, ..., d_j inv_j = 1, ...  imply  lhs = rhs,
//
// with both sides as given. Its proof writes lhs - rhs as a sum of multiples of (left - right) of the hypotheses
// (cofactors.hpp). This is an identity between polynomials, which the tactic `ring` checks; our normal forms only found
// it. This header does not include GiNaC. Not thread-safe, because GiNaC is not.

#include <string>
#include <vector>

#include "symbolic/field/exact_identity.hpp"

namespace steadyslide::symbolic {

struct CoqLemma {
  std::string name;
  std::string text;  ///< a comment in words, the statement, the proof
  bool proved;       ///< false if the cofactors leave a remainder: then the statement is wrong and Coq rejects it
};

/// An equation in which there is nothing to check.
struct NotExported {
  std::string id;
  std::string equation;
  std::string reason;
};

struct CoqLemmas {
  std::vector<CoqLemma> lemmas;
  std::vector<NotExported> not_exported;
};

/// Returns one lemma for each equation, named after the statement: rh_plemelj_1, rh_plemelj_2.
CoqLemmas coq_lemmas(const std::string& id, const ExactIdentity& identity);

/// Returns a complete file that coqc can compile.
std::string coq_file(const std::vector<CoqLemma>& lemmas);

}  // namespace steadyslide::symbolic
