#pragma once
// A claim: a statement with its place in the paper, the check that examines it, and its controls: wrong variants of the
// formula that the same check must refute. A check that lets a control pass has checked nothing.

#include <cstdint>
#include <functional>
#include <string>
#include <utility>
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

/// A wrong variant of a formula and what is wrong in it.
template <class Formula>
struct Wrong {
  std::string name;
  Formula formula;
};

/// check(context, formula) is the claim for the right formula and a control for each wrong one: check and formula never
/// mix. The check returns at its first counterexample.
template <class Formula, class Check>
Claim make_claim(ClaimText text, Check check, Formula right, std::vector<Wrong<Formula>> wrong) {
  Claim claim{std::move(text), {}, {}};
  for (Wrong<Formula>& w : wrong) {
    claim.controls.push_back({std::move(w.name), [check, formula = std::move(w.formula)](const Context& context) {
                                return check(context, formula);
                              }});
  }
  claim.examine = [check = std::move(check), formula = std::move(right)](const Context& context) {
    return check(context, formula);
  };
  return claim;
}

/// A statement that no calculation decides: it stays undecided, and is listed as such.
Claim beyond_calculation(std::string_view id, BeyondCalculation why);

}  // namespace steadyslide::proofs_checks
