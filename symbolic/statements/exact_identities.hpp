#pragma once
// The exact statements about the constants of elasticity that the claims rest on, each decided in Q(symbols), and each
// with wrong variants that the same decision refutes. Without GiNaC in this header. Not thread-safe, as GiNaC is not.

#include <string>
#include <vector>

namespace steadyslide::symbolic {

/// lhs = rhs as rational functions of independent symbols, decided (not tested at points).
struct ExactIdentity {
  std::string statement;  ///< what the two sides are, in words and formulas
  std::string lhs;        ///< both sides in lowest terms: equal functions have equal texts
  std::string rhs;
  bool identical;
  std::vector<std::string> nonvanishing;  ///< divisors as they were written; the identity holds where none vanishes
};

struct DecidedStatement {
  std::string id;
  ExactIdentity identity;
  std::vector<ExactIdentity> controls;  ///< wrong variants; none must come out identical
};

/// gamma and the compliance by Kolosov's constant, the limit of a rigid indenter, exchange of the bodies, identical
/// bodies, the range ]0, 3/4[ of gamma and that it decreases in nu, cot(pi beta) at a friction jump.
std::vector<DecidedStatement> elasticity_statements();

}  // namespace steadyslide::symbolic
