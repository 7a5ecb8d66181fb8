#include "proofs_checks/instruments/identities/derived.hpp"

#include <algorithm>
#include <iterator>
#include <optional>
#include <stdexcept>

#include "proofs_checks/proof/decided_statements.hpp"

namespace steadyslide::proofs_checks {
namespace {

using Statements = std::vector<symbolic::DecidedStatement>;

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

/// Returns a counterexample among the identities. If there is none, returns all of them as one piece of evidence.
Evidence weigh_identities(const std::vector<symbolic::ExactIdentity>& identities, std::string detail) {
  ExactIdentity evidence{std::move(detail), {}};
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

/// Returns the identities of the statements, without their wrong variants.
std::vector<symbolic::ExactIdentity> right_identities(const Statements& chosen) {
  std::vector<symbolic::ExactIdentity> identities;
  for (const symbolic::DecidedStatement& s : chosen) identities.push_back(s.identity);
  return identities;
}

void require_all_named(const Statements& statements, const Family& family) {
  for (const symbolic::DecidedStatement& statement : statements) {
    for (const symbolic::ExactIdentity& control : statement.controls) {
      if (std::ranges::find(family.variants, control.statement) != family.variants.end()) continue;
      throw std::logic_error(statement.id + " has a wrong variant that is no control: " + control.statement);
    }
  }
}

Evidence examine_right(const std::vector<Family>& families) {
  std::vector<symbolic::ExactIdentity> identities;
  for (const Family& family : families) {
    const Statements found = decided_statements(family.ids);
    require_all_named(found, family);
    std::ranges::move(right_identities(found), std::back_inserter(identities));
  }
  return weigh_identities(
      identities,
      "decided for frictions `s` that are symbols, as equations between rational functions of `s`, `r = "
      "sqrt(1+s^2)` and `i`; no number is put in");
}

/// Returns a counterexample only if the variant is refuted for every statement that has it.
Evidence examine_wrong(const Family& family, const std::string& variant) {
  std::optional<Counterexample> example;
  for (const symbolic::DecidedStatement& statement : decided_statements(family.ids)) {
    const auto control = std::ranges::find(statement.controls, variant, &symbolic::ExactIdentity::statement);
    if (control == statement.controls.end()) continue;
    if (control->identical) return ExactIdentity{"not refuted: " + variant, {statement.identity.statement}};
    if (example) continue;
    example = {"generic parameters", "the two sides are different functions, " + control->lhs + " and " + control->rhs +
                                         "; the right statement is \"" + statement.identity.statement + "\""};
  }
  if (!example) throw std::logic_error("no statement has the wrong variant " + variant);
  return *example;
}

}  // namespace

Claim derived(std::string_view id) {
  Claim claim{claim_text(id), {}, {}};
  for (const Family& family : claim.decided) {
    for (const std::string& variant : family.variants) {
      claim.controls.push_back({family.about + ": " + variant, [family, variant](const Context&) {
                                  return std::vector<Evidence>{examine_wrong(family, variant)};
                                }});
    }
  }
  claim.examine = [families = claim.decided](const Context&) { return std::vector<Evidence>{examine_right(families)}; };
  return claim;
}

}  // namespace steadyslide::proofs_checks
