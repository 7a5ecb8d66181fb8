#include "library/solve/warnings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "library/solve/failed_condition.hpp"
#include "library/text/number_format.hpp"

namespace steadyslide::library {
namespace {

using numeric::ContactComponent;
using numeric::Real;

/// The fraction of the support at each of its ends. All contact of a trace with a wrong unit or sign lies there.
constexpr double sliver = 0.01;

/// The ends of contact at which the support of a trace ends.
template <Real R>
std::string cut_end(const std::vector<ContactComponent<R>>& contact) {
  std::string places;
  for (const auto& component : contact) {
    for (const auto* end : {&component.left, &component.right}) {
      if (end->kind != SingularKind::edge) continue;
      places += (places.empty() ? "x = " : ", ") + number_text(end->x, 6).shown;
    }
  }
  if (places.empty()) return "";
  return "contact reaches a cut end of the trace; what was measured ends there, the indenter may go on; " + places;
}

template <Real R>
std::string sliver_only(const Indenter& indenter, const std::vector<ContactComponent<R>>& contact) {
  const auto left = numeric::to_real<R>(indenter.left());
  const auto right = numeric::to_real<R>(indenter.right());
  const R reach = (right - left) * R(sliver);
  const bool all = std::all_of(contact.begin(), contact.end(), [&](const ContactComponent<R>& component) {
    return component.right.x.value <= left + reach || component.left.x.value >= right - reach;
  });
  if (contact.empty() || !all) return "";
  return fmt::format(
      "all contact lies within the last 1 % of the trace; heights are in the unit of x and positive away from the "
      "body: check their unit and sign; x = {} to {}",
      number_text(contact.front().left.x, 6).shown, number_text(contact.back().right.x, 6).shown);
}

/// The sum of the sizes of the terms of a polynomial's slope at x.
Rational size_of_slope(const Polynomial& polynomial, const Rational& x) {
  Rational size = 0;
  Rational power = 1;
  const std::vector<Rational>& coefficients = polynomial.coefficients();
  for (std::size_t k = 1; k < coefficients.size(); ++k, power *= abs(x)) size += k * abs(coefficients[k]) * power;
  return size;
}

/// The breaks whose kink is at most as large as 16 roundings to double of both slopes, or of a measured height over the
/// shorter piece. Such kinks come from numbers that a program has written.
std::vector<Rational> rounded_kinks(const Indenter& indenter, bool is_measured) {
  const Integer roundings = Integer(1) << (std::numeric_limits<double>::digits - 4);
  std::vector<Rational> result;
  const std::vector<Indenter::Break>& breaks = indenter.breaks();
  for (std::size_t k = 0; k < breaks.size(); ++k) {
    const Rational& x = breaks[k].x;
    Rational size = size_of_slope(indenter.pieces()[k].profile, x) + size_of_slope(indenter.pieces()[k + 1].profile, x);
    if (is_measured) {
      const Rational before = x - (k == 0 ? indenter.left() : breaks[k - 1].x);
      const Rational behind = (k + 1 < breaks.size() ? breaks[k + 1].x : indenter.right()) - x;
      size += abs(indenter.pieces()[k].profile(x)) / std::min(before, behind);
    }
    if (breaks[k].step == 0 && abs(breaks[k].wedge) * roundings <= size) result.push_back(x);
  }
  return result;
}

template <Real R>
std::string gaps_unresolved(std::vector<numeric::UnresolvedGap<R>> gaps, const Indenter& indenter, bool is_measured) {
  if (gaps.empty()) return "";
  for (const Rational& x : rounded_kinks(indenter, is_measured)) {
    std::erase_if(gaps, [at = numeric::to_real<R>(x)](const auto& gap) { return gap.x.value == at; });
  }
  if (gaps.empty()) return "";
  constexpr std::size_t most_named = 3;
  std::string named;
  for (std::size_t k = 0; k < std::min(gaps.size(), most_named); ++k) {
    named += fmt::format("{}x = {} (about 1e{:.0f})", k == 0 ? "" : ", ", number_text(gaps[k].x, 6).shown,
                         gaps[k].log10_length);
  }
  if (gaps.size() > most_named) named += fmt::format(" and {} more", gaps.size() - most_named);
  return "gaps over notches of the profile are shown as contact; they are too short for any place in them to have a "
         "number; " +
         named;
}

/// Linear elasticity is for small slopes.
std::string steep_slopes(const Indenter& indenter) {
  constexpr double steep = 1;
  double largest = 0;
  Rational left = indenter.left();
  for (const Indenter::Piece& piece : indenter.pieces()) {
    const Polynomial slope = piece.profile.derivative();
    for (const Rational& x : {left, piece.to})
      largest = std::max(largest, std::abs(numeric::to_real<double>(slope(x))));
    left = piece.to;
  }
  if (largest <= steep) return "";
  return "slopes of the measured profile reach " + format_number(largest, 2) +
         "; are the units of x and of the heights right (x_unit, height_unit)?";
}

}  // namespace

template <Real R>
std::vector<std::string> warnings(const Problem& problem, const numeric::ContactSolution<R>& solution) {
  std::vector<std::string> result;
  for (const NamedError& error : named(solution.estimated_error())) {
    const bool fine = error.value <= large_error;  // false for NaN
    if (fine) continue;
    result.push_back(fmt::format("{}: {}; more than {} of {}; {}", error.name, estimated_error_warning,
                                 percent(large_error), error.of, percent(error.value)));
  }
  std::string unresolved =
      gaps_unresolved(solution.unresolved_gaps(), problem.contact.indenter(), problem.measured.has_value());
  if (!unresolved.empty()) result.push_back(std::move(unresolved));
  if (!problem.measured) return result;
  const std::vector<ContactComponent<R>> contact = solution.contact();
  const Indenter& indenter = problem.contact.indenter();
  for (const std::string& line : {steep_slopes(indenter), cut_end(contact), sliver_only(indenter, contact)}) {
    if (!line.empty()) result.push_back(line);
  }
  return result;
}

#define STEADYSLIDE_WARNINGS_AT(R) \
  template std::vector<std::string> warnings(const Problem&, const numeric::ContactSolution<R>&)
STEADYSLIDE_WARNINGS_AT(double);
STEADYSLIDE_WARNINGS_AT(numeric::Real50);
STEADYSLIDE_WARNINGS_AT(numeric::Real100);

}  // namespace steadyslide::library
