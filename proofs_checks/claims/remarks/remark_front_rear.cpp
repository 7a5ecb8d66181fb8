// When front and rear have different powers, and when a friction jump is singular. [Bal16, remark 1]

#include "proofs_checks/claims/remarks/remarks.hpp"
#include "proofs_checks/instruments/local_power.hpp"
#include "proofs_checks/instruments/near.hpp"
#include "proofs_checks/kit/random.hpp"

namespace steadyslide::proofs_checks {
namespace {

/// gamma given as it is: it vanishes for no rigid indenter.
ContactProblem reduced_problem(const Rational& gamma, std::vector<Rational> f, const Polynomial& profile) {
  std::vector<Rational> jumps;
  if (f.size() > 1) jumps.emplace_back(-1, 8);
  return {Elasticity::reduced(gamma), FrictionProfile(std::move(f), std::move(jumps)), Indenter(-1, {{1, profile}}), 1};
}

struct PowersCase {
  std::string name;
  ContactProblem problem;
};

std::vector<PowersCase> cases(bool quick) {
  const Rational gamma(2, 7);
  const Polynomial flat;
  const Polynomial parabola({0, 0, 1});
  std::vector<PowersCase> all{{"flat punch", reduced_problem(gamma, {Rational(3, 2)}, flat)},
                              {"flat punch, gamma = 0", reduced_problem(0, {Rational(3, 2)}, flat)},
                              {"flat punch, f = 0", reduced_problem(gamma, {0}, flat)},
                              {"parabola, f jumps", reduced_problem(gamma, {Rational(1, 2), 3}, parabola)},
                              {"parabola, f jumps, gamma = 0", reduced_problem(0, {Rational(1, 2), 3}, parabola)}};
  if (quick) return all;
  all.push_back({"parabola", reduced_problem(gamma, {2}, parabola)});
  all.push_back({"parabola, gamma = 0", reduced_problem(0, {2}, parabola)});
  all.push_back({"flat punch, gamma < 0", reduced_problem(-gamma, {2}, flat)});
  return all;
}

template <class R>
struct MeasuredPowers {
  std::string name;
  Rational gamma;
  std::vector<Rational> f;
  R rear;
  R front;
  R jump;                 ///< where f jumps
  double equation_error;  ///< of the solution in double
};
template <class R>
using PowersList = std::vector<MeasuredPowers<R>>;

/// When two things differ.
struct PowersSaid {
  bool needs_gamma = true;
  bool needs_friction = true;
  bool never = false;
  int front_sign = 1;
  int miss = 0;
};

template <Real R>
PowersList<R> measure(bool quick) {
  PowersList<R> all;
  for (const PowersCase& c : cases(quick)) {
    const R gamma = numeric::to_real<R>(c.problem.elasticity().gamma());
    const R s_rear = gamma * numeric::to_real<R>(c.problem.friction().values().front());
    const R s_front = gamma * numeric::to_real<R>(c.problem.friction().values().back());
    // A flat punch has edges, a parabola free ends.
    const Power power =
        c.problem.indenter().pieces().front().profile.degree() > 0 ? Power::vanishing : Power::unbounded;
    all.push_back({c.name, c.problem.elasticity().gamma(), c.problem.friction().values(),
                   end_power<R>(Side::right, power, s_rear), end_power<R>(Side::left, power, s_front),
                   jump_power<R>(s_rear, s_front).power, equation_error(c.problem)});
  }
  return all;
}

/// Said to differ from 0: a difference that f and gamma make.
bool differs(const Rational& gamma, const Rational& friction, const PowersSaid& said) {
  return !said.never && (gamma != 0 || !said.needs_gamma) && (friction != 0 || !said.needs_friction);
}

void check_exactly(Findings& findings, const Rational& gamma, const Rational& f_rear, const Rational& f_front,
                   const PowersSaid& said) {
  const Exponent rear = edge_exponent(End::left, gamma * f_rear);
  const Exponent front = edge_exponent(End::right, gamma * f_rear);
  const Exponent minus = front - rear;
  findings.decide("the powers of front and rear edge differ by 2 alpha",
                  minus == Exponent::angle(gamma * f_rear) + Exponent::angle(gamma * f_rear));
  findings.decide("free ends: by 2 alpha as well",
                  free_exponent(End::right, gamma * f_rear) - free_exponent(End::left, gamma * f_rear) == minus);
  findings.decide("they differ exactly if gamma f != 0", (minus.sign() != 0) == differs(gamma, f_rear, said));
  findings.decide("the rear edge is the stronger singularity exactly if gamma f > 0",
                  (minus.sign() > 0) == (said.front_sign * gamma * f_rear > 0));
  const Exponent beta = jump_exponent(gamma * f_rear, gamma * f_front);
  findings.decide("a jump of f is singular exactly if gamma != 0",
                  (beta.sign() != 0) == differs(gamma, f_front - f_rear, said));
}

std::vector<Evidence> check(const Context& context, Once<PowersList>& once, const PowersSaid& said) {
  return gather_at_fifty(context, [&]<Real R>() {
    const std::string route = "where the residual of A |x|^p vanishes, by quadrature";
    const Quantity ends{"power at the front less power at the rear", {route, "2 alpha"}, tolerance<R>()};
    const Quantity jump{"power at a friction jump", {route, "alpha_- - alpha_+"}, tolerance<R>()};
    const Quantity equation{
        "equation, solved in double with these powers", {"trapezoidal rule", "psi_bar'"}, equation_tolerance};
    Findings findings;
    for (const MeasuredPowers<R>& found : once.at<R>(context.quick, [&] { return measure<R>(context.quick); })) {
      findings.begin_case(found.name);
      const Rational& first = found.f.front();
      const Rational& last = found.f.back();
      check_exactly(findings, found.gamma, first, last, said);
      using std::abs;
      const R sum = numeric::to_real<R>(Exponent::angle(found.gamma * first) + Exponent::angle(found.gamma * last)) *
                    (1 + said.miss * R(tolerance<R>()));
      findings.compare(ends, static_cast<double>(R(abs(found.front - found.rear - sum))));
      findings.compare(equation, found.equation_error);
      if (first == last) continue;
      const R beta = numeric::to_real<R>(jump_exponent(found.gamma * first, found.gamma * last));
      findings.compare(jump, static_cast<double>(R(abs(found.jump - beta))));
    }
    Random random(context.seed, "rem-01-front-rear");
    const std::size_t count = context.quick ? 10 : 100;
    for (std::size_t k = 0; k < count; ++k) {
      const Rational gamma = random.between(-1, 1);
      findings.begin_case("random");
      const Rational f = random.friction(50);
      check_exactly(findings, gamma, f, random.friction(50), said);
    }
    return findings.evidence("solved problems and their powers, " + std::to_string(count) +
                             " random exponents with seed " + std::to_string(context.seed));
  });
}

}  // namespace

Claim remark_front_rear() {
  return make_claim(
      claim_text("rem-01-front-rear"),
      [once = std::make_shared<Once<PowersList>>()](const Context& context, const PowersSaid& said) {
        return check(context, *once, said);
      },
      PowersSaid{},
      std::vector<Wrong<PowersSaid>>{
          {"they differ whenever there is friction, gamma = 0 included",
           changed<PowersSaid>([](PowersSaid& said) { said.needs_gamma = false; })},
          {"they differ without friction", changed<PowersSaid>([](PowersSaid& said) { said.needs_friction = false; })},
          {"they never differ", changed<PowersSaid>([](PowersSaid& said) { said.never = true; })},
          {"the front is the stronger one for gamma f > 0",
           changed<PowersSaid>([](PowersSaid& said) { said.front_sign = -1; })},
          {"near miss: 2 alpha moved by ten times the tolerance",
           changed<PowersSaid>([](PowersSaid& said) { said.miss = 10; })}});
}

}  // namespace steadyslide::proofs_checks
