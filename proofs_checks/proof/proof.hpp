#pragma once
// Checks a proof as it is written, step by step: each fact has to follow from those above it by what stands beside it.
//
//   identity     the theory says which identities decide it; all do, and their divisors cannot vanish or are given as facts
//   sign         positive("E"), negative("E"), nonzero("E"), E a polynomial in the parameters: decided over all of them
//   enclosure    it is decided over boxes that together cover the parameters
//   theorem      the facts above match what the theorem needs, with one meaning of each variable
//   definition   the facts above match what the word means
//   inference    the facts above match what the theory infers the word from, in words: nothing is decided
//   entry        another entry, with a complete proof for these parameters, concludes it, and its assumptions are above
//
// What is concluded is given by a step and not assumed, and what is assumed is used by one.
//
// Nothing is believed because it is written: what does not follow is a gap, and says which.

#include <functional>
#include <string>
#include <vector>

#include "model/truth.hpp"
#include "proofs_checks/proof/proof_text.hpp"
#include "proofs_checks/proof/theory.hpp"

namespace steadyslide::proofs_checks {

struct Decision {
  Truth holds = Truth::unknown;
  std::vector<std::string> words = {};     ///< what was decided
  std::vector<std::string> divisors = {};  ///< of an identity, that could vanish
};

struct ProofNode {
  Fact fact;
  std::string by;  ///< "assumed", "theorem plemelj"
  std::vector<std::string> words = {};
  std::vector<std::size_t> from = {};  ///< the nodes that it rests on
};

struct CheckedProof {
  ProofText text;
  std::vector<ProofNode> nodes;  ///< what is assumed, then the steps up to the gap
  std::string gap;

  bool complete() const { return gap.empty(); }
};

/// Whom the runner asks. Each may throw; what it cannot decide is unknown.
struct Decisions {
  std::function<Decision(const std::string& id)> identity;
  /// Is the polynomial positive on the box?
  std::function<Truth(const std::string& polynomial, const Box& box)> positive;
  std::function<Decision(const std::string& id, const Box& box)> enclosure;
  /// Null if there is no such entry, or none with a proof.
  std::function<const CheckedProof*(const std::string& id)> entry;
};

/// Throws std::logic_error where a fact is said in words that are not declared.
CheckedProof check_proof(const ProofText& text, const Theory& theory, const Decisions& decisions);

/// A proof as a tree, from what is concluded down to what it rests on, in the order of a text.
struct TreeLine {
  std::size_t node;
  std::size_t depth;
  bool again;  ///< it stands above, with what it rests on
};
std::vector<TreeLine> tree_of(const CheckedProof& proof);

/// "4 identities, 2 theorems (liouville, plemelj), 1 entry (rh-load)".
std::string count_of_steps(const CheckedProof& proof);

}  // namespace steadyslide::proofs_checks
