#pragma once
// A proof as it is written, the part "Proof" of a claim's text:
//
//   For `s in [0, oo[`, `P in ]0, oo[`.          the parameters, and their ranges; absent where there are none
//   Assumes `contact-around(c)`.                 what is taken as given; who cites the entry has to show it
//   Concludes `solves(flat-punch)`.              what the statement says
//
//   - identity: kernel(flat-punch)               what the theory's table says decides it
//   - sign: nonzero("nu - 1")                    a polynomial's sign over the parameters: positive, negative, nonzero
//   - enclosure: small(gamma)                    likewise, over boxes that together cover the parameters
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
  std::string name = {};  ///< of the theorem or the entry
};

struct ProofText {
  Box parameters;
  std::vector<Fact> assumes;
  std::vector<Fact> concludes;
  std::vector<ProofStep> steps;

  bool empty() const { return steps.empty() && concludes.empty(); }
};

/// The lines of the part. Throws std::logic_error where they do not have this form.
ProofText parse_proof(const std::vector<std::string_view>& lines);

/// "identity", "theorem plemelj".
std::string by_what(const ProofStep& step);

}  // namespace steadyslide::proofs_checks
