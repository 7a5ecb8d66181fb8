#include "proofs_checks/proof/decided_statements.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <regex>
#include <stdexcept>

#include "symbolic/statements/statements.hpp"

namespace steadyslide::proofs_checks {
namespace {

using Statements = std::vector<symbolic::DecidedStatement>;

/// The functions that decide the statements, found by the beginning of an id. The last entry takes all other ids.
const std::vector<std::pair<std::string_view, Statements (*)()>> sources{
    {"rh-", symbolic::riemann_hilbert_statements}, {"equation-", symbolic::equation_statements},
    {"energy-", symbolic::energy_statements},      {"chebyshev-", symbolic::hilbert_statements},
    {"skew-", symbolic::hilbert_statements},       {"pairing-", symbolic::hilbert_statements},
    {"theorem-", symbolic::local_form_statements}, {"unique-", symbolic::uniqueness_statements},
    {"", symbolic::elasticity_statements}};

const Statements& decided_with(const std::string& id) {
  static std::map<std::string_view, Statements> decided;
  const auto& [start, decide] = *std::ranges::find_if(sources, [&](const auto& s) { return id.starts_with(s.first); });
  Statements& all = decided[start];
  if (all.empty()) all = decide();
  return all;
}

}  // namespace

std::vector<symbolic::DecidedStatement> decided_statements(const std::vector<std::string>& ids) {
  Statements result;
  for (const std::string& id : ids) {
    const auto named = [&](const symbolic::DecidedStatement& s) {
      return id.ends_with('-') ? s.id.starts_with(id) : s.id == id;
    };
    const std::size_t before = result.size();
    std::ranges::copy_if(decided_with(id), std::back_inserter(result), named);
    if (result.size() == before) throw std::logic_error("no symbolic statement " + id);
  }
  return result;
}

bool never_vanishes(std::string_view divisor) {
  static const std::regex form(
      "[1-9][0-9]*|pi|([0-9]+\\*)?i \\+ [a-z0-9_]+|[0-9]+\\*i - [0-9]+|i - [a-z0-9_]+|[a-z0-9_]+\\^2 \\+ 1");
  return std::regex_match(divisor.begin(), divisor.end(), form);
}

}  // namespace steadyslide::proofs_checks
