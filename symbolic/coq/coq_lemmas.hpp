#pragma once
// Decided identities as lemmas of Coq, for a kernel that is not ours. A lemma says
//
//   for all symbols, roots and inverses in a commutative algebra over Q:
//   r_k^2 = 1 + s_k^2, i^2 = -1, ..., d_j inv_j = 1, ...  imply  lhs = rhs,
//
// with both sides as they were put in. Its proof gives lhs - rhs as a sum of multiples of the hypotheses' differences
// (cofactors.hpp), an identity between polynomials that the tactic `ring` checks; our normal forms only found it. Without
// GiNaC in this header. Not thread-safe, as GiNaC is not.

#include <string>
#include <vector>

#include "symbolic/field/exact_identity.hpp"

namespace steadyslide::symbolic {

struct CoqLemma {
  std::string name;
  std::string text;  ///< a comment in words, the statement, the proof
  bool proved;       ///< without it the cofactors leave a remainder: a wrong statement, which Coq refuses
};

/// An equation in which there is nothing left to check.
struct NotExported {
  std::string id;
  std::string equation;
  std::string reason;
};

struct CoqLemmas {
  std::vector<CoqLemma> lemmas;
  std::vector<NotExported> not_exported;
};

/// One lemma an equation, named after the statement: rh_plemelj_1, rh_plemelj_2.
CoqLemmas coq_lemmas(const std::string& id, const ExactIdentity& identity);

/// A file that coqc compiles by itself.
std::string coq_file(const std::vector<CoqLemma>& lemmas);

}  // namespace steadyslide::symbolic
