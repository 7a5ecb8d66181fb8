#pragma once
// Statements that are decided exactly, each beside wrong variants of itself.

#include "support/test.hpp"
#include "symbolic/field/exact_identity.hpp"

namespace steadyslide::testing {

/// Every one holds under an id of its own, and each of its variants is another one and refuted. Returns the ids.
inline std::set<std::string> check_decided(const std::vector<symbolic::DecidedStatement>& statements,
                                           std::size_t controls = 4) {
  std::set<std::string> ids;
  for (const symbolic::DecidedStatement& statement : statements) {
    CAPTURE(statement.id);
    CHECK(ids.insert(statement.id).second);
    CHECK(statement.identity.identical);
    CHECK(statement.identity.lhs == statement.identity.rhs);
    CHECK(statement.controls.size() >= controls);
    std::set<std::string> variants;
    for (const symbolic::ExactIdentity& control : statement.controls) {
      CAPTURE(control.statement);
      CHECK(variants.insert(control.statement).second);
      CHECK_FALSE(control.identical);
      CHECK(control.lhs != control.rhs);
    }
  }
  return ids;
}

}  // namespace steadyslide::testing
