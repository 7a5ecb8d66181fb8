#pragma once
// An identity between functions of independent symbols, which is decided exactly and not tested at points, and a
// statement with its wrong variants. This header does not include GiNaC.

#include <memory>
#include <string>
#include <vector>

namespace steadyslide::symbolic {

struct WrittenIdentity;  // written_identity.hpp

/// An equation lhs = rhs in the exact field.
struct ExactIdentity {
  std::string statement;  ///< the meaning of both sides, in words and formulas
  std::string lhs;        ///< both sides in lowest terms: equal functions have equal texts
  std::string rhs;
  bool identical;
  std::vector<std::string> nonvanishing;  ///< divisors as written; the identity holds where none vanishes
  std::shared_ptr<const WrittenIdentity> written = nullptr;  ///< both sides as given, for exporters
};

struct DecidedStatement {
  std::string id;
  ExactIdentity identity;
  std::vector<ExactIdentity> controls;  ///< wrong variants; none may be an identity
  std::string decides = {};             ///< the facts of proofs that it decides, "phase(jump)"
};

}  // namespace steadyslide::symbolic
