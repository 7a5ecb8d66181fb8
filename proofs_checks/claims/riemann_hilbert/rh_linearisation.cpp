// Compares the derivatives of a solution that Newton's method uses for the contact ends with difference quotients.

#include <array>

#include "proofs_checks/instruments/solutions/trial.hpp"
#include "proofs_checks/kit/claim_builder.hpp"

namespace steadyslide::proofs_checks::rh_linearisation {
namespace {

/// The formulas: d(u'/c)/de = Y (p B(e)/(x - e) - (p/pi) [q/(z - e)]_poly) with q and the tilt fixed; in the contact
/// dt = -eps cos(pi alpha) |Y| (...). d(u'/c)/dtilt = 1 - Y [1/Y]_poly.
struct Derivatives {
  /// The power of the free end in the residue: its own, left out, or with alpha of the other sign.
  enum class Power { own, missing, other_sign };

  Number residue = 1;  ///< factors of the terms
  Number polynomial = 1;
  Number tilt = 1;
  Power power = Power::own;  ///< power in the residue
};

/// The bracket of the formula: a pole at the free end, and a polynomial.
template <class R>
struct Bracket {
  std::size_t end;
  R pole;
  std::vector<R> polynomial;

  Bracket(const TractionRepresentation<R>& form, std::size_t j, const Derivatives& said) : end(j) {
    const R& p = form.fundamental_solution().powers()[j].value;
    const R in_residue = said.power == Derivatives::Power::own       ? p
                         : said.power == Derivatives::Power::missing ? R(1)
                                                                     : R(1 - p);
    const R& e = form.set().x(j);
    pole = R(said.residue) * in_residue *
           form.regular_factor_at(j, form.set().in_contact(j) ? Side::right : Side::left).value;
    // Coefficient i of [q/(z - e)]_poly is q_{i+1} + q_{i+2} e + ...
    for (std::size_t i = 0; i + 1 < form.q().size(); ++i) {
      R sum = 0;
      for (std::size_t l = form.q().size(); l-- > i + 1;) sum = sum * e + form.q()[l];
      polynomial.push_back(R(said.polynomial) * -p / numeric::pi<R>() * sum);
    }
  }
};

/// Returns the middle of every segment, and a point beyond each end of the support.
template <Real R>
std::vector<SurfacePoint<R>> places(const ContactSet<R>& set) {
  const R d = R(1) / 3;
  std::vector<SurfacePoint<R>> result{numeric::beside(set, 0, Side::left, d),
                                      numeric::beside(set, set.segments(), Side::right, d)};
  for (std::size_t k = 0; k < set.segments(); ++k) {
    result.push_back(numeric::beside(set, k, Side::right, R(set.length(k) / 2)));
  }
  return result;
}

template <Real R>
bool is_inside(const TractionRepresentation<R>& form, const SurfacePoint<R>& at) {
  return at.segment >= 0 && at.segment < static_cast<std::ptrdiff_t>(form.set().segments()) &&
         form.set().in_contact(static_cast<std::size_t>(at.segment));
}

/// Returns t in the contact, u'/c outside of it.
template <Real R>
R value(const TractionRepresentation<R>& form, const SurfacePoint<R>& at) {
  return is_inside(form, at) ? form.traction(at).value : form.surface_slope(at).value;
}

/// Returns the factor of the bracket: Y for u', -eps cos(pi alpha) |Y| for t.
template <Real R>
R factor(const TractionRepresentation<R>& form, const SurfacePoint<R>& at) {
  const R y = form.sign(at.segment) * form.modulus(at);
  if (!is_inside(form, at)) return y;
  return -y * form.problem().cos_alpha(form.friction_at(static_cast<std::size_t>(at.segment)));
}

/// Returns central differences of order ten. Their error and rounding, eps/h, stay far below the tolerance.
template <Real R>
std::vector<R> differences(const TrialForm<R>& trial, std::size_t f, const std::vector<SurfacePoint<R>>& at) {
  const ContactSet<R>& set = trial.form().set();
  const std::size_t end = set.movable()[f];
  const R h = std::same_as<R, Real50> ? R(1e-7) : R(1e-12);
  constexpr std::array<std::array<int, 2>, 5> weights{{{5, 6}, {-5, 21}, {5, 84}, {-5, 504}, {1, 1260}}};
  std::vector<R> result(at.size(), R(0));
  for (int k = 1; k <= 5; ++k) {
    for (const int sign : {1, -1}) {
      const R step = sign * k * h;
      std::vector<R> steps(set.movable().size(), R(0));
      steps[f] = step;
      ContactSet<R> moved = set;
      moved.move(steps);
      const TractionRepresentation<R> form = trial.form_on(std::move(moved), trial.form().tilt());
      const auto [numerator, denominator] = weights[static_cast<std::size_t>(k - 1)];
      for (std::size_t i = 0; i < at.size(); ++i) {
        SurfacePoint<R> place = at[i];
        if (place.segment == static_cast<std::ptrdiff_t>(end)) place.node.from_left -= step;
        if (place.segment == static_cast<std::ptrdiff_t>(end) - 1) place.node.from_right += step;
        result[i] += sign * value(form, place) * numerator / (denominator * h);
      }
    }
  }
  return result;
}

template <Real R>
void check_ends(Findings& findings, const Derivatives& said, const TrialForm<R>& trial) {
  const TractionRepresentation<R>& form = trial.form();
  const std::vector<SurfacePoint<R>> at = places(form.set());
  const std::vector<std::size_t> ends = form.set().movable();
  for (std::size_t f = 0; f < ends.size(); ++f) {
    // Only the first and the last end, because each end costs ten forms.
    if (f > 0 && f + 1 < ends.size()) continue;
    const Bracket<R> bracket(form, ends[f], said);
    const std::vector<R> measured = differences(trial, f, at);
    for (std::size_t i = 0; i < at.size(); ++i) {
      const R sum = value_of(bracket.polynomial, at[i].node.x) + bracket.pole / form.distance(at[i], ends[f]);
      findings.compare("end", R(factor(form, at[i]) * sum), measured[i]);
    }
  }
}

template <Real R>
void check_tilt(Findings& findings, const Derivatives& said, const TrialForm<R>& trial) {
  using std::abs, std::max;
  const TractionRepresentation<R>& form = trial.form();
  const TractionRepresentation<R> tilted = trial.form_on(form.set(), R(form.tilt() + 1));
  for (const SurfacePoint<R>& at : places(form.set())) {
    const R expected =
        (is_inside(form, at) ? 0 : 1) - R(said.tilt) * factor(form, at) * form.expansion().tilt_polynomial(at.node.x);
    const R before = value(form, at);
    findings.compare("tilt", R(value(tilted, at) - before), expected, max(R(abs(before)), R(1)));
  }
}

CaseList<Trial> all_trials(const Context& context) {
  // A full run has the number of cases of a run in double, but examines them at 50 digits.
  CaseList<Trial> list = trials("rh-linearisation", {2, 2, 1}, true)(
      {context.quick ? context.digits : numeric::Digits::sixteen, context.seed, context.quick});
  // q/(z - e) has a polynomial part if q has two coefficients: three components with one free end.
  list.cases.insert(list.cases.begin() + 1, with_ends({{true, true}, {false, true}, {true, true}}));
  return list;
}

}  // namespace

Claim claim() {
  using Power = Derivatives::Power;
  return formula_claim<Trial, Derivatives>("rh-linearisation")
      .cases(all_trials)
      .effective_where([](const Trial& trial) { return !TrialForm<double>(trial).form().set().movable().empty(); })
      // Difference quotients lose digits.
      .precision(Precision::at_least_fifty)
      .checked([]<Real R>(Findings& findings, const Derivatives& said, const Trial& trial) {
        const TrialForm<R> tried(trial);
        check_tilt(findings, said, tried);
        check_ends(findings, said, tried);
      })
      .wrong("the residue `-p B(e)`", &Derivatives::residue, -1)
      .wrong("the residue `B(e)`, `p` missing", &Derivatives::power, Power::missing)
      .wrong("`alpha` of the other sign in the residue's `p`", &Derivatives::power, Power::other_sign)
      .wrong("[q/(z-e)]_poly left out", &Derivatives::polynomial, 0)
      .wrong("`[q/(z-e)]_poly` without `1/pi`", &Derivatives::polynomial, numeric::pi<Number>())
      .wrong("`Y [1/Y]_poly` left out", &Derivatives::tilt, 0)
      .near_miss("the residue", &Derivatives::residue);
}

}  // namespace steadyslide::proofs_checks::rh_linearisation
