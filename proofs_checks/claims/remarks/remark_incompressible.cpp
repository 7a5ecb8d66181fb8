// The limit of an incompressible body. [Bal16, remark 1]

#include "proofs_checks/claims/remarks/remarks.hpp"
#include "proofs_checks/instruments/near.hpp"
#include "proofs_checks/kit/rate.hpp"

namespace steadyslide::proofs_checks {
namespace {

/// Problems that differ by gamma alone: of a reduced problem, or by nu -> 1/2 at the same compliance.
struct LimitCase {
  std::string name;
  std::vector<Rational> f;
  Indenter indenter;
  bool by_poisson = false;

  ContactProblem problem(const Elasticity& elasticity, bool with_friction) const {
    std::vector<Rational> values = f;
    if (!with_friction) values.assign(f.size(), 0);
    std::vector<Rational> jumps;
    if (f.size() > 1) jumps.emplace_back(1, 8);
    return {elasticity, FrictionProfile(std::move(values), std::move(jumps)), indenter, Rational(3, 2)};
  }
};

Rational power_of_ten(int exponent) { return parse_rational("1e" + std::to_string(exponent)); }

Elasticity elasticity(const LimitCase& c, int exponent) {
  const Rational small = power_of_ten(exponent);
  return c.by_poisson ? Elasticity(Solid(Rational(1, 2) - small, 1)) : Elasticity::reduced(small);
}

std::vector<LimitCase> cases(bool quick) {
  const Rational c(1, 8);
  const Indenter flat(-1, {{1, Polynomial()}});
  const Indenter parabola(-2, {{2, Polynomial({0, 0, 1})}});
  std::vector<LimitCase> all{{"flat punch", {2}, flat}, {"parabola", {2}, parabola}};
  if (quick) return all;
  all.push_back({"flat punch, f jumps", {Rational(1, 2), 2}, flat});
  all.push_back({"flat punch, nu -> 1/2", {2}, flat, true});
  all.push_back({"wedge at a friction jump",
                 {2, Rational(1, 2)},
                 Indenter(-2, {{c, Polynomial({Rational(1, 8), -1, 1})}, {2, Polynomial({Rational(-1, 8), 1, 1})}})});
  return all;
}

template <class R>
struct LimitFacts {
  std::string name;
  std::vector<Level> levels;  ///< 1/gamma, largest relative difference of t
  Rational f;
  R slope;  ///< (t - t_frictionless)/(gamma t) at x = 1/2
  R shift;  ///< of the contact's centre over gamma
  R half_width;
  bool punch;
};
template <class R>
using LimitList = std::vector<LimitFacts<R>>;

struct LimitSaid {
  double rate = 1;
  int sign = 1;
  bool has_friction = true;  ///< in the coefficients
  bool over_pi = true;
  int miss = 0;
};

constexpr double coefficient_tolerance = 1e-20;

template <Real R>
R centre(const numeric::RiemannHilbertSolution<R>& solution) {
  const auto contact = solution.contact();
  return (contact.front().left.x.value + contact.back().right.x.value) / 2;
}

template <Real R>
LimitFacts<R> measure_case(const LimitCase& c) {
  using std::abs;
  LimitFacts<R> facts{c.name, {}, c.f.front(), 0, 0, 0, c.indenter.pieces().front().profile.degree() < 1};
  for (const int exponent : {-4, -8, -16, -24}) {
    const Elasticity body = elasticity(c, exponent);
    const auto with = solve<R>(c.problem(body, true));
    const auto without = solve<R>(c.problem(body, false));
    double largest = 0;
    R change = 0;
    for (const Rational& x : {Rational(-1, 2), Rational(1, 3), Rational(1, 2)}) {
      const R t = without->at(x).traction.left.value;
      change = (with->at(x).traction.left.value - t) / t;
      largest = std::max(largest, static_cast<double>(R(abs(change))));
    }
    const R gamma = numeric::to_real<R>(body.gamma());
    facts.levels.push_back({static_cast<double>(R(1 / gamma)), largest});
    facts.slope = change / gamma;
    facts.shift = (centre(*with) - centre(*without)) / gamma;
    facts.half_width = without->contact().front().right.x.value - centre(*without);
  }
  return facts;
}

template <Real R>
LimitList<R> measure(bool quick) {
  LimitList<R> all;
  for (const LimitCase& c : cases(quick)) all.push_back(measure_case<R>(c));
  return all;
}

std::vector<Evidence> check(const Context& context, Once<LimitList>& once, const LimitSaid& said) {
  return gather_at_fifty(context, [&]<Real R>() {
    using std::log;
    const Quantity slope{"first order at x = 1/2 of a flat punch, gamma = 1e-24",
                         {"solved problems", "-(f/pi) log((1+x)/(1-x))"},
                         coefficient_tolerance};
    const Quantity shift{"first order of the contact's centre under a parabola, gamma = 1e-24",
                         {"solved problems", "-(2 f/pi) a"},
                         coefficient_tolerance};
    Findings findings;
    for (const LimitFacts<R>& facts : once.at<R>(context.quick, [&] { return measure<R>(context.quick); })) {
      findings.begin_case(facts.name);
      const Rate rate = fitted_rate(facts.levels);
      findings.measure({"difference to the frictionless pressure, " + facts.name, rate.value, rate.error_bar, said.rate,
                        0.01, "relative, at three fixed points, gamma from 1e-4 to 1e-24"});
      const R first = said.sign * (said.has_friction ? numeric::to_real<R>(facts.f) : R(1)) /
                      (said.over_pi ? numeric::pi<R>() : R(1)) * (1 + said.miss * R(coefficient_tolerance));
      if (facts.name == "flat punch") {
        findings.compare(slope, relative_difference<R>(facts.slope, R(-first * log(R(3)))));
      }
      if (facts.name == "parabola") {
        findings.compare(shift, relative_difference<R>(facts.shift, R(-2 * first * facts.half_width)));
      }
    }
    return findings.evidence("solved problems at four values of gamma");
  });
}

}  // namespace

Claim remark_incompressible() {
  return make_claim(
      claim_text("rem-01-incompressible"),
      [once = std::make_shared<Once<LimitList>>()](const Context& context, const LimitSaid& said) {
        return check(context, *once, said);
      },
      LimitSaid{},
      std::vector<Wrong<LimitSaid>>{
          {"a difference of the order gamma^2", changed<LimitSaid>([](LimitSaid& said) { said.rate = 2; })},
          {"a difference of the order sqrt(gamma)", changed<LimitSaid>([](LimitSaid& said) { said.rate = 0.5; })},
          {"the sign of the first order", changed<LimitSaid>([](LimitSaid& said) { said.sign = -1; })},
          {"the first order without f", changed<LimitSaid>([](LimitSaid& said) { said.has_friction = false; })},
          {"the first order without 1/pi", changed<LimitSaid>([](LimitSaid& said) { said.over_pi = false; })},
          {"near miss: the first order moved by ten times the tolerance",
           changed<LimitSaid>([](LimitSaid& said) { said.miss = 10; })}});
}

}  // namespace steadyslide::proofs_checks
