// The flat punch under friction with one jump [Bal16, (5)-(7)], and with any number of jumps.

#include <algorithm>

#include "proofs_checks/claims/claims.hpp"
#include "proofs_checks/instruments/local_power.hpp"
#include "proofs_checks/instruments/punch.hpp"

namespace steadyslide::proofs_checks {
namespace {

std::vector<ContactProblem> one_jump_grid() {
  std::vector<ContactProblem> problems;
  for (const Rational& nu : {Rational(3, 10), Rational(-9, 10), Rational(499, 1000)}) {
    const std::vector<std::vector<Rational>> pairs{
        {Rational(1, 2), 2}, {2, Rational(1, 2)}, {0, 1}, {2, 0}, {10, Rational(1, 2)}, {1, 50}};
    for (const std::vector<Rational>& f : pairs) problems.push_back(punch(nu, f, {0}, Rational(3, 2)));
  }
  return problems;
}

/// 0, 1, ..., 8 jumps, towards +x and -x, Poisson ratios and friction over their whole ranges. In this order the
/// controls meet two jumps first, and a quick run, which takes every fourth or sixteenth, the cheap ones.
std::vector<ContactProblem> many_jump_grid() {
  const std::vector<Rational> friction{Rational(1, 5), 2,  Rational(1, 2), 0, 50, 1,
                                       Rational(7, 3), 10, Rational(1, 10)};
  const std::vector<Rational> nus{Rational(3, 10), Rational(-9, 10), 0, Rational(499, 1000), Rational(2, 5)};
  std::vector<ContactProblem> problems;
  for (const std::size_t m : {2U, 0U, 5U, 6U, 1U, 4U, 7U, 8U, 3U}) {
    std::vector<Rational> f(friction.begin(), friction.begin() + static_cast<std::ptrdiff_t>(m) + 1);
    std::vector<Rational> jumps;
    for (std::size_t k = 1; k <= m; ++k) {
      const auto position = static_cast<long>(k);
      jumps.push_back(Rational(-1) + Rational(2 * position, static_cast<long>(m) + 1) + Rational(position % 3, 50));
    }
    problems.push_back(punch(nus[m % nus.size()], std::move(f), std::move(jumps), Rational(5, 7),
                             m % 3 == 0 ? Sliding::minus_x : Sliding::plus_x));
  }
  return problems;
}

/// -(P/(pi sqrt(1+s^2(x)))) |x|^beta (1+x)^{-(1/2+alpha_-)} (1-x)^{-(1/2-alpha_+)}.
PunchFormula one_jump_formula() {
  return PunchFormula::from([]<Real R>(const ContactProblem& p) {
    return power_form<R>({-1, 0, 1}, {-(half + alpha(p, 0)), alpha(p, 0) - alpha(p, 1), -(half - alpha(p, 1))},
                         {punch_amplitude<R>(p, 0), punch_amplitude<R>(p, 1)});
  });
}

PunchFormula many_jump_formula() {
  return PunchFormula::from([]<Real R>(const ContactProblem& p) { return punch_form<R>(p); });
}

/// The power and the ratio that the formula has, against those with which the operator's residual vanishes at the jump.
template <Real R>
void check_local_form(Findings& findings, const PowerForm<R>& form, const ContactProblem& problem) {
  using std::abs;
  const Quantity power{"power of the distance to the jump",
                       {"where the residual of A |x|^p vanishes, by quadrature", "beta"},
                       tolerance<R>()};
  const Quantity ratio{"ratio of the amplitudes behind and in front of the jump",
                       {"with which it vanishes, by quadrature", "cos(pi alpha_-)/cos(pi alpha_+)"},
                       tolerance<R>()};
  const Rational left = problem.coupled_friction(0);
  const Rational right = problem.coupled_friction(1);
  findings.decide("beta has the sign of f_- - f_+", form.exponents[1].sign() == sign(left - right));
  const JumpPower<R> measured = jump_power<R>(numeric::to_real<R>(left), numeric::to_real<R>(right));
  findings.compare(power, static_cast<double>(R(abs(measured.power - form.powers[1].value))));
  findings.compare(ratio, relative_difference<R>(measured.ratio, R(form.amplitudes[0] / form.amplitudes[1])));
}

template <Real R>
void check_case(Findings& findings, const PunchFormula& formula, const ContactProblem& problem,
                std::size_t tanh_sinh_points) {
  const PowerForm<R> form = formula.at<R>(problem);
  const auto no_slope = [](const auto& x) { return std::remove_cvref_t<decltype(x)>(0); };
  check_surface(findings, surface_of<R>(form, problem, 0, no_slope), tanh_sinh_points);
  check_surface_by_gsl(findings, surface_of<double>(formula.at<double>(problem), problem, 0, no_slope));
  check_punch_values(findings, form, problem);
  Exponent sum;
  for (const Exponent& exponent : form.exponents) sum += exponent;
  findings.decide("the exponents sum to -1", sum == Exponent(-1));
}

std::vector<Evidence> check_one_jump(const Context& context, const PunchFormula& formula) {
  const auto walk = [&]<Real R>() {
    Cases cases = punch_cases(context, "eq-05-07", one_jump_grid(), count_for(context, 20, 6, 3),
                              [](Random&) { return std::size_t{0}; });
    // The random ones: the jump at 0, as printed.
    Random random(context.seed, "eq-05-07, friction on the other side");
    for (ContactProblem& problem : cases.problems) {
      if (!problem.friction().jumps().empty()) continue;
      problem =
          punch(problem.elasticity().half_space()->poisson(),
                {problem.friction().values()[0], random.friction(largest_friction(context))}, {0}, problem.load());
    }
    Findings findings;
    for (const ContactProblem& problem : cases.problems) {
      findings.begin_case(text_of(problem), has_jump(problem));
      check_case<R>(findings, formula, problem, count_for(context, 6, 3, 2));
      check_local_form(findings, formula.at<R>(problem), problem);
    }
    return findings.evidence(cases.detail);
  };
  return gather([&] { return numeric::at_precision(context.digits, walk); });
}

std::vector<Evidence> check_many_jumps(const Context& context, const PunchFormula& formula) {
  const auto walk = [&]<Real R>() {
    const Cases cases = punch_cases(context, "n-jump-punch", many_jump_grid(), count_for(context, 20, 6, 2),
                                    [&](Random& random) { return 1 + random.below(count_for(context, 8, 4, 3)); });
    Findings findings;
    for (const ContactProblem& problem : cases.problems) {
      findings.begin_case(text_of(problem), has_jump(problem));
      check_case<R>(findings, formula, problem, count_for(context, 10, 3, 2));
    }
    return findings.evidence(cases.detail);
  };
  return gather([&] { return numeric::at_precision(context.digits, walk); });
}

Claim one_jump() {
  const PunchFormula right = one_jump_formula();
  return make_claim(
      claim_text("eq-05-07-friction-jump"), check_one_jump, right,
      std::vector<Wrong<PunchFormula>>{
          {"beta = alpha_+ - alpha_-",
           right.changed([](auto& form, const ContactProblem& p) { form.set_exponent(1, alpha(p, 1) - alpha(p, 0)); })},
          {"the printed (1+x)^{1/2} instead of (1+x)^{1/2+alpha_-}",
           right.changed([](auto& form, const ContactProblem&) { form.set_exponent(0, -half); })},
          {"the front's angle at the rear edge",
           right.changed([](auto& form, const ContactProblem& p) { form.set_exponent(0, -(half + alpha(p, 1))); })},
          {"the rear's angle at the front edge",
           right.changed([](auto& form, const ContactProblem& p) { form.set_exponent(2, -(half - alpha(p, 0))); })},
          {"alpha_- and alpha_+ exchanged everywhere in the powers",
           right.changed([](auto& form, const ContactProblem& p) {
             form.set_exponent(0, -(half + alpha(p, 1)));
             form.set_exponent(1, alpha(p, 1) - alpha(p, 0));
             form.set_exponent(2, -(half - alpha(p, 0)));
           })},
          {"1/sqrt(1+gamma^2 f^2) of the wrong side",
           right.changed([](auto& form, const ContactProblem&) { std::swap(form.amplitudes[0], form.amplitudes[1]); })},
          {"1/sqrt(1+gamma^2 f^2) missing", right.changed([]<Real R>(PowerForm<R>& form, const ContactProblem& p) {
             for (R& amplitude : form.amplitudes) amplitude = -numeric::to_real<R>(p.load()) / numeric::pi<R>();
           })},
          {"near miss: beta moved by ten times the tolerance",
           right.changed(
               []<Real R>(PowerForm<R>& form, const ContactProblem&) { form.move_power(1, near_miss<R>()); })},
          {"near miss: the amplitude in front moved by ten times the tolerance",
           right.changed(
               []<Real R>(PowerForm<R>& form, const ContactProblem&) { form.amplitudes[1] *= 1 + near_miss<R>(); })}});
}

Claim many_jumps() {
  const PunchFormula right = many_jump_formula();
  return make_claim(
      claim_text("n-jump-punch"), check_many_jumps, right,
      std::vector<Wrong<PunchFormula>>{
          {"the exponent of one jump missing",
           right.changed([](auto& form, const ContactProblem&) { form.set_exponent(1, Exponent(0)); })},
          {"the exponents of two jumps exchanged", right.changed([](auto& form, const ContactProblem&) {
             if (form.exponents.size() < 4) return;
             const Exponent first = form.exponents[1];
             form.set_exponent(1, form.exponents[2]);
             form.set_exponent(2, first);
           })},
          {"a jump shifted by 1/50", right.changed([](auto& form, const ContactProblem&) {
             if (form.lengths.size() < 2) return;
             form.lengths[0] += form.lengths[0] / 50;
             form.lengths[1] -= form.lengths[0] / 51;
           })},
          {"the friction read from the front to the rear", right.changed([](auto& form, const ContactProblem& p) {
             const std::size_t m = p.friction().jumps().size();
             form.set_exponent(0, -(half + alpha(p, m)));
             for (std::size_t k = 1; k <= m; ++k) form.set_exponent(k, alpha(p, m + 1 - k) - alpha(p, m - k));
             form.set_exponent(m + 1, -(half - alpha(p, 0)));
             std::ranges::reverse(form.amplitudes);
           })},
          {"one amplitude on all panels", right.changed([](auto& form, const ContactProblem&) {
             for (auto& amplitude : form.amplitudes) amplitude = form.amplitudes[0];
           })},
          {"the other direction of sliding: alpha of the other sign",
           right.changed([](auto& form, const ContactProblem& p) {
             const std::size_t m = p.friction().jumps().size();
             form.set_exponent(0, -(half - alpha(p, 0)));
             for (std::size_t k = 1; k <= m; ++k) form.set_exponent(k, alpha(p, k) - alpha(p, k - 1));
             form.set_exponent(m + 1, -(half + alpha(p, m)));
           })},
          {"near miss: one jump's exponent moved by ten times the tolerance",
           right.changed(
               []<Real R>(PowerForm<R>& form, const ContactProblem&) { form.move_power(1, near_miss<R>()); })},
          {"near miss: the amplitude moved by ten times the tolerance",
           right.changed([]<Real R>(PowerForm<R>& form, const ContactProblem&) { form.scale(1 + near_miss<R>()); })}});
}

}  // namespace

std::vector<Claim> friction_jump_claims() { return {one_jump(), many_jumps()}; }

}  // namespace steadyslide::proofs_checks
