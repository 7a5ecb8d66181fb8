// Measures gaps over a notch at three loads below the load that closes it, because the law l = (K (P_c - P))^n has
// three unknowns.

#include "numeric/quadrature/tanh_sinh.hpp"
#include "proofs_checks/instruments/solutions/local_behaviour.hpp"
#include "proofs_checks/instruments/tractions/punch.hpp"
#include "proofs_checks/kit/claim_builder.hpp"

namespace steadyslide::proofs_checks::notch_gap_law {
namespace {

/// Two flanks that meet at a friction jump, `at`.
struct Notch {
  std::string name;
  ContactProblem problem;
  std::size_t at;  ///< index of the jump
  std::vector<Rational> loads;

  const Rational& place() const { return problem.friction().jumps()[at]; }
  Rational slope(Side side) const { return problem.indenter().profile(place(), side).coefficient(1); }
};

/// Returns flanks of slopes `rear` and `front` that meet at this point.
ContactProblem flanks(const Rational& nu, FrictionProfile friction, const Rational& place, const Rational& rear,
                      const Rational& front, Sliding sliding = Sliding::plus_x) {
  const Indenter indenter(-1, {{place, Polynomial({-rear * place, rear})}, {1, Polynomial({-front * place, front})}});
  return {Elasticity(Solid(nu, 1)), std::move(friction), indenter, 1, sliding};
}

CaseList<Notch> notches(const Context& context) {
  const Rational tenth(1, 10), quarter(1, 4), fifth(1, 5);
  const FrictionProfile rise({tenth, Rational(1, 2)}, {0});
  const FrictionProfile fall({Rational(3, 5), tenth}, {-quarter});
  const FrictionProfile both({Rational(3, 10), tenth, Rational(7, 10)}, {Rational(-1, 2), quarter});
  return first_when_quick<Notch>(
      context,
      {{"0.1 | 0.5, flanks of 1/5", flanks(fifth, rise, 0, fifth, -fifth), 0, {Rational(17, 5), Rational(37, 10), 4}},
       {"0.6 | 0.1 towards -x, flanks of 1/5 and 1/10",
        flanks(0, fall, -quarter, fifth, -tenth, Sliding::minus_x),
        0,
        {Rational(3, 2), Rational(8, 5), Rational(17, 10)}},
       {"0.3 | 0.1 | 0.7, flanks of 1/10 and 1/4",
        flanks(Rational(3, 10), both, quarter, tenth, -quarter),
        1,
        {Rational(27, 10), Rational(29, 10), Rational(31, 10)}}},
      1, "notches, three loads each");
}

/// Returns the length of the gap behind the notch, in the solver's unit, which is the same for all loads.
double gap_behind(const Notch& notch, const Rational& load) {
  const auto solution = solve<double>(notch.problem.with_load(load));
  const std::size_t point = point_at(*solution, notch.place());
  if (in_contact(*solution, point, Side::left)) throw Refutation{{notch.name, "no gap at the load " + to_string(load)}};
  return solution->form().set().length(point - 1);
}

Values measured(const Notch& notch) {
  std::vector<double> load, gap;
  for (const Rational& p : notch.loads) {
    load.push_back(to_real<double>(p));
    gap.push_back(gap_behind(notch, p));
  }
  const double ratio = std::log(gap[0] / gap[1]) / std::log(gap[1] / gap[2]);
  // log((P_c-P_0)/(P_c-P_1))/log((P_c-P_1)/(P_c-P_2)) grows with P_c and is 0 at P_c = P_2.
  double low = load[2];
  double high = 4 * load[2];
  for (int step = 0; step < 100; ++step) {
    const double middle = (low + high) / 2;
    const double found =
        std::log((middle - load[0]) / (middle - load[1])) / std::log((middle - load[1]) / (middle - load[2]));
    (found < ratio ? low : high) = middle;
  }
  const double power = std::log(gap[0] / gap[2]) / std::log((low - load[0]) / (low - load[2]));
  return {{"threshold", low}, {"exponent", power}};
}

/// Factors of the parts of the formula for P_c.
struct Law {
  int integral = 1;
  int sum = 1;
  int from = 1;  ///< 1: the integral over the part in front of the notch, -1: behind it
};

Number threshold(const Notch& notch, const Law& law) {
  using R = numeric::Real50;
  const ContactProblem& problem = notch.problem;
  PowerProduct form = punch_traction(problem.with_indenter(Indenter(-1, {{1, Polynomial()}})));
  const std::vector<Exponent> powers = form.exponents;
  const std::vector<R> points = form.at<R>().points();
  R sum = 0;
  for (std::size_t j = 0; j < points.size(); ++j) sum += to_real<R>(powers[j]) * points[j];
  // The integrand is cos(pi alpha)/(|Y| |x-c|).
  for (Exponent& power : form.exponents) power = -power;
  const std::size_t c = notch.at + 1;
  form.exponents[c] -= Exponent(1);
  for (std::size_t k = 0; k < form.amplitudes.size(); ++k)
    form.amplitudes[k] = cos_pi_alpha<Number>(problem.coupled_friction(k));
  const auto density = form.at<R>().traction().density();
  R integral = 0;
  const bool front = law.from > 0;
  for (std::size_t k = front ? c : 0; k < (front ? density.size() : c); ++k)
    integral += numeric::tanh_sinh::panel_integral<R>(density[k]).value;
  const Rational rear = notch.slope(Side::left);
  const R reduced = numeric::pi<R>() * to_real<R>(rear) * (points[c] + law.sum * sum) +
                    law.integral * to_real<R>(rear - notch.slope(Side::right)) * integral;
  return Number(reduced / to_real<R>(problem.elasticity().compliance()));
}

Values predicted(const Notch& notch) {
  const auto beta = to_real<Number>(alpha(notch.problem, notch.at) - alpha(notch.problem, notch.at + 1));
  return {{"threshold", threshold(notch, {})}, {"exponent", Number(-1 / beta)}};
}

}  // namespace

Claim claim() {
  return compared<Notch>("notch-gap-law")
      .cases(notches)
      .precision(Precision::in_double)
      .measured(measured)
      .predicted(predicted)
      .wrong("the slope behind the notch alone",
             [](Values& p, const Notch& c) { p.set("threshold", threshold(c, {.integral = 0})); })
      .wrong("`sigma_1` of the other sign",
             [](Values& p, const Notch& c) { p.set("threshold", threshold(c, {.sum = -1})); })
      .wrong("the integral over what is behind the notch",
             [](Values& p, const Notch& c) { p.set("threshold", threshold(c, {.from = -1})); })
      .wrong("a gap that closes like `1 - P/P_c`", replaced({{"exponent", Number(1)}}))
      .wrong("like its square root, as where ends meet without friction jump", replaced({{"exponent", Number(1) / 2}}))
      .near_misses();
}

}  // namespace steadyslide::proofs_checks::notch_gap_law
