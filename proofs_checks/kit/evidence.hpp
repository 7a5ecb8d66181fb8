#pragma once
// What an examination of a claim brings back. Evidence is typed, so that a verdict is earned and not asserted.

#include <cstddef>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "proofs_checks/proof/proof.hpp"

namespace steadyslide::proofs_checks {

/// Equalities decided exactly: as rational functions of independent symbols, or by exact arithmetic on exponents. They
/// support: what they mean for the claim is for a proof to say.
struct ExactIdentity {
  std::string detail;
  std::vector<std::string> identities;
};

/// Unrelated routes to one number agreed to the tolerance, case by case.
struct Agreement {
  std::string what;
  std::vector<std::string> routes;
  std::string worst;      ///< the largest relative difference
  std::string tolerance;  ///< what it had to stay below
  std::size_t cases = 0;  ///< parameters examined
  std::size_t effective =
      0;  ///< those at which the statement says something (a jump that is one, a rule that converged)
  std::size_t required = 1;  ///< with fewer effective cases nothing is shown
  std::string detail;        ///< where the cases come from, seed included
};

/// An error that falls as a power of the number of cells: it should be within `tolerance` of the power expected.
struct ConvergenceRate {
  std::string what;
  double measured = 0;
  double error_bar = 0;  ///< one standard deviation
  double expected = 0;
  double tolerance = 0;
  std::string detail;
};

/// The statement fails here.
struct Counterexample {
  std::string where;  ///< the parameters
  std::string detail;
};

/// No calculation decides the statement: an abstract existence proof, or one that the text at hand does not contain.
struct BeyondCalculation {
  std::string reason;
  std::vector<std::string> consequences;  ///< ids of the claims that check what follows from it and can be calculated
};

using Evidence =
    std::variant<CheckedProof, ExactIdentity, Agreement, ConvergenceRate, Counterexample, BeyondCalculation>;

/// "proof", "exact-identity", "agreement", "convergence-rate", "counterexample", "beyond-calculation".
std::string_view kind_of(const Evidence& evidence);

/// One line for a reader, with the numbers; formulas have no backticks.
std::string describe(const Evidence& evidence);

}  // namespace steadyslide::proofs_checks
