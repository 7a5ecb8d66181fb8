#include "library/solve/derivations.hpp"

#include <stdexcept>

#include "symbolic/local/local_derivations.hpp"
#include "symbolic/riemann_hilbert/derived_contact.hpp"

namespace steadyslide::library {
namespace {

/// Every further jump with another height may double the degree of the field in which the closed form is decided.
constexpr std::size_t most_jumps_of_closed_form = 8;

std::vector<symbolic::Derivation> closed_forms(const ContactProblem& problem) {
  if (problem.friction().jumps().size() > most_jumps_of_closed_form) return {};
  std::vector<symbolic::Derivation> all;
  try {
    for (const auto& contact : symbolic::DerivedContact::all(problem, 30)) all.push_back(contact.derivation());
  } catch (const std::domain_error&) {
    return {};  // the profile has no closed form; the exponents are derived nevertheless
  }
  return all;
}

}  // namespace

std::vector<symbolic::Derivation> derivations(const ContactProblem& problem) {
  std::vector<symbolic::Derivation> all = symbolic::local_derivations(problem);
  for (symbolic::Derivation& whole : closed_forms(problem)) all.push_back(std::move(whole));
  return all;
}

}  // namespace steadyslide::library
