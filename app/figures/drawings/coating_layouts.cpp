// The effective friction of a flat punch against the layout of its two coatings: one interval of the one inside the
// other, and ever finer alternation.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "app/figures/solved.hpp"
#include "numeric/flat_punch/flat_punch.hpp"

namespace steadyslide::app {
namespace {

using numeric::EffectiveFriction;
using numeric::FrictionLayout;

const Rational coated_nu(1, 5);
const Rational smooth(1, 10);
const Rational rough(1, 2);

/// `inner` on a half of the contact, from c - 1/2 to c + 1/2, `outer` on the rest.
ContactProblem sandwich(const Rational& outer, const Rational& inner, const Rational& c, Sliding sliding) {
  const Rational half_width(1, 2);
  return flat_punch(coated_nu, {outer, inner, outer}, {c - half_width, c + half_width}, sliding);
}

double effective(const ContactProblem& problem) {
  const auto layout = FrictionLayout<double>::of(problem);
  const Rational coupling = problem.coupled_friction(0) / problem.friction().values()[0];
  return EffectiveFriction<double>(layout).value().value / numeric::to_real<double>(coupling);
}

/// Draws lines by the integral over the free surface, and marks by the solver on cells.
void add_curves(Panel& panel, const Rational& outer, const Rational& inner, const std::string& legend) {
  FrictionCurves wanted{{legend + ", to the right", legend + ", to the left"}, {}, {}, 7, 14, effective};
  for (int i = -49; i <= 49; ++i) wanted.places.emplace_back(i, 100);
  wanted.problem = [&](const Rational& c, Sliding sliding) { return sandwich(outer, inner, c, sliding); };
  std::ranges::move(friction_curves(wanted, static_cast<int>(panel.series.size() / 2) + 1),
                    std::back_inserter(panel.series));
}

Panel by_place() {
  Panel panel{{0.095, 0.49, 0.36, 0.91},
              {"middle of the inner half {/:Italic c} / {/:Italic L}", -0.5, 0.5, false, 0.25},
              {"effective friction {/:Italic T}/{/:Italic P}", 0.2, 0.4, false, 0.05}};
  panel.legend = LegendAt::below;
  add_curves(panel, rough, smooth, "rough outside");
  add_curves(panel, smooth, rough, "rough inside");
  return panel;
}

/// |s_eff - limit| for N periods, and a line with the derived order through the last points.
Panel by_periods(const std::vector<Rational>& s) {
  Panel panel{{0.595, 0.985, 0.36, 0.91},
              {"periods {/:Italic N} (number)", 1, 2000, true},
              {"distance from the limit (of {/:Italic s}_{eff})", 0.01, 1, true}};
  panel.legend = LegendAt::below;
  const std::vector<Rational> shares(2, Rational(1, 2));
  for (const bool rough_is_rear : {true, false}) {
    const std::vector<Rational> order = rough_is_rear ? std::vector{s[1], s[0]} : s;
    const auto [limit, power] = numeric::fine_mixture<double>(shares, order);
    const int style = rough_is_rear ? 1 : 2;
    Series marks{rough_is_rear ? "rough at the rear edge" : "smooth at the rear edge", Look::marks, style, {}};
    for (int n = 1; n <= 1024; n *= 2) {
      const auto layout = FrictionLayout<double>::periodic(shares, order, n);
      marks.points.push_back({double(n), std::abs(EffectiveFriction<double>(layout).value().value - limit.value)});
    }
    const auto [n, error] = marks.points.back();
    Series line{rough_is_rear ? fmt::format("derived order {:.3f}", power) : "", Look::line, style, {}};
    for (const double at : {1.0, n}) line.points.push_back({at, error * std::pow(n / at, power)});
    panel.series.push_back(std::move(marks));
    panel.series.push_back(std::move(line));
  }
  return panel;
}

}  // namespace

Figure make_coating_layouts() {
  const Rational gamma = flat_punch(coated_nu, {smooth}).elasticity().gamma();
  const auto g = numeric::to_real<double>(gamma);
  const double largest = numeric::extreme_layout<double>(gamma * rough, gamma * smooth, {1, 2}).s_eff.value / g;
  const double smallest = numeric::extreme_layout<double>(gamma * smooth, gamma * rough, {1, 2}).s_eff.value / g;
  Panel place = by_place();
  for (const double value : {largest, smallest}) place.guides.push_back({{-0.5, value}, {0.5, value}});
  place.notes = {{{0.5, 0.94, true, true}, "{/:Italic f} = 0.1 and 0.5, half and half", Align::centre}};
  Panel periods = by_periods({0, 2});
  periods.notes = {{{0.96, 0.94, true, true}, "{/:Italic s} = 0 and 2, half and half", Align::right}};
  return {
      "coating-layouts",
      "Effective friction of two coatings in other layouts",
      fmt::format(
          "Tangential over normal force of a flat punch half of which carries each coating. Left, `nu = 1/5`: one "
          "coating on an interval inside the other, against the interval's place, for both directions of sliding; "
          "lines by the integral over the free surface, marks by the solver on 1000 cells. No layout leaves the range "
          "between the thin lines, {:.6f} to {:.6f}, sliding to the right. Right: how far `N` periods of two strips "
          "with `s = 0` and `s = 2` are from the limit of fine mixtures, `tan(pi a)`, `a` the mean of `alpha`, with "
          "the derived order `1/2 - a`.",
          smallest, largest),
      460,
      {place, periods}};
}

}  // namespace steadyslide::app
