#include "symbolic/comparison.hpp"

namespace steadyslide::symbolic {

Comparison& Comparison::equal(const std::string& what, const GiNaC::ex& lhs, const GiNaC::ex& rhs) {
  PhaseField::Decision decision = field_.are_equal(lhs, rhs);
  holds_ = holds_ && decision.holds;
  nonvanishing_.merge(decision.nonvanishing);
  const std::string separator = lhs_.empty() ? "" : "; ";
  lhs_ += separator + what + " = " + field_.text(lhs);
  rhs_ += separator + what + " = " + field_.text(rhs);
  return *this;
}

ExactIdentity Comparison::as(std::string statement) const {
  return {std::move(statement), lhs_, rhs_, holds_ && !lhs_.empty(), {nonvanishing_.begin(), nonvanishing_.end()}};
}

}  // namespace steadyslide::symbolic
