// The flat punch under constant friction: where it carries, and where least. [Bal16, figure 3, (4)]
//
//   int_{-1}^0 t_0 = (2 cos(pi alpha)/pi) int_0^1 v^{-2 alpha}/(1+v^2) dv,   v^2 = (1+x)/(1-x),
//                  = (cos(pi alpha)/(2 pi)) (digamma(3/4 - alpha/2) - digamma(1/4 - alpha/2)).

#include <boost/math/special_functions/digamma.hpp>

#include "numeric/quadrature/tanh_sinh.hpp"
#include "proofs_checks/claims/figures/figures.hpp"
#include "proofs_checks/instruments/near.hpp"
#include "proofs_checks/instruments/punch.hpp"

namespace steadyslide::proofs_checks {
namespace {

/// Friction f on both halves: a jump of height zero at 0 makes the solver share the load there.
ContactProblem halves(const Rational& nu, const Rational& f) { return punch(nu, {f, f}, {0}); }

std::vector<ContactProblem> problems(bool quick) {
  const Rational nu(3, 10);
  std::vector<ContactProblem> all{halves(nu, 2)};
  if (quick) return all;
  for (const Rational& f : {Rational(1, 5), Rational(1), Rational(50)}) all.push_back(halves(nu, f));
  all.push_back(halves(Rational(-9, 10), 2));
  return all;
}

template <class R>
struct RearFacts {
  std::string name;
  Rational s;
  Solved<R> solution;
  R by_solver;
  R by_quadrature;
};
template <class R>
using RearList = std::vector<RearFacts<R>>;

struct RearSaid {
  int sign = 1;       ///< of alpha
  Rational least{2};  ///< x of the smallest |t| over alpha
  bool cosine = true;
  bool half_each = false;
  int miss_share = 0;
  int miss_least = 0;
};

template <Real R>
RearList<R> measure(bool quick) {
  RearList<R> all;
  for (const ContactProblem& problem : problems(quick)) {
    RearFacts<R> facts{text_of(problem), problem.coupled_friction(0), solve<R>(problem), 0, 0};
    facts.by_solver = facts.solution->resultants().load_share.front().value;
    const R size = -punch_amplitude<R>(problem, 0);
    const PowerForm<R> form =
        power_form<R>({-1, 0, 1}, {-(half + alpha(problem, 0)), Exponent(), -(half - alpha(problem, 0))}, {size, size});
    facts.by_quadrature = numeric::tanh_sinh::panel_integral<R>(form.traction().density().front()).value;
    all.push_back(std::move(facts));
  }
  return all;
}

template <Real R>
void check_least(Findings& findings, const RearFacts<R>& facts, const R& angle, const RearSaid& said) {
  using std::abs, std::pow;
  const Quantity least{
      "where |t| is smallest: t'/t", {"differences of the solved traction", "0 at x = 2 alpha"}, tolerance<R>()};
  const Quantity size{"the smallest |t|",
                      {"solved", "(P cos(pi alpha)/pi) (1+2 alpha)^{-(1/2+alpha)} (1-2 alpha)^{-(1/2-alpha)}"},
                      tolerance<R>()};
  const auto t = [&](const R& x) {
    const std::size_t end = contact_end(*facts.solution, x < 0 ? Side::left : Side::right);
    return x < 0 ? traction_beside(*facts.solution, end, Side::right, R(1 + x))
                 : traction_beside(*facts.solution, end, Side::left, R(1 - x));
  };
  const R x = numeric::to_real<R>(said.least) * angle * (1 + said.miss_least * R(tolerance<R>()));
  findings.compare(least, static_cast<double>(R(abs(derivative<R>(t, x, R(1 - abs(x))) / t(x)) * (1 - abs(x)))));
  findings.require(abs(t(x)) < abs(t(R(x - (1 + x) / 10))) && abs(t(x)) < abs(t(R(x + (1 - x) / 10))),
                   "|t| is not smallest there");
  const R expected = numeric::cos_pi_alpha<R>(facts.s) / numeric::pi<R>() *
                     pow(R(1 + 2 * angle), R(-(angle + R(1) / 2))) * pow(R(1 - 2 * angle), R(angle - R(1) / 2));
  findings.compare(size, relative_difference<R>(R(-t(R(2 * angle))), expected));
}

std::vector<Evidence> check(const Context& context, Once<RearList>& once, const RearSaid& said) {
  return gather_at_fifty(context, [&]<Real R>() {
    const Quantity solver{"load on the rear half, solver", {"load shares", "digamma functions"}, tolerance<R>()};
    const Quantity quadrature{
        "load on the rear half, tanh-sinh", {"quadrature of (4)", "digamma functions"}, tolerance<R>()};
    Findings findings;
    for (const RearFacts<R>& facts : once.at<R>(context.quick, [&] { return measure<R>(context.quick); })) {
      findings.begin_case(facts.name);
      const R angle = said.sign * numeric::to_real<R>(Exponent::angle(facts.s));
      const R difference = boost::math::digamma(R((3 - 2 * angle) / 4)) - boost::math::digamma(R((1 - 2 * angle) / 4));
      R share = difference / (2 * numeric::pi<R>()) * (1 + said.miss_share * R(tolerance<R>()));
      if (said.cosine) share *= numeric::cos_pi_alpha<R>(facts.s);
      if (said.half_each) share = R(1) / 2;
      findings.compare(solver, relative_difference<R>(facts.by_solver, share));
      findings.compare(quadrature, relative_difference<R>(facts.by_quadrature, share));
      findings.require(share > R(1) / 2, "the rear half carries no more than the front half");
      findings.decide("the power at the rear is the smaller one",
                      (edge_exponent(End::right, facts.s) - edge_exponent(End::left, facts.s)).sign() > 0);
      check_least(findings, facts, angle, said);
    }
    return findings.evidence("solved flat punches");
  });
}

}  // namespace

Claim figure_rear_loaded() {
  return make_claim(
      claim_text("fig-03-rear-loaded"),
      [once = std::make_shared<Once<RearList>>()](const Context& context, const RearSaid& said) {
        return check(context, *once, said);
      },
      RearSaid{},
      std::vector<Wrong<RearSaid>>{
          {"more at the front: alpha's sign", changed<RearSaid>([](RearSaid& said) { said.sign = -1; })},
          {"half of the load on each half", changed<RearSaid>([](RearSaid& said) { said.half_each = true; })},
          {"cos(pi alpha) missing in the share", changed<RearSaid>([](RearSaid& said) { said.cosine = false; })},
          {"the minimum at the centre", changed<RearSaid>([](RearSaid& said) { said.least = 0; })},
          {"the minimum at x = alpha", changed<RearSaid>([](RearSaid& said) { said.least = 1; })},
          {"near miss: the share moved by ten times the tolerance",
           changed<RearSaid>([](RearSaid& said) { said.miss_share = 10; })},
          {"near miss: the minimum moved by ten times the tolerance",
           changed<RearSaid>([](RearSaid& said) { said.miss_least = 10; })}});
}

}  // namespace steadyslide::proofs_checks
