#pragma once
// The words of a claim. They stand in a Markdown file beside its source, named like it, and are compiled in; where one
// of the last three parts says it all, there is no source:
//
//   # rem-01-neglect
//
//   [Bal16, remark 1]: where in the paper, and of what it speaks
//
//   ## Statement      our own words, with the formula
//   ## Hypotheses
//   ## Derivation     how it follows; absent where no calculation says
//   ## Compared       what numbers the check compares, and the routes to them:
//
//   | name | what | measured by | predicted by |
//   |---|---|---|---|
//   | peak | largest pressure over the frictionless one | solved problems | cos(pi alpha) (...)^alpha |
//   ## Decided        statements of the symbolic layer, by their ids, and the wrong variants that it has of them:
//
//   | about | statements | wrong variants |
//   |---|---|---|
//   | flat punch | rh-flat-punch-0, rh-kernel | edges exchanged; without 1/pi |
//   ## Proof                 facts that follow from each other (proof/proof_text.hpp)
//   ## Convergence           on cells: the problem of convergence_cases() that is studied
//   ## Beyond calculation    why no calculation decides it
//   ## Checked in its place  the ids of claims that check what follows from it
//
// Lines are joined. A bar within a cell is written \|; where only one value is said to be true, both routes stay empty.
// Formulas stand between backticks, in the notation of docs/notation.md: readable as they are, typeset in the report.

#include <string>
#include <string_view>
#include <vector>

#include "proofs_checks/proof/proof_text.hpp"

namespace steadyslide::proofs_checks {

/// What a check compares, in words.
struct QuantityText {
  std::string name;  ///< in the check
  std::string what;
  std::vector<std::string> routes;  ///< that of the measurement, that of the prediction; or none
};

/// Statements of the symbolic layer that share their wrong variants.
struct Family {
  std::string about;                  ///< opens the names of the controls
  std::vector<std::string> ids;       ///< of the statements; what ends with "-" is the beginning of several
  std::vector<std::string> variants;  ///< what is wrong, in the words of the symbolic layer: all that it has
};

struct ClaimText {
  std::string id;      ///< permanent: "eq-04-flat-punch"
  std::string source;  ///< "[Bal16, (4)]: ..."
  std::string statement;
  std::string hypotheses;
  std::string derivation = {};
  std::vector<QuantityText> compared = {};
  std::vector<Family> decided = {};
  ProofText proof = {};
  std::string convergence = {};
  std::string beyond_calculation = {};
  std::vector<std::string> checked_in_its_place = {};
};

/// Throws std::logic_error if the document does not have this form.
ClaimText parse_claim_text(std::string_view document);

/// The text of the claim with this id. Throws std::logic_error if there is none.
ClaimText claim_text(std::string_view id);

}  // namespace steadyslide::proofs_checks
