#include "symbolic/field/comparison.hpp"

namespace steadyslide::symbolic {

Comparison& Comparison::equal(const std::string& what, const GiNaC::ex& lhs, const GiNaC::ex& rhs) {
  if (!holds_) return *this;
  PhaseField::Decision decision = field_.are_equal(lhs, rhs);
  holds_ = decision.holds;
  nonvanishing_.merge(decision.nonvanishing);
  if (!holds_) equations_.clear();
  equations_.push_back({what, lhs, rhs});
  return *this;
}

ExactIdentity Comparison::as(std::string statement) const {
  ExactIdentity identity{std::move(statement),
                         {},
                         {},
                         holds_ && !equations_.empty(),
                         {nonvanishing_.begin(), nonvanishing_.end()},
                         std::make_shared<WrittenIdentity>(WrittenIdentity{field_.radicals(), equations_})};
  for (const WrittenEquation& e : equations_) {
    const std::string before = (identity.lhs.empty() ? "" : "; ") + e.what + " = ";
    identity.lhs += before + field_.text(e.lhs);
    identity.rhs += before + field_.text(e.rhs);
  }
  return identity;
}

}  // namespace steadyslide::symbolic
