#include "proofs_checks/instruments/identities/derived.hpp"
#include "symbolic/statements/statements.hpp"

namespace steadyslide::proofs_checks {
namespace {

const std::vector<symbolic::DecidedStatement>& energies() {
  static const std::vector<symbolic::DecidedStatement> all = symbolic::energy_statements();
  return all;
}

}  // namespace

Claim energy_identity() { return derived("energy-identity", energies); }

}  // namespace steadyslide::proofs_checks
