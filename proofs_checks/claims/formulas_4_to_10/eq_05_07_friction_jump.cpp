#include "proofs_checks/instruments/operators/local_power.hpp"
#include "proofs_checks/instruments/tractions/punch.hpp"
#include "proofs_checks/kit/claim_builder.hpp"

namespace steadyslide::proofs_checks::eq_05_07_friction_jump {
namespace {

CaseList<ContactProblem> punches(const Context& context) {
  std::vector<ContactProblem> grid;
  for (const Rational& nu : {Rational(3, 10), Rational(-9, 10), Rational(499, 1000)}) {
    const std::vector<std::vector<Rational>> pairs{
        {Rational(1, 2), 2}, {2, Rational(1, 2)}, {0, 1}, {2, 0}, {10, Rational(1, 2)}, {1, 50}};
    for (const std::vector<Rational>& f : pairs) grid.push_back(punch(nu, f, {0}, Rational(3, 2)));
  }
  Random front(context.seed, "eq-05-07, friction on the other side");
  return grid_and_random(context, "eq-05-07", grid, {20, 6, 3}, [&](Random& random) {
    const ContactProblem rear = random_punch(context, random, 0);
    return punch(rear.elasticity().half_space()->poisson(),
                 {rear.friction().values()[0], front.friction(largest_friction(context))}, {0}, rear.load());
  });
}

/// Compares the power and the ratio of the formula with those for which the operator's residual vanishes at the jump.
template <Real R>
void check_at_the_jump(Findings& findings, const PowerProduct& t, const ContactProblem& problem) {
  using std::abs;
  const Rational rear = problem.coupled_friction(0);
  const Rational front = problem.coupled_friction(1);
  const JumpPower<R> measured = jump_power<R>(to_real<R>(rear), to_real<R>(front));
  const PowerForm<R> form = t.at<R>();
  findings.compare("power", R(abs(measured.power - form.powers[1].value)));
  findings.compare<R>("ratio", measured.ratio, form.amplitudes[0] / form.amplitudes[1]);
  findings.decide("`beta` has the sign of `f_- - f_+`", t.exponents[1].sign() == sign(rear - front));
}

}  // namespace

Claim claim() {
  return formula_claim<ContactProblem, PowerProduct>("eq-05-07-friction-jump")
      .cases(punches)
      .effective_where(has_jump)
      .says([](const ContactProblem& p) {
        return PowerProduct::on({-1, 0, 1}, {-(half + alpha(p, 0)), alpha(p, 0) - alpha(p, 1), -(half - alpha(p, 1))},
                                {punch_amplitude<Number>(p, 0), punch_amplitude<Number>(p, 1)});
      })
      .checked([]<Real R>(Findings& findings, const PowerProduct& t, const ContactProblem& p, const Context& context) {
        check_punch_traction<R>(findings, t, p, count_for(context, {6, 3, 2}));
        check_at_the_jump<R>(findings, t, p);
      })
      .wrong("`beta = alpha_+ - alpha_-`", [](PowerProduct& t) { t.exponents[1] = -t.exponents[1]; })
      .wrong("the printed `(1+x)^{1/2}` instead of `(1+x)^{1/2+alpha_-}`",
             [](PowerProduct& t) { t.exponents[0] = -half; })
      .wrong("the front's angle at the rear edge",
             [](PowerProduct& t, const ContactProblem& p) { t.exponents[0] = -(half + alpha(p, 1)); })
      .wrong("the rear's angle at the front edge",
             [](PowerProduct& t, const ContactProblem& p) { t.exponents[2] = -(half - alpha(p, 0)); })
      .wrong("`alpha_-` and `alpha_+` exchanged everywhere in the powers",
             [](PowerProduct& t, const ContactProblem& p) {
               t.exponents = punch_powers({alpha(p, 1), alpha(p, 0)});
             })
      .wrong("`1/sqrt(1+gamma^2 f^2)` of the wrong side", [](PowerProduct& t) { std::ranges::reverse(t.amplitudes); })
      .wrong("`1/sqrt(1+gamma^2 f^2)` missing",
             [](PowerProduct& t, const ContactProblem& p) {
               std::ranges::fill(t.amplitudes, Number(-to_real<Number>(p.load()) / numeric::pi<Number>()));
             })
      .near_miss("`beta`", [](PowerProduct& t, const Number& step) { t.move_power(1, step); })
      .near_miss("the amplitude in front", [](PowerProduct& t, const Number& step) { t.amplitudes[1] *= 1 + step; });
}

}  // namespace steadyslide::proofs_checks::eq_05_07_friction_jump
