#include "proofs_checks/instruments/identities/derived.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <optional>
#include <stdexcept>

#include "symbolic/statements/statements.hpp"

namespace steadyslide::proofs_checks {
namespace {

using Statements = std::vector<symbolic::DecidedStatement>;

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

/// A counterexample among the identities, or all of them as one piece of evidence that covers the claim.
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

/// The statements' own identities, without their controls.
std::vector<symbolic::ExactIdentity> right_identities(const Statements& chosen) {
  std::vector<symbolic::ExactIdentity> identities;
  for (const symbolic::DecidedStatement& s : chosen) identities.push_back(s.identity);
  return identities;
}

/// All that stand where this one does. Deciding takes seconds: it is done when a claim is first examined, and once.
const Statements& decided_with(const std::string& id) {
  using Source = std::pair<std::string_view, Statements (*)()>;
  static constexpr std::array<Source, 4> sources{{{"rh-", symbolic::riemann_hilbert_statements},
                                                  {"energy-", symbolic::energy_statements},
                                                  {"theorem-", symbolic::local_form_statements},
                                                  {"", symbolic::elasticity_statements}}};
  static std::map<std::string_view, Statements> decided;
  const auto& [start, decide] =
      *std::ranges::find_if(sources, [&](const Source& s) { return id.starts_with(s.first); });
  Statements& all = decided[start];
  if (all.empty()) all = decide();
  return all;
}

/// Those with these ids; one that ends in a dash names all that begin like it. Throws std::logic_error if one is missing.
Statements statements(const std::vector<std::string>& ids) {
  Statements result;
  for (const symbolic::DecidedStatement& statement : decided_with(ids.front())) {
    const auto names = [&](const std::string& id) {
      return id.ends_with('-') ? statement.id.starts_with(id) : statement.id == id;
    };
    if (std::ranges::any_of(ids, names)) result.push_back(statement);
  }
  if (result.size() < ids.size()) throw std::logic_error("a symbolic statement is missing beside " + ids.front());
  return result;
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
    const Statements found = statements(family.ids);
    require_all_named(found, family);
    std::ranges::move(right_identities(found), std::back_inserter(identities));
  }
  return weigh_identities(identities,
                          "decided for frictions s that are symbols, as equations between rational functions of s, r = "
                          "sqrt(1+s^2) and i; no number is put in");
}

/// Refuted only if it is refuted of every statement that has it.
Evidence examine_wrong(const Family& family, const std::string& variant) {
  std::optional<Counterexample> example;
  for (const symbolic::DecidedStatement& statement : statements(family.ids)) {
    const auto control = std::ranges::find(statement.controls, variant, &symbolic::ExactIdentity::statement);
    if (control == statement.controls.end()) continue;
    if (control->identical) return ExactIdentity{"not refuted: " + variant, {statement.identity.statement}, {}};
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

Claim proved_by(const std::vector<std::string>& ids, std::string argument, Claim claim) {
  const Statements chosen = statements(ids);
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
