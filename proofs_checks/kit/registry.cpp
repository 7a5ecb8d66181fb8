#include "proofs_checks/kit/registry.hpp"

#include <algorithm>
#include <iterator>
#include <set>
#include <stdexcept>

#include "proofs_checks/kit/proofs.hpp"
#include "proofs_checks/statements/paper_statements.hpp"

namespace steadyslide::proofs_checks {
namespace {

/// Returns the claim's position in the paper's statements, or a position after all of them if no statement names it.
std::size_t position_of(const std::string& id) {
  std::size_t position = 0;
  for (const PaperStatement& statement : paper_statements()) {
    for (const auto* named : {&statement.claims, &statement.instances}) {
      for (const std::string_view one : *named) {
        if (one == id) return position;
        ++position;
      }
    }
  }
  return position;
}

}  // namespace

Claim made(const ClaimEntry& entry) {
  Claim claim = with_proof(entry.make());
  claim.group = entry.group;
  return claim;
}

const std::vector<Claim>& registry() {
  static const std::vector<Claim> all = [] {
    std::vector<Claim> claims;
    for (const ClaimEntry& entry : claim_list()) claims.push_back(made(entry));
    std::ranges::stable_sort(claims, {}, [](const Claim& claim) { return position_of(claim.id); });
    return claims;
  }();
  return all;
}

std::vector<std::string> groups() {
  std::set<std::string> names;
  for (const ClaimEntry& entry : claim_list()) names.emplace(entry.group);
  return {names.begin(), names.end()};
}

std::vector<Claim> claims_of_group(std::string_view group) {
  std::vector<Claim> claims;
  std::ranges::copy_if(registry(), std::back_inserter(claims), [&](const Claim& c) { return c.group == group; });
  if (claims.empty()) throw std::invalid_argument("no claims stand under " + std::string(group));
  return claims;
}

}  // namespace steadyslide::proofs_checks
