#pragma once
// Several equations that are decided together, in one field of phases: an ExactIdentity whose two sides are tuples, or
// the first equation that does not hold: what follows it is not looked at, and texts are made of nothing else.

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
  std::vector<WrittenEquation> equations_;  ///< all, or the one that does not hold
  std::set<std::string> nonvanishing_;
};

}  // namespace steadyslide::symbolic
