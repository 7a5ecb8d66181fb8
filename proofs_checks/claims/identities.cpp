#include "proofs_checks/claims/identities.hpp"

#include <stdexcept>

namespace steadyslide::proofs_checks {
namespace {

std::string text_of(const symbolic::ExactIdentity& identity) {
  std::string text = identity.statement;
  std::string_view before = " where ";
  for (const std::string& divisor : identity.nonvanishing) {
    if (divisor == "1") continue;
    text.append(before).append(divisor).append(" != 0");
    before = ", ";
  }
  return text;
}

}  // namespace

Rational tiny() { return parse_rational("1e-94"); }

std::vector<symbolic::DecidedStatement> statements(const std::vector<std::string>& ids) {
  std::vector<symbolic::DecidedStatement> chosen;
  for (const symbolic::DecidedStatement& s : symbolic::elasticity_statements()) {
    for (const std::string& id : ids) {
      if (s.id == id) chosen.push_back(s);
    }
  }
  if (chosen.size() != ids.size()) throw std::logic_error("a symbolic statement has no such id");
  return chosen;
}

Evidence weigh_identities(const std::vector<symbolic::ExactIdentity>& identities, std::string detail) {
  ExactIdentity evidence{std::move(detail), {}, ExactIdentity::Covers::claim};
  for (const symbolic::ExactIdentity& identity : identities) {
    if (!identity.identical) {
      return Counterexample{"generic parameters", "\"" + identity.statement +
                                                      "\": the two sides are different functions, " + identity.lhs +
                                                      " and " + identity.rhs};
    }
    evidence.identities.push_back(text_of(identity));
  }
  return evidence;
}

std::vector<symbolic::ExactIdentity> right_identities(const std::vector<symbolic::DecidedStatement>& chosen) {
  std::vector<symbolic::ExactIdentity> identities;
  for (const symbolic::DecidedStatement& s : chosen) identities.push_back(s.identity);
  return identities;
}

}  // namespace steadyslide::proofs_checks
