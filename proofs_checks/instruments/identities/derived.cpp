#include "proofs_checks/instruments/identities/derived.hpp"

#include <algorithm>
#include <iterator>
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

/// Those with these ids. Throws std::logic_error if one is missing.
Statements statements(const std::vector<std::string>& ids) {
  Statements chosen;
  for (const symbolic::DecidedStatement& s : symbolic::elasticity_statements()) {
    for (const std::string& id : ids) {
      if (s.id == id) chosen.push_back(s);
    }
  }
  if (chosen.size() != ids.size()) throw std::logic_error("a symbolic statement has no such id");
  return chosen;
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
  if (id.starts_with("rh-")) {
    static const Statements riemann_hilbert = symbolic::riemann_hilbert_statements();
    return riemann_hilbert;
  }
  if (id.starts_with("energy-")) {
    static const Statements energies = symbolic::energy_statements();
    return energies;
  }
  static const Statements local_forms = symbolic::local_form_statements();
  return local_forms;
}

Statements chosen(const Family& family) {
  Statements result;
  for (const symbolic::DecidedStatement& statement : decided_with(family.ids.front())) {
    const auto names = [&](const std::string& id) {
      return id.ends_with('-') ? statement.id.starts_with(id) : statement.id == id;
    };
    if (std::ranges::any_of(family.ids, names)) result.push_back(statement);
  }
  if (result.empty()) throw std::logic_error("no statement is named " + family.ids.front());
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
    const Statements statements = chosen(family);
    require_all_named(statements, family);
    std::ranges::move(right_identities(statements), std::back_inserter(identities));
  }
  return weigh_identities(identities,
                          "decided for frictions s that are symbols, as equations between rational functions of s, r = "
                          "sqrt(1+s^2) and i; no number is put in");
}

/// Refuted only if it is refuted of every statement that has it.
Evidence examine_wrong(const Family& family, const std::string& variant) {
  std::optional<Counterexample> example;
  for (const symbolic::DecidedStatement& statement : chosen(family)) {
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
