#pragma once
// An identity between functions of independent symbols, decided and not tested at points, and a statement with its wrong
// variants. Without GiNaC in this header.

#include <memory>
#include <string>
#include <vector>

namespace steadyslide::symbolic {

struct WrittenIdentity;  // written_identity.hpp

/// lhs = rhs in the exact field.
struct ExactIdentity {
  std::string statement;  ///< what the two sides are, in words and formulas
  std::string lhs;        ///< both sides in lowest terms: equal functions have equal texts
  std::string rhs;
  bool identical;
  std::vector<std::string> nonvanishing;  ///< divisors as they were written; the identity holds where none vanishes
  std::shared_ptr<const WrittenIdentity> written = nullptr;  ///< both sides as they were put in, for exporters
};

struct DecidedStatement {
  std::string id;
  ExactIdentity identity;
  std::vector<ExactIdentity> controls;  ///< wrong variants; none must come out identical
};

}  // namespace steadyslide::symbolic
