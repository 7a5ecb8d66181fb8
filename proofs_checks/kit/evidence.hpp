#pragma once
// The result of an examination of a claim. Evidence has types, so that rules decide the verdict and nobody asserts it.

#include <cstddef>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "proofs_checks/proof/proof.hpp"

namespace steadyslide::proofs_checks {

/// Equations decided exactly: as rational functions of independent symbols, or by exact arithmetic on exponents. They
/// support a claim. Only a proof can show that the claim follows from them.
struct ExactIdentity {
  std::string detail;
  std::vector<std::string> identities;
};

/// Unrelated routes to one number that agreed within the tolerance in each case.
struct Agreement {
  std::string what;
  std::vector<std::string> routes;
  std::string worst;      ///< the largest difference
  std::string tolerance;  ///< the allowed difference
  std::size_t cases = 0;  ///< examined cases
  /// Cases at which the statement says something: a friction jump of nonzero height, a rule that converged.
  std::size_t effective = 0;
  std::size_t required = 1;  ///< with fewer effective cases the agreement shows nothing
  std::string detail;        ///< the origin of the cases, with the seed
};

/// An error that falls as a power of the number of cells. The measured power should be within `tolerance` of the
/// expected one.
struct ConvergenceRate {
  std::string what;
  double measured = 0;
  double error_bar = 0;  ///< one standard deviation
  double expected = 0;
  double tolerance = 0;
  std::string detail;
};

/// A case in which the statement is wrong.
struct Counterexample {
  std::string where;  ///< the parameters
  std::string detail;
};

/// A statement that no calculation decides: an abstract existence proof, or one whose proof the available text does not
/// contain.
struct BeyondCalculation {
  std::string reason;
  /// Ids of the claims that check consequences of the statement; these can be calculated.
  std::vector<std::string> consequences;
};

using Evidence =
    std::variant<CheckedProof, ExactIdentity, Agreement, ConvergenceRate, Counterexample, BeyondCalculation>;

/// Returns "proof", "exact-identity", "agreement", "convergence-rate", "counterexample" or "beyond-calculation".
std::string_view kind_of(const Evidence& evidence);

/// Returns one line for a reader, with the numbers. Formulas have no backticks.
std::string describe(const Evidence& evidence);

}  // namespace steadyslide::proofs_checks
