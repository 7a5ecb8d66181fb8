#include "known_limits/cell_estimates.hpp"

#include "numeric/riemann_hilbert/riemann_hilbert.hpp"
#include "numeric/variational/variational_inequality.hpp"
#include "support/random_contact.hpp"

namespace steadyslide::testing {

using namespace numeric;

void audit_cell_estimates(std::uint64_t seed, std::size_t cells, EstimateAudit& audit) {
  const ContactProblem problem = random_contact(seed);
  ++audit.problems;
  const auto exact = riemann_hilbert<double>(problem).solution;
  if (!exact || !exact->failed_condition().empty()) return;
  const auto found = variational_inequality(problem, {.cells = cells}).solution;
  if (!found || !found->failed_condition().empty()) return;
  ++audit.compared;

  const auto look = [&](const std::string& kind, std::size_t k, Estimate<double> value, const Estimate<double>& truth) {
    value.error += truth.error;
    compare_estimate(kind, value, {Real50(truth.value), Real50(0)}, audit,
                     std::to_string(seed) + ": " + kind + ' ' + std::to_string(k));
  };
  const Resultants<double> a = found->resultants();
  const Resultants<double> b = exact->resultants();
  look("friction force", 0, a.tangential, b.tangential);
  look("effective friction", 0, a.effective_friction, b.effective_friction);
  look("centre of pressure", 0, a.centre_of_pressure, b.centre_of_pressure);
  for (std::size_t k = 0; k < a.load_share.size(); ++k) look("load share", k, a.load_share[k], b.load_share[k]);
  if (a.component_load.size() > 1 && a.component_load.size() == b.component_load.size()) {
    for (std::size_t k = 0; k < a.component_load.size(); ++k) {
      look("load of a zone", k, a.component_load[k], b.component_load[k]);
    }
  }
  if (const auto tilt = found->tilt()) look("tilt", 0, *tilt, *exact->tilt());
}

std::string cell_failure(const EstimateAudit& audit) {
  if (!audit.dishonest.empty()) return std::to_string(audit.dishonest.size()) + " estimates are not honest";
  if (10 * audit.compared < 9 * audit.problems) return "too little was compared";
  for (const char* kind : {"effective friction", "load share"}) {
    const auto found = audit.numbers.find(kind);
    if (found == audit.numbers.end()) return "too little was compared";
    if (!(found->second.median_too_large() <= 30)) return "estimates are too large";
  }
  return "";
}

}  // namespace steadyslide::testing
