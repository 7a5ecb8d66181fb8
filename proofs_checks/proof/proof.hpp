#pragma once
// Checks a written proof step by step: each fact must follow from the facts above it for the reason that stands beside
// it.
//
//   identity     the theory lists identities for the fact; all name it and hold, and their divisors cannot vanish or are
//                given as nonzero
//   sign         positive("E"), negative("E"), nonzero("E"), E a polynomial in the parameters: decided for all parameters
//   enclosure    the fact is decided over boxes that together cover the parameters
//   theorem      the facts above match the needs of the theorem, with one meaning of each variable
//   definition   the facts above match the definition of the word
//   inference    the facts above match those from which the theory infers the word
//   entry        another entry with a complete proof for these parameters concludes it; its assumptions stand above
//
// Each conclusion must be given by a step, not assumed. Each assumption must be used by a step.
//
// A fact that has a meaning must hold on all instances of its things, and a rule on all general instances
// (meaning.hpp).
//
// The checker trusts no written step: if a fact does not follow, the proof has a gap that names it.

#include <functional>
#include <set>
#include <string>
#include <vector>

#include "model/truth.hpp"
#include "proofs_checks/proof/proof_text.hpp"
#include "proofs_checks/proof/theory.hpp"

namespace steadyslide::proofs_checks {

class Meaning;

struct Decision {
  Truth holds = Truth::unknown;
  std::vector<std::string> words = {};     ///< the decided statements
  std::vector<std::string> divisors = {};  ///< divisors of an identity that could vanish
  std::vector<Fact> decides = {};          ///< the facts that an identity names
};

struct ProofNode {
  Fact fact;
  std::string by;  ///< "assumed", "theorem plemelj"
  std::vector<std::string> words = {};
  std::vector<std::size_t> from = {};  ///< the nodes that it follows from
};

struct CheckedProof {
  ProofText text;
  std::vector<ProofNode> nodes;  ///< the assumptions, then the steps up to the gap
  std::string gap;
  std::string counterexample = {};  ///< the instance on which a fact or a rule fails
  /// The theorems, definitions and inferences of this proof and of the entries that it cites: those that hold on
  /// instances, and those that only a reader can judge.
  std::set<std::string> rules_run = {}, rules_in_words = {};

  bool complete() const { return gap.empty(); }
};

/// The functions that decide steps. Each may throw. The result for an undecided step is unknown.
struct Decisions {
  std::function<Decision(const std::string& id)> identity;
  /// Decides if the polynomial is positive on the box.
  std::function<Truth(const std::string& polynomial, const Box& box)> positive;
  std::function<Decision(const std::string& id, const Box& box)> enclosure;
  /// Returns the proof of another entry, or null if there is no such entry or it has no proof.
  std::function<const CheckedProof*(const std::string& id)> entry;
  /// Null if nothing is run on instances.
  const Meaning* meaning = nullptr;
};

/// Returns the checked proof. Throws std::logic_error if a fact uses words that are not declared.
CheckedProof check_proof(const ProofText& text, const Theory& theory, const Decisions& decisions);

/// A line of a proof's tree. The tree goes from the conclusions down to the facts that they follow from, in the order
/// of a text.
struct TreeLine {
  std::size_t node;
  std::size_t depth;
  bool again;  ///< the node and the facts below it stand in an earlier line
};
std::vector<TreeLine> tree_of(const CheckedProof& proof);

/// Returns "4 identities, 2 classical theorems (liouville, plemelj), 1 entry (rh-load); rests on 2 rules in words".
std::string count_of_steps(const CheckedProof& proof);

}  // namespace steadyslide::proofs_checks
