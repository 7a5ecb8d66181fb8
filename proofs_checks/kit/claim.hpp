#pragma once
// A claim: a statement with its place in the paper, the check that examines it, and its controls: wrong variants of the
// formula that the same check must refute. A check that lets a control pass has checked nothing.

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
  std::uint64_t seed = 1;  ///< of the random parameters
  bool quick = false;      ///< fewer parameters
};

/// Deterministic for a context. May throw: that leaves the claim undecided.
using Examination = std::function<std::vector<Evidence>(const Context&)>;

struct Control {
  std::string name;  ///< what is wrong in it
  Examination examine;
};

struct Claim : ClaimText {
  Examination examine;
  std::vector<Control> controls;
  std::string group = {};  ///< its place in the paper, the folder of its source: "theorem-3"
};

/// The words, whatever stands under "Proof" in them.
Claim words_alone(std::string_view id);

/// A statement that no calculation decides, as its text says: it stays undecided, and is listed as such.
Claim beyond_calculation(std::string_view id);

}  // namespace steadyslide::proofs_checks
