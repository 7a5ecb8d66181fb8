#include <array>
#include <fstream>
#include <stdexcept>

#include "enclosure/cells/cell_bound.hpp"
#include "enclosure/contact/contact_proof.hpp"
#include "library/proof/certificate.hpp"
#include "library/steadyslide/solution_state.hpp"
#include "library/text/number_format.hpp"

namespace steadyslide {
namespace {

Proof proof_on_cells(const ContactProblem& problem, const std::vector<double>& pressures) {
  const enclosure::CellBound bound = enclosure::bound_cells(problem, pressures);
  return {bound.proved, bound.reason, bound.proved ? library::certificate(problem, bound) : ""};
}

Proof proof_from(const Solution::State& state) {
  const ContactProblem& problem = contact_problem(state.problem);
  const auto proof = enclosure::prove_contact(problem, state.approximate_contact(), state.digits);
  if (proof.proved) return {true, "", library::certificate(problem, proof, state.digits)};
  return {false, proof.reason + (proof.where ? "; x = " + library::format_number(*proof.where, 6) : ""), ""};
}

}  // namespace

Proof Solution::certify() const {
  if (const auto pressures = state_->touching_pressures()) {
    return proof_on_cells(contact_problem(state_->problem), *pressures);
  }
  Proof proof = proof_from(*state_);
  // What double finds may be too far away.
  for (const int digits : std::array{50, 100}) {
    if (proof.proved || digits <= state_->digits) continue;
    proof = proof_from(*solved_state(state_->problem, library::method_named(state_->method), digits, {}));
  }
  return proof;
}

void Proof::save(const std::string& file) const {
  if (certificate.empty()) throw std::runtime_error(file + ": no certificate; " + reason);
  std::ofstream out(file);
  out << certificate << std::flush;
  if (!out) throw std::runtime_error(file + ": cannot be written");
}

}  // namespace steadyslide
