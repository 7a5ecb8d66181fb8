#include "library/solve/derivations.hpp"

#include <stdexcept>

#include "symbolic/local/local_derivations.hpp"
#include "symbolic/riemann_hilbert/closed_form_derivation.hpp"

namespace steadyslide::library {
namespace {

/// Every further jump of its own height may double the field in which the closed form is decided.
constexpr std::size_t most_jumps_of_closed_form = 8;

std::vector<symbolic::Derivation> closed_forms(const ContactProblem& problem) {
  if (problem.friction().jumps().size() > most_jumps_of_closed_form) return {};
  try {
    return symbolic::riemann_hilbert_derivations(problem);
  } catch (const std::domain_error&) {
    return {};  // the profile has no closed form; its exponents are derived all the same
  }
}

}  // namespace

std::vector<symbolic::Derivation> derivations(const ContactProblem& problem) {
  std::vector<symbolic::Derivation> all = symbolic::local_derivations(problem);
  for (symbolic::Derivation& whole : closed_forms(problem)) all.push_back(std::move(whole));
  return all;
}

}  // namespace steadyslide::library
