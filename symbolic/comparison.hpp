#pragma once
// Several equations that are decided together, in one field of phases: an ExactIdentity whose two sides are tuples.

#include "symbolic/exact_identities.hpp"
#include "symbolic/phase_field.hpp"

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
  std::string lhs_;
  std::string rhs_;
  std::set<std::string> nonvanishing_;
};

}  // namespace steadyslide::symbolic
