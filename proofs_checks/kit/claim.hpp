#pragma once
// A claim: a statement with its place in the paper, the check that examines it, and its controls. Controls are wrong
// variants of the formula, and the same check must refute them. A check that accepts a wrong variant has checked
// nothing.

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "numeric/number/real.hpp"
#include "proofs_checks/kit/claim_text.hpp"
#include "proofs_checks/kit/evidence.hpp"

namespace steadyslide::proofs_checks {

struct Context {
  numeric::Digits digits = numeric::Digits::fifty;
  std::uint64_t seed = 1;  ///< seed of the random parameters
  bool quick = false;      ///< examine fewer parameters
};

/// Returns the same evidence for the same context. If it throws, the claim stays undecided.
using Examination = std::function<std::vector<Evidence>(const Context&)>;

struct Control {
  std::string name;  ///< the mistake in this variant
  Examination examine;
};

struct Claim : ClaimText {
  Examination examine;
  std::vector<Control> controls;
  std::string group = {};  ///< the folder of the claim's source, named after its place in the paper: "theorem-3"
};

/// Returns the claim with its text alone, without check and controls. with_proof() adds the check of a proof in the
/// text.
Claim words_alone(std::string_view id);

/// Returns the claim for a statement that no calculation decides. Its text gives the reason. It stays undecided and is
/// listed as beyond calculation.
Claim beyond_calculation(std::string_view id);

}  // namespace steadyslide::proofs_checks
