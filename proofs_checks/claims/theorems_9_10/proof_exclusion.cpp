// Why a free end has no edge singularity: the last step in the proof of theorem 10. [Bal16, theorem 10]

#include "numeric/riemann_hilbert/gap_integral.hpp"
#include "proofs_checks/instruments/proofs.hpp"
#include "proofs_checks/instruments/trial.hpp"

namespace steadyslide::proofs_checks {
namespace {

/// A contact that is made to end at 0 with an edge, where the profile is continuous: no solution, but the equation
/// holds.
struct ForcedEnd {
  std::string name;
  Side beyond;  ///< of 0
  double other_end;
  Rational slope;
};

std::vector<ForcedEnd> forced_ends(bool quick) {
  std::vector<ForcedEnd> all{{"contact on the right, pressed", Side::left, 0.4, Rational(-1, 4)},
                             {"contact on the right, drawn", Side::left, 0.4, Rational(1)},
                             {"contact on the left, pressed", Side::right, -0.4, Rational(1, 4)}};
  if (quick) return all;
  all.push_back({"contact on the left, drawn", Side::right, -0.4, -1});
  all.push_back({"contact on the right, longer", Side::left, 1.1, Rational(-1, 2)});
  return all;
}

Trial trial_of(const ForcedEnd& c, const Rational& s) {
  const Polynomial profile({0, c.slope, Rational(1, 2), Rational(1, 12)});
  const auto place = numeric::to_real<double>(-Trial::frame().origin / Trial::frame().unit);
  const numeric::ContactInterval zone = c.beyond == Side::left
                                            ? numeric::ContactInterval{place, c.other_end, true, false}
                                            : numeric::ContactInterval{c.other_end, place, false, true};
  return {
      c.name,
      {Elasticity::reduced(Rational(1, 2)), FrictionProfile({2 * s}), Indenter(-4, {{0, profile}, {4, profile}}), 1},
      {zone},
      {1, 1},
      0};
}

template <class R>
struct ForcedFacts {
  std::string name;
  Rational s;
  Side beyond;
  R a;            ///< of t ~ -a d^p
  R gap;          ///< very near the end, over d^{p+1}
  double routes;  ///< what the gap differs by from the trapezoidal rule's, over its size
};
template <class R>
using ForcedList = std::vector<ForcedFacts<R>>;

Exponent edge_power(const ForcedEnd& c, const Rational& s) {
  return c.beyond == Side::left ? -(half + Exponent::angle(s)) : -(half - Exponent::angle(s));
}

template <Real R>
ForcedFacts<R> measure_forced(const ForcedEnd& c) {
  using std::abs, std::pow;
  const Rational s(3, 4);
  const TrialForm<R> trial(trial_of(c, s));
  const auto& form = trial.form();
  std::size_t j = 0;
  while (!(form.set().point(j).anchor && form.problem().place(*form.set().point(j).anchor) == 0)) ++j;
  const R unit = numeric::to_real<R>(Trial::frame().unit);
  const R d = very_near<R>();
  const R p = numeric::to_real<R>(edge_power(c, s));
  const Side inside = opposite(c.beyond);
  const R a = -form.traction(beside(form, j, inside, R(d * unit))).value / pow(d, p);
  const numeric::GapIntegral<R> beyond(form, j);
  const R gap = beyond.reduced_gap(beside(form, j, c.beyond, R(d * unit))).value / pow(d, R(p + 1));
  // A place where nothing is small.
  const R far = R(1) / 50;
  const auto at = beside(form, j, c.beyond, R(far * unit));
  const numeric::trapezoidal::Grid<R> grid(traction_density(form));
  const R by_rule = beyond.profile_increment(at) - grid.displacement(0, c.beyond, far);
  const R by_form = beyond.reduced_gap(at).value;
  return {c.name, s, c.beyond, a, gap, relative_difference<R>(by_rule, by_form)};
}

struct ExclusionSaid {
  int sign = -1;
  bool root = true;
  bool over_power = true;  ///< the integral's 1/(1/2 -+ alpha)
  int miss = 0;
};

std::vector<Evidence> check_exclusion(const Context& context, Once<ForcedList>& once, const ExclusionSaid& said) {
  return gather_quick_in_double(context, [&]<Real R>() {
    const Quantity gap{"gap beyond a forced end over d^{p+1}", {"form", "-a sqrt(1+s^2)/(p+1)"}, tolerance<R>()};
    const Quantity routes{"gap at d = 1/50", {"trapezoidal rule", "form"}, tolerance<R>()};
    const ForcedList<R>& all = once.at<R>(context.quick, [&] {
      ForcedList<R> list;
      for (const ForcedEnd& c : forced_ends(context.quick)) list.push_back(measure_forced<R>(c));
      return list;
    });
    bool signs[2] = {false, false};
    Findings findings;
    for (const ForcedFacts<R>& facts : all) {
      findings.begin_case(facts.name);
      const R p = numeric::to_real<R>(
          (facts.beyond == Side::left ? -Exponent::angle(facts.s) : Exponent::angle(facts.s)) - half);
      R expected = said.sign * facts.a * (1 + said.miss * R(tolerance<R>()));
      if (said.root) expected /= numeric::cos_pi_alpha<R>(facts.s);
      if (said.over_power) expected /= p + 1;
      findings.compare(gap, relative_difference<R>(facts.gap, expected));
      findings.compare(routes, facts.routes);
      signs[facts.a > 0 ? 1 : 0] = true;
      findings.require((facts.gap < 0) == (facts.a > 0), "a > 0 without penetration beyond the end");
    }
    findings.require(signs[0] && signs[1], "a has one sign only in these cases");
    return findings.evidence("contacts made to end where the profile is continuous");
  });
}

}  // namespace

Claim proof_exclusion() {
  using Said = ExclusionSaid;
  return make_claim(
      claim_text("thm-10-proof-exclusion"),
      [once = std::make_shared<Once<ForcedList>>()](const Context& context, const Said& said) {
        return check_exclusion(context, *once, said);
      },
      Said{},
      std::vector<Wrong<Said>>{
          {"the surface below the indenter for a > 0", changed<Said>([](Said& said) { said.sign = 1; })},
          {"sqrt(1+s^2) missing", changed<Said>([](Said& said) { said.root = false; })},
          {"1/(1/2-alpha) missing", changed<Said>([](Said& said) { said.over_power = false; })},
          {"near miss: the gap moved by ten times the tolerance", changed<Said>([](Said& said) { said.miss = 10; })}});
}

}  // namespace steadyslide::proofs_checks
