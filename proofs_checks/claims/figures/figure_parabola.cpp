// Galin's parabola: the contact zone and the largest pressure. [Bal16, figure 5]

#include "proofs_checks/claims/figures/figures.hpp"
#include "proofs_checks/instruments/local_power.hpp"
#include "proofs_checks/instruments/near.hpp"
#include "proofs_checks/instruments/punch.hpp"

namespace steadyslide::proofs_checks {
namespace {

/// psi/c = x^2/(2 R), R = 1/5.
const Rational radius(1, 5);

ContactProblem parabola(const Rational& f, const Rational& load, Sliding sliding = Sliding::plus_x) {
  return {Elasticity::reduced(Rational(2, 7)), FrictionProfile({f}),
          Indenter(-2, {{2, Polynomial({0, 0, 1 / (2 * radius)})}}), load, sliding};
}

std::vector<ContactProblem> problems(bool quick) {
  std::vector<ContactProblem> all{parabola(2, 1)};
  if (quick) return all;
  all.push_back(parabola(Rational(1, 5), 3));
  all.push_back(parabola(30, 1));
  all.push_back(parabola(2, 1, Sliding::minus_x));
  return all;
}

template <class R>
struct ZoneFacts {
  std::string name;
  Rational s;
  Rational load;
  Solved<R> solution;
  R left;
  R right;
  R power[2];             ///< that the operator asks for, with the contact on the right and on the left
  double equation_error;  ///< of the solution in double
};
template <class R>
using ZoneList = std::vector<ZoneFacts<R>>;

struct ZoneSaid {
  int sign = 1;
  Rational largest{-4};  ///< its place over alpha a
  bool same_powers = false;
  bool friction_widens = true;
  int miss_end = 0;
  int miss_largest = 0;
};

template <Real R>
ZoneList<R> measure(bool quick) {
  ZoneList<R> all;
  for (const ContactProblem& problem : problems(quick)) {
    const auto solution = solve<R>(problem);
    const auto contact = solution->contact().front();
    const R s = numeric::to_real<R>(problem.coupled_friction(0));
    all.push_back({text_of(problem),
                   problem.coupled_friction(0),
                   problem.load(),
                   solution,
                   contact.left.x.value,
                   contact.right.x.value,
                   {end_power<R>(Side::right, Power::vanishing, s), end_power<R>(Side::left, Power::vanishing, s)},
                   equation_error(problem)});
  }
  return all;
}

std::vector<Evidence> check(const Context& context, Once<ZoneList>& once, const ZoneSaid& said) {
  return gather_at_fifty(context, [&]<Real R>() {
    using std::abs, std::sqrt;
    const Quantity ends{"ends of the contact", {"solved", "-(1+2 alpha) a, (1-2 alpha) a"}, tolerance<R>()};
    const Quantity powers{"powers at the ends",
                          {"where the residual of A |x|^p vanishes, by quadrature", "1/2-alpha, 1/2+alpha"},
                          tolerance<R>()};
    const Quantity equation{"equation, solved in double", {"trapezoidal rule", "psi_bar'"}, equation_tolerance};
    const Quantity largest{
        "where |t| is largest: a t'/t", {"differences of the solved traction", "0 at x = -4 alpha a"}, tolerance<R>()};
    Findings findings;
    for (const ZoneFacts<R>& facts : once.at<R>(context.quick, [&] { return measure<R>(context.quick); })) {
      findings.begin_case(facts.name);
      const Exponent angle = said.sign > 0 ? Exponent::angle(facts.s) : -Exponent::angle(facts.s);
      const R alpha = numeric::to_real<R>(angle);
      const R square = numeric::to_real<R>(facts.load * radius) / (2 * numeric::pi<R>());
      const R a = sqrt(R(square / (said.friction_widens ? R(R(1) / 4 - alpha * alpha) : R(R(1) / 4))));
      const R miss = 1 + said.miss_end * R(tolerance<R>());
      findings.compare(ends, relative_difference<R>(facts.left, R(-(1 + 2 * alpha) * a * miss)));
      findings.compare(ends, relative_difference<R>(facts.right, R((1 - 2 * alpha) * a)));
      findings.compare(equation, facts.equation_error);
      const Exponent rear = half - angle;
      const Exponent front = said.same_powers ? rear : half + angle;
      findings.compare(powers, relative_difference<R>(facts.power[0], numeric::to_real<R>(rear)));
      findings.compare(powers, relative_difference<R>(facts.power[1], numeric::to_real<R>(front)));
      const std::size_t end = contact_end(*facts.solution, Side::left);
      const auto t = [&](const R& x) { return traction_beside(*facts.solution, end, Side::right, R(x - facts.left)); };
      const R x = numeric::to_real<R>(said.largest) * alpha * a * (1 + said.miss_largest * R(tolerance<R>()));
      findings.compare(
          largest,
          static_cast<double>(R(abs(derivative<R>(t, x, std::min(R(x - facts.left), R(facts.right - x))) / t(x)) * a)));
      findings.require(
          abs(t(x)) > abs(t(R(x - (x - facts.left) / 10))) && abs(t(x)) > abs(t(R(x + (facts.right - x) / 10))),
          "|t| is not largest there");
      // Towards the rear, which lies on the left for s > 0.
      const R shift = (facts.left + facts.right) / 2;
      findings.require(facts.s > 0 ? x < shift && shift < 0 : x > shift && shift > 0, "nothing is shifted to the rear");
    }
    return findings.evidence("solved parabolas");
  });
}

}  // namespace

Claim figure_parabola() {
  return make_claim(
      claim_text("fig-05-parabola"),
      [once = std::make_shared<Once<ZoneList>>()](const Context& context, const ZoneSaid& said) {
        return check(context, *once, said);
      },
      ZoneSaid{},
      std::vector<Wrong<ZoneSaid>>{
          {"shifted to the front", changed<ZoneSaid>([](ZoneSaid& said) { said.sign = -1; })},
          {"the largest pressure at the contact's centre",
           changed<ZoneSaid>([](ZoneSaid& said) { said.largest = -2; })},
          {"the largest pressure at the vertex", changed<ZoneSaid>([](ZoneSaid& said) { said.largest = 0; })},
          {"the same power at both ends", changed<ZoneSaid>([](ZoneSaid& said) { said.same_powers = true; })},
          {"the frictionless half-width", changed<ZoneSaid>([](ZoneSaid& said) { said.friction_widens = false; })},
          {"near miss: the rear end moved by ten times the tolerance",
           changed<ZoneSaid>([](ZoneSaid& said) { said.miss_end = 10; })},
          {"near miss: the largest pressure's place moved by ten times the tolerance",
           changed<ZoneSaid>([](ZoneSaid& said) { said.miss_largest = 10; })}});
}

}  // namespace steadyslide::proofs_checks
