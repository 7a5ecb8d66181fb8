#pragma once
// The words of a claim. They stand in a Markdown file beside its source, named like it, and are compiled in:
//
//   # rem-01-neglect
//
//   [Bal16, remark 1]: where in the paper, and of what it speaks
//
//   ## Statement      our own words, with the formula
//   ## Hypotheses
//   ## Derivation     how it follows; absent where no calculation says
//
// Lines are joined. Formulas stand between backticks, in the notation of docs/notation.md: readable as they are,
// typeset in the report.

#include <string>
#include <string_view>

namespace steadyslide::proofs_checks {

struct ClaimText {
  std::string id;      ///< permanent: "eq-04-flat-punch"
  std::string source;  ///< "[Bal16, (4)]: ..."
  std::string statement;
  std::string hypotheses;
  std::string derivation = {};
};

/// Throws std::logic_error if the document does not have this form.
ClaimText parse_claim_text(std::string_view document);

/// The text of the claim with this id. Throws std::logic_error if there is none.
ClaimText claim_text(std::string_view id);

}  // namespace steadyslide::proofs_checks
