#pragma once
// The text of a claim: a Markdown file beside its source and with the same name, compiled into the program. A text with
// one of the parts "decided about", Proof, Convergence or Beyond calculation needs no source:
//
//   # rem-01-neglect: [Bal16, remark 1]: the subject
//
//   **Statement.** Our own words, with the formula.
//
//   **Hypotheses.** ...
//
//   **Derivation.** How the statement follows; absent if no calculation gives it.
//
//   | compared | what | measured by | predicted by | how |
//   |---|---|---|---|---|
//   | peak | largest pressure over the frictionless one | solved problems | cos(pi alpha) (...)^alpha | tolerance 1e-8 |
//
//   | decided about | statements | wrong variants |
//   |---|---|---|
//   | flat punch | rh-flat-punch-0, rh-kernel | edges exchanged; without 1/pi |
//
//   **Proof.** Concludes ...                facts that follow from each other (proof/proof_text.hpp)
//
//   **Convergence.** jump-up                the problem of convergence_cases() that is studied on cells
//
//   **Beyond calculation.** ...             the reason why no calculation decides it
//
//   **Checked in its place.** rh-load, ...  ids of claims that check consequences of it
//
// The first table lists the compared numbers and the two routes to each. Both routes stay empty if the check only
// decides if a value is true. The last column gives the comparison: `tolerance 1e-8`, `absolute`, `at most`,
// `required 0.4` and `no near miss` set the members of Quantity. This column may be absent.
//
// The second table lists statements of the symbolic layer by their ids, with all wrong variants that this layer has of
// them. Lines of text are joined. A bar inside a cell is written \|. Formulas stand between backticks, in the notation
// of docs/theory.md: readable as they are, typeset in the report.

#include <string>
#include <string_view>
#include <vector>

#include "proofs_checks/proof/proof_text.hpp"

namespace steadyslide::proofs_checks {

/// A quantity on which unrelated routes must agree, and how their values are compared.
struct Quantity {
  std::string what;
  std::vector<std::string> routes = {};  ///< the route of the measurement and the route of the prediction, or none
  /// The allowed difference. For a number: relative, unless `absolute`; 0 stands for the tolerance of the precision.
  /// For an order: the largest difference of rates. For a fitted number: the number of error bars.
  double tolerance = 0;
  double required = 0.5;  ///< the part of the cases that must be effective
  /// Compares the difference itself, not relative to the larger value. Needed if the prediction is zero.
  bool absolute = false;
  bool at_most = false;   ///< the prediction is an upper bound of the measurement
  bool near_miss = true;  ///< false for truth values and for bounds that are not attained
  std::string name = {};  ///< the name in the check
};

/// Statements of the symbolic layer that share their wrong variants.
struct Family {
  std::string about;  ///< the names of the controls begin with it
  /// The ids of the statements. An id that ends with "-" stands for all statements whose ids begin with it.
  std::vector<std::string> ids;
  /// The mistake in each wrong variant, in the words of the symbolic layer. The list is complete.
  std::vector<std::string> variants;
};

struct ClaimText {
  std::string id;      ///< permanent id: "eq-04-flat-punch"
  std::string source;  ///< "[Bal16, (4)]: ..."
  std::string statement;
  std::string hypotheses;
  std::string derivation = {};
  std::vector<Quantity> compared = {};
  std::vector<Family> decided = {};
  ProofText proof = {};
  std::string convergence = {};
  std::string beyond_calculation = {};
  std::vector<std::string> checked_in_its_place = {};
};

/// Returns the parts of the document. Throws std::logic_error if it does not have this form.
ClaimText parse_claim_text(std::string_view document);

/// Returns the text of the claim with this id. Throws std::logic_error if there is none.
ClaimText claim_text(std::string_view id);

}  // namespace steadyslide::proofs_checks
