#include "proofs_checks/kit/evidence.hpp"

#include <array>
#include <boost/algorithm/string/join.hpp>
#include <cstdio>

#include "symbolic/field/plain_formula.hpp"

namespace steadyslide::proofs_checks {
namespace {

std::string with(std::string text, std::string_view before, const std::string& more) {
  return more.empty() ? text : text.append(before).append(more);
}

std::string text_of(double rate) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", rate);
  return text;
}

struct Describe {
  std::string operator()(const CheckedProof& e) const {
    if (!e.complete()) return "a proof with a gap: " + e.gap;
    return with("proof of " + text_of(e.text.concludes), ", for ", text_of(e.text.parameters)) + ": " +
           count_of_steps(e);
  }
  std::string operator()(const ExactIdentity& e) const {
    return with(e.detail, ": ", boost::algorithm::join(e.identities, "; "));
  }
  std::string operator()(const Agreement& e) const {
    std::string text = e.what;
    if (!e.routes.empty()) text += " (" + boost::algorithm::join(e.routes, " against ") + ")";
    text += ": largest relative difference " + e.worst + ", tolerance " + e.tolerance + ", " +
            std::to_string(e.effective) + " of " + std::to_string(e.cases) + " cases effective";
    if (e.effective < e.required) text += " (" + std::to_string(e.required) + " required)";
    return with(std::move(text), "; ", e.detail);
  }
  std::string operator()(const ConvergenceRate& e) const {
    return with(e.what + ": rate " + text_of(e.measured) + " +- " + text_of(e.error_bar) + ", expected " +
                    text_of(e.expected) + " +- " + text_of(e.tolerance),
                "; ", e.detail);
  }
  std::string operator()(const Counterexample& e) const { return with(e.detail, " at ", e.where); }
  std::string operator()(const BeyondCalculation& e) const {
    return with(e.reason, "; consequences checked: ", boost::algorithm::join(e.consequences, ", "));
  }
};

}  // namespace

std::string_view kind_of(const Evidence& evidence) {
  constexpr std::array<std::string_view, std::variant_size_v<Evidence>> kinds{
      "proof", "exact-identity", "agreement", "convergence-rate", "counterexample", "beyond-calculation"};
  return kinds[evidence.index()];
}

std::string describe(const Evidence& evidence) { return symbolic::without_marks(std::visit(Describe{}, evidence)); }

}  // namespace steadyslide::proofs_checks
