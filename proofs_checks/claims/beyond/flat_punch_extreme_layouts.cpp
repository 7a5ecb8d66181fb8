#include "numeric/flat_punch/flat_punch.hpp"
#include "proofs_checks/instruments/tractions/punch_loads.hpp"
#include "proofs_checks/kit/claim_builder.hpp"

namespace steadyslide::proofs_checks::flat_punch_extreme_layouts {
namespace {

/// Two coatings, given by s; f is twice as large.
struct Coatings {
  std::string name;
  Rational outer;
  Rational inner;
  Rational share;  ///< share of the inner coating

  int sign() const { return outer > inner ? 1 : -1; }  ///< 1 if the extreme is the largest value, -1 if the smallest
};

/// Returns s_eff from the tractions.
double s_eff(const std::vector<Rational>& s, std::vector<Rational> jumps) {
  std::vector<Rational> f;
  for (const Rational& one : s) f.push_back(2 * one);
  const ContactProblem punch(Elasticity::reduced(Rational(1, 2)), FrictionProfile(std::move(f), std::move(jumps)),
                             Indenter(-1, {{1, Polynomial()}}), 1);
  return punch_loads<double>(punch).friction / 2;
}

/// Returns s_eff of the layout outer | inner | outer with the first jump at c.
double s_eff(const Coatings& coatings, double c) {
  const auto& [name, outer, inner, share] = coatings;
  return s_eff({outer, inner, outer}, {Rational(c), Rational(c) + 2 * share});
}

/// Returns the position of the first jump at which a step to the left and a step to the right give the same s_eff.
double stationary(const Coatings& coatings, double step) {
  double low = -1 + 2 * step;
  double high = 1 - 2 * to_real<double>(coatings.share) - 2 * step;
  for (int k = 0; k < 45; ++k) {
    const double middle = (low + high) / 2;
    const double rise = s_eff(coatings, middle + step) - s_eff(coatings, middle - step);
    (coatings.sign() * rise > 0 ? low : high) = middle;
  }
  return (low + high) / 2;
}

/// Returns the limit of this position as the step tends to zero. Its error is proportional to the square of the step.
double stationary(const Coatings& coatings) {
  constexpr double step = 1e-3;
  return (4 * stationary(coatings, step) - stationary(coatings, 2 * step)) / 3;
}

/// Returns the most extreme s_eff of layouts with two to ten strips, among them those with a single jump.
double most_extreme(const Coatings& coatings, std::size_t count) {
  Random random(1, "flat-punch-extreme-layouts");
  double most = -1e300;
  const auto look_at = [&](const std::vector<Rational>& lengths, bool outer_first) {
    Rational sum[2] = {0, 0};
    for (std::size_t k = 0; k < lengths.size(); ++k) sum[k % 2] += lengths[k];
    const auto& [name, outer, inner, share] = coatings;
    std::vector<Rational> s, jumps;
    Rational at = -1;
    for (std::size_t k = 0; k < lengths.size(); ++k) {
      const bool is_outer = (k % 2 == 0) == outer_first;
      s.push_back(is_outer ? outer : inner);
      at += 2 * lengths[k] * (is_outer ? 1 - share : share) / sum[k % 2];
      if (k + 1 < lengths.size()) jumps.push_back(at);
    }
    most = std::max(most, coatings.sign() * s_eff(s, jumps));
  };
  for (const bool outer_first : {true, false}) {
    look_at({1, 1}, outer_first);
    look_at({1, 1, 1}, outer_first);
    for (std::size_t i = 0; i < count; ++i) {
      std::vector<Rational> lengths;
      for (std::size_t k = 2 + random.below(9); k > 0; --k) lengths.push_back(random.between(0, 1));
      look_at(lengths, outer_first);
    }
  }
  return most;
}

Values extreme(const Rational& outer, const Rational& inner, const Rational& share) {
  const auto found = numeric::extreme_layout<double>(outer, inner, share);
  return {{"first jump", 2 * found.left.value - 1},
          {"second jump", 1 - 2 * found.right.value},
          {"friction", found.s_eff.value},
          {"others", outer > inner ? found.s_eff.value : -found.s_eff.value}};
}

}  // namespace

Claim claim() {
  const Rational smooth(3, 80);
  const Rational rough(3, 16);
  return compared<Coatings>("flat-punch-extreme-layouts")
      .cases(fixed_cases<Coatings>({{"largest, s = 0.0375, 0.1875, half and half", rough, smooth, Rational(1, 2)},
                                    {"smallest, s = 0.0375, 0.1875, half and half", smooth, rough, Rational(1, 2)},
                                    {"largest, s = 0, 2, three tenths smooth", 2, 0, Rational(3, 10)},
                                    {"smallest, s = 0, 2, three tenths rough", 0, 2, Rational(3, 10)},
                                    {"largest, s = 1/2, 1, half and half", 1, Rational(1, 2), Rational(1, 2)}},
                                   2, "pairs of coatings"))
      .precision(Precision::in_double)
      .measured([](const Coatings& coatings, const Context& context) -> Values {
        const double first = stationary(coatings);
        return {{"first jump", first},
                {"second jump", first + 2 * to_real<double>(coatings.share)},
                {"friction", s_eff(coatings, first)},
                {"others", most_extreme(coatings, context.quick ? 20 : 200)}};
      })
      .predicted([](const Coatings& c) { return extreme(c.outer, c.inner, c.share); })
      .wrong("the coatings exchanged", [](Values& p, const Coatings& c) { p = extreme(c.inner, c.outer, 1 - c.share); })
      .wrong("the interval in the middle",
             [](Values& p, const Coatings& c) {
               const auto end = to_real<Number>(c.share);
               p.set({{"first jump", Number(-end)}, {"second jump", end}});
             })
      .wrong("the mirrored layout",
             [](Values& p, const Coatings&) {
               const Number first = p["first jump"];
               p.set({{"first jump", Number(-p["second jump"])}, {"second jump", Number(-first)}});
             })
      .wrong("the extreme of layouts with one jump",
             [](Values& p, const Coatings& c) {
               const double outer_first = c.sign() * s_eff({c.outer, c.inner}, {1 - 2 * c.share});
               const double inner_first = c.sign() * s_eff({c.inner, c.outer}, {2 * c.share - 1});
               const double most = std::max(outer_first, inner_first);
               p.set({{"friction", c.sign() * most}, {"others", most}});
             })
      .wrong("the extreme of another share",
             [](Values& p, const Coatings& c) { p = extreme(c.outer, c.inner, c.share + Rational(1, 20)); })
      .near_misses();
}

}  // namespace steadyslide::proofs_checks::flat_punch_extreme_layouts
