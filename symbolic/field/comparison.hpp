#pragma once
// Several equations that are decided together in one field of phases. The result is an ExactIdentity whose sides are
// tuples. If an equation does not hold, the result contains only this one, and later equations are ignored.

#include <string>
#include <vector>

#include "symbolic/field/exact_identity.hpp"
#include "symbolic/field/phase_field.hpp"
#include "symbolic/field/written_identity.hpp"

namespace steadyslide::symbolic {

class Comparison {
 public:
  explicit Comparison(const PhaseField& field) : field_(field) {}

  /// Throws std::domain_error as PhaseField does.
  Comparison& equal(const std::string& what, const GiNaC::ex& lhs, const GiNaC::ex& rhs);
  bool holds() const { return holds_; }
  ExactIdentity as(std::string statement) const;

 private:
  const PhaseField& field_;
  bool holds_ = true;
  std::vector<WrittenEquation> equations_;  ///< all equations, or the one that does not hold
  std::set<std::string> nonvanishing_;
};

}  // namespace steadyslide::symbolic
