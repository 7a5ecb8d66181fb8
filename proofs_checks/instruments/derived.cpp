#include "proofs_checks/instruments/derived.hpp"

#include <algorithm>
#include <iterator>
#include <optional>
#include <stdexcept>

#include "proofs_checks/instruments/identities.hpp"
#include "symbolic/statements/riemann_hilbert_statements.hpp"

namespace steadyslide::proofs_checks {
namespace {

using Statements = std::vector<symbolic::DecidedStatement>;

/// What is examined: the statements of all families, or one wrong variant of one family's.
struct Selection {
  DecidedStatements source;
  std::vector<Family> families;
  std::optional<std::size_t> wrong;  ///< variant of the only family
};

Statements chosen(const Selection& selection, const Family& family) {
  Statements result;
  for (const symbolic::DecidedStatement& statement : selection.source()) {
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

std::vector<Evidence> examine_right(const Selection& selection) {
  std::vector<symbolic::ExactIdentity> identities;
  for (const Family& family : selection.families) {
    const Statements statements = chosen(selection, family);
    require_all_named(statements, family);
    std::ranges::move(right_identities(statements), std::back_inserter(identities));
  }
  return {weigh_identities(identities,
                           "decided for frictions s that are symbols, as equations between rational functions of s, r "
                           "= sqrt(1+s^2) and i; no number is put in")};
}

/// Refuted only if it is refuted of every statement that has it.
std::vector<Evidence> examine_wrong(const Selection& selection) {
  const Family& family = selection.families.front();
  const std::string& variant = family.variants[*selection.wrong];
  std::optional<Counterexample> example;
  for (const symbolic::DecidedStatement& statement : chosen(selection, family)) {
    const auto control = std::ranges::find(statement.controls, variant, &symbolic::ExactIdentity::statement);
    if (control == statement.controls.end()) continue;
    if (control->identical) return {ExactIdentity{"not refuted: " + variant, {statement.identity.statement}, {}}};
    if (!example)
      example = {"generic parameters", "the two sides are different functions, " + control->lhs + " and " +
                                           control->rhs + "; the right statement is \"" + statement.identity.statement +
                                           "\""};
  }
  if (!example) throw std::logic_error("no statement has the wrong variant " + variant);
  return {*example};
}

std::vector<Evidence> examine(const Context& /*context*/, const Selection& selection) {
  return selection.wrong ? examine_wrong(selection) : examine_right(selection);
}

}  // namespace

const Statements& decided_riemann_hilbert() {
  static const Statements all = symbolic::riemann_hilbert_statements();
  return all;
}

Claim derived(std::string_view id, DecidedStatements source, const std::vector<Family>& families) {
  std::vector<Wrong<Selection>> wrong;
  for (const Family& family : families) {
    for (std::size_t k = 0; k < family.variants.size(); ++k) {
      wrong.push_back({family.about + ": " + family.variants[k], {source, {family}, k}});
    }
  }
  return make_claim<Selection>(claim_text(id), examine, {source, families, std::nullopt}, std::move(wrong));
}

}  // namespace steadyslide::proofs_checks
