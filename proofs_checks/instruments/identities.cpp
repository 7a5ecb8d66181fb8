#include "proofs_checks/instruments/identities.hpp"

#include <stdexcept>

namespace steadyslide::proofs_checks {
namespace {

/// pi, a real number plus a multiple of i, s^2 + 1: nothing to be assumed of real data.
bool never_vanishes(std::string_view divisor) {
  return divisor == "1" || divisor == "pi" || divisor.starts_with("i + ") || divisor.find("*i + ") != divisor.npos ||
         divisor.find("*i - ") != divisor.npos || divisor.ends_with("^2 + 1");
}

constexpr std::size_t longest_condition = 120;

std::string text_of(const symbolic::ExactIdentity& identity) {
  std::string conditions;
  std::size_t count = 0;
  for (const std::string& divisor : identity.nonvanishing) {
    if (never_vanishes(divisor)) continue;
    conditions += (count++ == 0 ? "" : ", ") + divisor + " != 0";
  }
  if (count == 0) return identity.statement;
  if (conditions.size() > longest_condition) conditions = "none of " + std::to_string(count) + " divisors is 0";
  return identity.statement + ", where " + conditions;
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
