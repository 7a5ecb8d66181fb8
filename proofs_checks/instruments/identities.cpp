#include "proofs_checks/instruments/identities.hpp"

#include <algorithm>
#include <iterator>
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

/// Those with these ids. Throws std::logic_error if one is missing.
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

}  // namespace

Rational tiny() { return parse_rational("1e-94"); }

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

Claim proved_by(const std::vector<std::string>& ids, std::string argument, Claim claim) {
  const std::vector<symbolic::DecidedStatement> chosen = statements(ids);
  claim.examine = [identities = right_identities(chosen), argument,
                   compare = std::move(claim.examine)](const Context& context) {
    std::vector<Evidence> all{weigh_identities(identities, argument)};
    std::ranges::move(compare(context), std::back_inserter(all));
    return all;
  };
  for (const symbolic::DecidedStatement& s : chosen) {
    for (const symbolic::ExactIdentity& w : s.controls) {
      claim.controls.push_back({s.identity.statement + ", wrongly: " + w.statement, [w, argument](const Context&) {
                                  return std::vector<Evidence>{weigh_identities({w}, argument)};
                                }});
    }
  }
  return claim;
}

}  // namespace steadyslide::proofs_checks
