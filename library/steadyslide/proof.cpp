#include <fstream>
#include <stdexcept>

#include "enclosure/cells/cell_bound.hpp"
#include "library/proof/certificate.hpp"
#include "library/proof/proved_contact.hpp"
#include "library/steadyslide/solution_state.hpp"
#include "library/text/number_format.hpp"

namespace steadyslide {
namespace {

Proof proof_on_cells(const ContactProblem& problem, const std::vector<double>& pressures) {
  if (pressures.empty()) {
    return {
        false, "the cells lie on the contact; a proof needs equal cells on the whole support: cells = 4096", "", {}};
  }
  const enclosure::CellBound bound = enclosure::bound_cells(problem, pressures);
  return {bound.proved, bound.reason, bound.proved ? library::certificate(problem, bound) : "", {}};
}

}  // namespace

Proof Solution::certify() const {
  if (contact_problem(state_->problem).body().period()) {
    const auto [text, reason] = library::periodic_certificate(contact_problem(state_->problem), state_->digits);
    return {false, text.empty() ? reason : "steadyslide-check proves this certificate", text, {}};
  }
  if (!contact_problem(state_->problem).body().is_half_plane())
    return {false, "proofs are for the half-plane, and for periodic contact", "", state_->unresolved_gaps()};
  if (const auto pressures = state_->touching_pressures()) {
    return proof_on_cells(contact_problem(state_->problem), *pressures);
  }
  const ContactProblem& problem = contact_problem(state_->problem);
  const int first = state_->digits <= 16 ? 16 : state_->digits <= 50 ? 50 : 100;
  std::shared_ptr<const State> state = state_;
  const auto found = [&](int digits) -> std::optional<library::FoundContact> {
    if (digits > first) {
      state = solved_state(state_->problem, {library::method_named(state_->method), digits, {}, std::nullopt});
    }
    return library::FoundContact{state->approximate_contact(), state->failed_condition.empty()};
  };
  const auto proof = library::proved_contact(problem, state_->digits, first, found);
  if (proof->proved) return {true, "", library::certificate(problem, *proof, state_->digits), state->unresolved_gaps()};
  const std::string where = proof->where ? "; x = " + library::format_number(*proof->where, 6) : "";
  return {false, proof->reason + where, "", state->unresolved_gaps()};
}

void Proof::save(const std::string& file) const {
  if (certificate.empty()) throw std::runtime_error(file + ": no certificate; " + reason);
  std::ofstream out(file);
  out << certificate << std::flush;
  if (!out) throw std::runtime_error(file + ": cannot be written");
}

}  // namespace steadyslide
