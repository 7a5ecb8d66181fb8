#pragma once
// The words of a claim. They stand in a Markdown file beside its source, named like it, and are compiled in; where one
// of the last four parts says it all, there is no source:
//
//   # rem-01-neglect: [Bal16, remark 1]: of what it speaks
//
//   **Statement.** Our own words, with the formula.
//
//   **Hypotheses.** ...
//
//   **Derivation.** How it follows; absent where no calculation says.
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
//   **Convergence.** jump-up                on cells: the problem of convergence_cases() that is studied
//
//   **Beyond calculation.** ...             why no calculation decides it
//
//   **Checked in its place.** rh-load, ...  the ids of claims that check what follows from it
//
// The first table has the numbers that the check compares, and the routes to them; the second the statements of the
// symbolic layer, by their ids, with all the wrong variants that it has of them. Lines of text are joined. A bar within a
// cell is written \|; where only one value is said to be true, both routes stay empty. How numbers are compared: of
// `tolerance 1e-8`, `absolute`, `at most`, `required 0.4` and `no near miss` what Quantity says; the column may be absent.
// Formulas stand between backticks, in the notation of docs/theory.md: readable as they are, typeset in the report.

#include <string>
#include <string_view>
#include <vector>

#include "proofs_checks/proof/proof_text.hpp"

namespace steadyslide::proofs_checks {

/// A quantity that unrelated routes have to agree on, and how it is compared.
struct Quantity {
  std::string what;
  std::vector<std::string> routes = {};  ///< that of the measurement, that of the prediction; or none
  /// Of numbers: that of the precision if a claim's text has none. Of orders: the largest difference of rates. Of fits: of
  /// error bars.
  double tolerance = 0;
  double required = 0.5;  ///< the part of the cases that has to be effective
  bool absolute = false;  ///< the difference itself, not relative to the larger value: where zero is predicted
  bool at_most = false;   ///< the prediction is a bound of what is measured
  bool near_miss = true;  ///< false for truth values and for bounds that are not attained
  std::string name = {};  ///< in the check
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
  std::vector<Quantity> compared = {};
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
