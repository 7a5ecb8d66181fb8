#include "symbolic/statements/local_form_check.hpp"

#include <set>
#include <stdexcept>
#include <vector>

#include "symbolic/field/written_identity.hpp"

namespace steadyslide::symbolic {
namespace {

using GiNaC::ex;

enum class Constants { canonical, written };

std::vector<LocalEquation> equations_of(const LocalCandidate& candidate, Constants kind = Constants::canonical) {
  const LocalFrame& frame = candidate.frame;
  LocalConstants constants{0, 0, frame.pi()};
  if (candidate.exponent) {
    constants = kind == Constants::written ? frame.written_constants(*candidate.exponent)
                                           : frame.constants(*candidate.exponent);
  }
  std::vector<LocalEquation> equations = local_equations(candidate.place, constants, candidate.density);
  if (!candidate.outside) return equations;
  if (candidate.place.contact == ContactSide::both) throw std::domain_error("local form: nothing is outside");
  const Side beyond = candidate.place.in_contact(Side::right) ? Side::left : Side::right;
  const LocalDensity image = act(candidate.density, constants);
  const auto found = image.find({beyond, true, 0, 0});
  equations.push_back({{"d^lambda in u_bar' beyond the end", "d^{\\lambda}\\text{ in }\\bar u'"},
                       found == image.end() ? ex(0) : found->second,
                       *candidate.outside});
  return equations;
}

/// Returns the text of a polynomial up to its sign, because GiNaC's choice of the sign changes from run to run.
std::string up_to_sign(const std::string& text) {
  if (text[0] != '-') return text;
  std::string result = text.substr(1);
  for (std::size_t k = 0; k + 2 < result.size(); ++k) {
    if (result[k] != ' ' || result[k + 2] != ' ') continue;
    if (result[k + 1] == '+') {
      result[k + 1] = '-';
    } else if (result[k + 1] == '-') {
      result[k + 1] = '+';
    }
  }
  return result;
}

}  // namespace

ExactIdentity verify_local_form(const std::string& statement, const LocalCandidate& candidate) {
  const PhaseField& field = candidate.frame.field();
  ExactIdentity identity{statement, "", "", true, {}};
  WrittenIdentity written{field.radicals(), {}};
  for (const LocalEquation& equation : equations_of(candidate, Constants::written)) {
    written.equations.push_back({equation.where.text, equation.lhs, equation.rhs});
  }
  std::set<std::string> nonvanishing;
  for (const LocalEquation& equation : equations_of(candidate)) {
    const PhaseField::Decision decision = field.are_equal(equation.lhs, equation.rhs);
    identity.identical = identity.identical && decision.holds;
    for (const std::string& divisor : decision.nonvanishing) nonvanishing.insert(up_to_sign(divisor));
    const std::string separator = identity.lhs.empty() ? "" : "; ";
    identity.lhs += separator + field.text(equation.lhs);
    identity.rhs += separator + field.text(equation.rhs);
  }
  identity.nonvanishing.assign(nonvanishing.begin(), nonvanishing.end());
  identity.written = std::make_shared<WrittenIdentity>(std::move(written));
  return identity;
}

std::string first_mismatch(const LocalCandidate& candidate) {
  const LocalFrame& frame = candidate.frame;
  for (const LocalEquation& equation : equations_of(candidate)) {
    if (frame.field().are_equal(equation.lhs, equation.rhs).holds) continue;
    return equation.where.text + ": " + frame.text(equation.lhs).text + " in place of " + frame.text(equation.rhs).text;
  }
  return "";
}

}  // namespace steadyslide::symbolic
