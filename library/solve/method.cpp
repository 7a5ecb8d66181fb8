#include "library/solve/method.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include "library/solve/double_range.hpp"
#include "library/text/one_line.hpp"
#include "model/invalid_data.hpp"
#include "numeric/bodies/body_contact.hpp"
#include "numeric/closed_form/closed_form.hpp"
#include "numeric/riemann_hilbert/riemann_hilbert.hpp"
#include "numeric/variational/variational_inequality.hpp"

namespace steadyslide::library {
namespace {

/// squares_in_double() for an exact number.
bool is_comfortable(const Rational& value) {
  // A number beyond the range of double is 0 or infinite there.
  return value == 0 || (value.convert_to<double>() != 0 && squares_in_double(value.convert_to<double>()));
}

/// The number of concave corners under pressure, as far as cells show it, with a gap that double can represent. Under
/// the pressure p the gap is as long as exp(-pi (1 + s^2) p/D), D the corner's jump of slope. A kink at rounding level
/// has no such gap.
std::ptrdiff_t gaps_in_contact(const ContactProblem& problem, const std::vector<Indenter::Break>& concave) {
  constexpr double least_logarithm = -690;
  const auto rough = numeric::variational_inequality(problem, {.cells = 1024}).solution;
  if (!rough) return 0;
  const auto c = numeric::to_real<double>(problem.elasticity().compliance());
  return std::ranges::count_if(concave, [&](const Indenter::Break& corner) {
    const double pressure = -rough->at(corner.x).traction.left.value;
    const auto s = numeric::to_real<double>(problem.coupled_friction(problem.friction().piece(corner.x, Side::left)));
    const double jump = numeric::to_real<double>(corner.wedge) / c;  // < 0
    return pressure > 0 && std::numbers::pi * (1 + s * s) * pressure < least_logarithm * jump;
  });
}

/// Returns why the Riemann-Hilbert method is predicted to be slower than cells; empty if it is not.
std::string slow_gaps(const ContactProblem& problem) {
  constexpr std::ptrdiff_t most_gaps = 10;
  constexpr std::size_t many_pieces = 1000, most_zones = 10;
  if (problem.indenter().pieces().size() > many_pieces && problem.indenter().is_smooth()) {
    const auto rough = numeric::variational_inequality(problem, {.cells = 4096}).solution;
    const std::size_t zones = rough ? rough->contact().size() : 0;
    if (zones <= most_zones) return "";
    return fmt::format("{} contact zones on 4096 cells, more than {}, of a profile of more than {} pieces", zones,
                       most_zones, many_pieces);
  }
  std::vector<Indenter::Break> concave = problem.indenter().breaks();
  std::erase_if(concave, [](const Indenter::Break& b) { return b.wedge >= 0; });
  if (std::ssize(concave) > most_gaps) {
    const std::ptrdiff_t gaps = gaps_in_contact(problem, concave);
    if (gaps > most_gaps)
      return fmt::format("{} gaps over concave corners in the contact, more than {}", gaps, most_gaps);
  }
  return "";
}

}  // namespace

Method method_named(std::string_view name) {
  constexpr std::array<std::string_view, 4> names{"auto", "closed-form", "riemann-hilbert", "variational"};
  const auto found = std::ranges::find(names, name);
  if (found != names.end()) return static_cast<Method>(found - names.begin());
  throw InvalidData("", "unknown method", "it is one of auto, closed-form, riemann-hilbert, variational",
                    excerpt(name));
}

Choice choice_of(Method method, const ContactProblem& problem, bool certify, int digits) {
  if (method != Method::automatic) return {method == Method::variational, "as --method says"};
  // A proof costs as much as 50 digits.
  const numeric::Digits costs = certify ? numeric::Digits::fifty : numeric::Digits::sixteen;
  if (std::string reason = numeric::too_many_friction_pieces(problem, costs); !reason.empty()) return {true, reason};
  std::string reason = numeric::too_many_profile_breaks(problem, costs);
  if (reason.empty() && numeric::may_have_many_gaps(problem))
    reason = "a gap may open over each of many concave corners";
  if (reason.empty() && !certify && digits <= 16) reason = slow_gaps(problem);
  const bool has_formula = !reason.empty() && numeric::closed_form<double>(problem).solution;
  if (!reason.empty() && !has_formula) return {true, std::move(reason)};  // all pieces may be the same polynomial
  return {false, "a formula if one applies; no rule asks for cells"};
}

std::string fallen_back(const std::string& why) {
  return "method variational: the Riemann-Hilbert method did not converge; " + why;
}

bool may_take_more_digits(const ContactProblem& problem) {
  constexpr std::size_t many_pieces = 64;
  return problem.indenter().pieces().size() <= many_pieces;
}

bool fits_double(const ContactProblem& problem, const std::vector<Rational>& at) {
  const auto all = [](const std::vector<Rational>& data) {
    return std::all_of(data.begin(), data.end(), is_comfortable);
  };
  const auto& pieces = problem.indenter().pieces();
  return all({problem.load(), problem.elasticity().compliance(), problem.elasticity().gamma(),
              problem.indenter().left(), problem.load_at().value_or(0)}) &&
         all(problem.friction().values()) && all(problem.friction().jumps()) && all(at) &&
         std::all_of(pieces.begin(), pieces.end(), [&](const Indenter::Piece& piece) {
           return is_comfortable(piece.to) && all(piece.profile.coefficients());
         });
}

template <numeric::Real R>
numeric::Attempt<R> attempt(Method method, const ContactProblem& problem, const numeric::ContactSolution<R>* start) {
  if (method != Method::riemann_hilbert) {
    numeric::Attempt<R> formula = numeric::closed_form<R>(problem);
    if (formula.solution || method == Method::closed_form) return formula;
  }
  if (!problem.body().is_half_plane()) {
    if constexpr (std::same_as<R, double>) return numeric::contact_on_body(problem);
    return {nullptr, "on this body a problem without a closed form is solved with 16 digits alone"};
  }
  return numeric::riemann_hilbert<R>(problem, start);
}

template numeric::Attempt<double> attempt(Method, const ContactProblem&, const numeric::ContactSolution<double>*);
template numeric::Attempt<numeric::Real50> attempt(Method, const ContactProblem&,
                                                   const numeric::ContactSolution<numeric::Real50>*);
template numeric::Attempt<numeric::Real100> attempt(Method, const ContactProblem&,
                                                    const numeric::ContactSolution<numeric::Real100>*);

}  // namespace steadyslide::library
