#pragma once
// A written proof, the part "Proof" of a claim's text:
//
//   For `s in [0, oo[`, `P in ]0, oo[`.          the parameters and their ranges; absent if there are none
//   Assumes `contact-around(c)`.                 the assumptions; a proof that cites the entry must show them
//   Concludes `solves(flat-punch)`.              the claim's statement as facts
//
//   - identity: kernel(flat-punch)               decided by the identities in the theory's table
//   - sign: nonzero("nu - 1")                    a polynomial's sign over the parameters: positive, negative, nonzero
//   - enclosure: small(gamma)                    decided over boxes that together cover the parameters
//   - theorem plemelj: plemelj(flat-punch)
//   - definition: solves(flat-punch), carries(flat-punch)
//   - inference: pressing(flat-punch)
//   - entry n-jump-punch: load({flat-punch, parabola})
//
// A line holds the steps that one reason gives, from left to right; braces hold alternatives (proof/fact.hpp).

#include <string>
#include <string_view>
#include <vector>

#include "proofs_checks/proof/box.hpp"
#include "proofs_checks/proof/fact.hpp"

namespace steadyslide::proofs_checks {

struct ProofStep {
  enum class Kind { identity, sign, enclosure, theorem, definition, inference, entry };

  Fact fact;
  Kind kind;
  std::string name = {};  ///< the name of the theorem or the entry
};

struct ProofText {
  Box parameters;
  std::vector<Fact> assumes;
  std::vector<Fact> concludes;
  std::vector<ProofStep> steps;

  bool empty() const { return steps.empty() && concludes.empty(); }
};

/// Reads the lines of the part "Proof". Throws std::logic_error if they do not have this form.
ProofText parse_proof(const std::vector<std::string_view>& lines);

/// Returns the reason of a step: "identity", "theorem plemelj".
std::string by_what(const ProofStep& step);

}  // namespace steadyslide::proofs_checks
