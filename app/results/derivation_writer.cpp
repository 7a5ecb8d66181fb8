#include "app/results/derivation_writer.hpp"

#include <iterator>
#include <stdexcept>

#include "app/terminal/output.hpp"
#include "symbolic/local/local_derivations.hpp"
#include "symbolic/riemann_hilbert/closed_form_derivation.hpp"

namespace steadyslide::app {
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

ExitCode write_derivations(const CommonOptions& options, const ContactProblem& problem) {
  Output output(options.output);
  std::vector<symbolic::Derivation> derivations = symbolic::local_derivations(problem);
  std::vector<symbolic::Derivation> whole = closed_forms(problem);
  std::move(whole.begin(), whole.end(), std::back_inserter(derivations));
  if (options.format == Format::latex) {
    output.write(symbolic::latex_document(derivations));
  } else {
    for (const symbolic::Derivation& derivation : derivations) {
      output.write(symbolic::to_text(derivation));
      output.write("\n");
    }
  }
  output.commit();
  return ExitCode::done;
}

}  // namespace steadyslide::app
