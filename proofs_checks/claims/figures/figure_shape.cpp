// The flat punch under a friction jump at its middle: the shape of its pressure. [Bal16, figure 4, (5)-(7)]

#include "proofs_checks/claims/figures/figures.hpp"
#include "proofs_checks/instruments/local_power.hpp"
#include "proofs_checks/instruments/near.hpp"
#include "proofs_checks/instruments/punch.hpp"

namespace steadyslide::proofs_checks {
namespace {

ContactProblem two_coatings(const Rational& s_rear, const Rational& s_front) {
  return {Elasticity::reduced(Rational(1, 2)), FrictionProfile({2 * s_rear, 2 * s_front}, {0}),
          Indenter(-1, {{1, Polynomial()}}), 1};
}

std::vector<ContactProblem> problems(bool quick) {
  const Rational low(1, 10);
  const Rational high(3, 5);
  // The last has both roots in front of the jump.
  std::vector<ContactProblem> all{two_coatings(low, high), two_coatings(high, low), two_coatings(3, Rational(7, 5))};
  if (quick) return all;
  all.push_back(two_coatings(0, 2));
  all.push_back(two_coatings(2, 0));
  all.push_back(two_coatings(Rational(7, 5), 3));
  all.push_back(two_coatings(20, 15));
  return all;
}

template <class R>
struct ShapeFacts {
  std::string name;
  Rational s[2];
  Solved<R> solution;
  R power;                ///< of |x|, that the operator asks for
  double equation_error;  ///< of the solution in double
  std::size_t turns[2];   ///< changes of the sense of t on each half, on a grid
};
template <class R>
using ShapeList = std::vector<ShapeFacts<R>>;

struct ShapeSaid {
  int beta_sign = 1;
  bool sum = true;  ///< alpha_- + alpha_+ in the quadratic
  bool falling_monotone = false;
  int miss = 0;
};

/// t on the half of x, by the distance to the jump.
template <Real R>
R traction_at(const numeric::RiemannHilbertSolution<R>& solution, const R& x) {
  const std::size_t jump = point_at(solution, Rational(0));
  return x < 0 ? traction_beside(solution, jump, Side::left, R(-x)) : traction_beside(solution, jump, Side::right, x);
}

template <Real R>
ShapeList<R> measure(bool quick) {
  using std::sin;
  ShapeList<R> all;
  for (const ContactProblem& problem : problems(quick)) {
    const Rational rear = problem.coupled_friction(0);
    const Rational front = problem.coupled_friction(1);
    ShapeFacts<R> facts{
        text_of(problem),        {rear, front},
        solve<R>(problem),       jump_power<R>(numeric::to_real<R>(rear), numeric::to_real<R>(front)).power,
        equation_error(problem), {}};
    for (const std::size_t i : {0U, 1U}) {
      constexpr int points = 100;
      int sense = 0;
      R before = 0;
      for (int k = 1; k < points; ++k) {
        // Denser towards the jump and the edge: an extreme may lie close to either.
        const R sine = sin(R(numeric::pi<R>() * k / (2 * points)));
        const R x = sine * sine;
        const R t = traction_at(*facts.solution, i == 0 ? R(-x) : x);
        const int now = t > before ? 1 : -1;
        if (k > 2 && now != sense) ++facts.turns[i];
        sense = now;
        before = t;
      }
    }
    all.push_back(std::move(facts));
  }
  return all;
}

/// The roots of x^2 - (alpha_- + alpha_+) x + beta in ]-1, 1[ other than 0.
template <Real R>
std::vector<R> extremes(const Rational (&s)[2], const ShapeSaid& said) {
  using std::sqrt;
  const Exponent rear = Exponent::angle(s[0]);
  const Exponent front = Exponent::angle(s[1]);
  const R sum = numeric::to_real<R>(said.sum ? rear + front : rear - front);
  const R beta = said.beta_sign * numeric::to_real<R>(rear - front);
  const R square = sum * sum - 4 * beta;
  if (square < 0 || (said.falling_monotone && beta > 0)) return {};
  const R moved = 1 + said.miss * R(tolerance<R>());
  return {R((sum - sqrt(square)) / 2 * moved), R((sum + sqrt(square)) / 2 * moved)};
}

std::vector<Evidence> check(const Context& context, Once<ShapeList>& once, const ShapeSaid& said) {
  return gather_at_fifty(context, [&]<Real R>() {
    using std::abs;
    const Quantity power{"power at the jump",
                         {"where the residual of A |x|^p vanishes, by quadrature", "alpha_- - alpha_+"},
                         tolerance<R>()};
    const Quantity equation{"equation, solved in double", {"trapezoidal rule", "0"}, equation_tolerance};
    const Quantity extreme{"extremes of |t|: t'/t",
                           {"differences of the solved traction", "0 at x^2 - (alpha_- + alpha_+) x + beta = 0"},
                           tolerance<R>(),
                           0.1};
    const Quantity number{"number of extremes on each half (differences)", {"100 values of t", "roots"}, 0};
    Findings findings;
    for (const ShapeFacts<R>& facts : once.at<R>(context.quick, [&] { return measure<R>(context.quick); })) {
      findings.begin_case(facts.name);
      const Exponent beta = Exponent::angle(facts.s[0]) - Exponent::angle(facts.s[1]);
      const bool rises = facts.s[1] > facts.s[0];
      findings.decide(rises ? "f_- < f_+: the power at the jump is negative" : "f_- > f_+: it is positive",
                      said.beta_sign * beta.sign() == (rises ? -1 : 1));
      findings.compare(power, relative_difference<R>(facts.power, R(said.beta_sign * numeric::to_real<R>(beta))));
      findings.compare(equation, facts.equation_error);
      const auto t = [&](const R& x) { return traction_at(*facts.solution, x); };
      std::size_t roots[2] = {0, 0};
      for (const R& x : extremes<R>(facts.s, said)) {
        findings.require(abs(x) < 1, "an extreme outside of the punch");
        ++roots[x < 0 ? 0 : 1];
        findings.compare(extreme, static_cast<double>(
                                      R(abs(derivative<R>(t, x, std::min(R(abs(x)), R(1 - abs(x)))) / t(x)) * abs(x))));
      }
      for (const std::size_t i : {0U, 1U}) findings.compare(number, roots[i] == facts.turns[i] ? 0 : 1);
    }
    return findings.evidence("solved flat punches");
  });
}

}  // namespace

Claim figure_shape() {
  return make_claim(
      claim_text("fig-04-shape"),
      [once = std::make_shared<Once<ShapeList>>()](const Context& context, const ShapeSaid& said) {
        return check(context, *once, said);
      },
      ShapeSaid{},
      std::vector<Wrong<ShapeSaid>>{
          {"the figures exchanged: beta's sign", changed<ShapeSaid>([](ShapeSaid& said) { said.beta_sign = -1; })},
          {"alpha_- - alpha_+ in the middle term", changed<ShapeSaid>([](ShapeSaid& said) { said.sum = false; })},
          {"no extreme ever for f_- > f_+", changed<ShapeSaid>([](ShapeSaid& said) { said.falling_monotone = true; })},
          {"near miss: the extremes moved by ten times the tolerance",
           changed<ShapeSaid>([](ShapeSaid& said) { said.miss = 10; })}});
}

}  // namespace steadyslide::proofs_checks
