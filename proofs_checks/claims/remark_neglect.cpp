// What is lost by neglecting the influence of friction on the pressure. [Bal16, remark 1]

#include "proofs_checks/claims/local_power.hpp"
#include "proofs_checks/claims/near.hpp"
#include "proofs_checks/claims/punch.hpp"
#include "proofs_checks/claims/remarks.hpp"
#include "proofs_checks/rate.hpp"

namespace steadyslide::proofs_checks {
namespace {

/// gamma = 1, as good as: s is f times a number of the data.
ContactProblem with_s(std::vector<Rational> s, const Indenter& indenter, std::vector<Rational> jumps = {}) {
  for (Rational& value : s) value *= 2;
  return {Elasticity::reduced(Rational(1, 2)), FrictionProfile(std::move(s), std::move(jumps)), indenter, 1};
}

template <class R>
struct Smooth {
  Rational s;
  R peak;    ///< over the frictionless one
  R centre;  ///< over the half-width
  R width;   ///< over the frictionless one
  R middle;  ///< t at the frictionless centre, over the frictionless one there
};
template <class R>
struct Rough {
  std::string name;
  Exponent neglected;  ///< power of t over the frictionless t, neglecting friction's influence: none
  Exponent expected;
  R found;                ///< the power that the operator asks for
  double equation_error;  ///< of the solution in double
};
template <class R>
struct NeglectFacts {
  std::vector<Smooth<R>> smooth;
  std::vector<Rough<R>> rough;
};

struct NeglectSaid {
  int peak_rate = 2;
  int centre_rate = 1;
  int angle_sign = 1;
  bool exponents_change = true;
  int miss = 0;
};

/// A parabola: t at -4 alpha a, alpha from s.
template <Real R>
Smooth<R> smooth(const Rational& s, const numeric::RiemannHilbertSolution<R>& frictionless) {
  const Indenter parabola(-2, {{2, Polynomial({0, 0, Rational(1, 2)})}});
  const auto solution = solve<R>(with_s({s}, parabola));
  const auto ends = solution->contact().front();
  const auto zero = frictionless.contact().front();
  const R centre = (ends.left.x.value + ends.right.x.value) / 2;
  const R width = (ends.right.x.value - ends.left.x.value) / 2;
  const R zero_width = (zero.right.x.value - zero.left.x.value) / 2;
  const std::size_t left = contact_end(*solution, Side::left);
  const std::size_t zero_left = contact_end(frictionless, Side::left);
  const R peak = traction_beside(*solution, left, Side::right, R(2 * centre - ends.left.x.value));
  const R zero_peak = traction_beside(frictionless, zero_left, Side::right, zero_width);
  return {s, R(peak / zero_peak), R(centre / width), R(width / zero_width),
          R(traction_beside(*solution, left, Side::right, R(-ends.left.x.value)) / zero_peak)};
}

template <Real R>
NeglectFacts<R> measure(bool quick) {
  NeglectFacts<R> facts;
  const Indenter parabola(-2, {{2, Polynomial({0, 0, Rational(1, 2)})}});
  const auto zero = solve<R>(with_s({0}, parabola));
  std::vector<Rational> values{Rational(1, 10), Rational(1, 2)};
  if (!quick) values.insert(values.end(), {Rational(1, 20), Rational(3, 4), 2});
  for (const int exponent : {-4, -6, -8}) values.push_back(parse_rational("1e" + std::to_string(exponent)));
  for (const Rational& s : values) facts.smooth.push_back(smooth<R>(s, *zero));

  const Indenter flat(-1, {{1, Polynomial()}});
  const Rational s(2, 5);
  const Exponent none;
  const R behind = numeric::to_real<R>(s);
  const double punch = equation_error(with_s({s}, flat));
  const Exponent edge(Rational(-1, 2));
  facts.rough.push_back(
      {"rear edge", edge, -(half + Exponent::angle(s)), end_power<R>(Side::right, Power::unbounded, behind), punch});
  facts.rough.push_back(
      {"front edge", edge, -(half - Exponent::angle(s)), end_power<R>(Side::left, Power::unbounded, behind), punch});
  facts.rough.push_back({"friction jump", none, Exponent::angle(s) - Exponent::angle(1),
                         jump_power<R>(behind, R(1)).power,
                         equation_error(with_s({s, 1}, parabola, {Rational(1, 8)}))});
  return facts;
}

template <Real R>
void check_smooth(Findings& findings, const std::vector<Smooth<R>>& all, const NeglectSaid& said) {
  using std::abs, std::pow, std::sqrt;
  const Quantity peak{"largest pressure under a parabola over the frictionless one",
                      {"solved problems", "cos(pi alpha) ((1+2 alpha)/(1-2 alpha))^alpha"},
                      tolerance<R>()};
  const Quantity centre{"centre of the contact over its half-width", {"solved problems", "-2 alpha"}, tolerance<R>()};
  const Quantity width{"width over the frictionless one", {"solved problems", "1/sqrt(1-4 alpha^2)"}, tolerance<R>()};
  std::vector<Level> peaks, centres, middles;
  for (const Smooth<R>& one : all) {
    findings.begin_case("s = " + to_string(one.s));
    const R alpha = said.angle_sign * numeric::to_real<R>(Exponent::angle(one.s));
    const R miss = 1 + said.miss * R(tolerance<R>());
    const R ratio = numeric::cos_pi_alpha<R>(one.s) * pow(R((1 + 2 * alpha) / (1 - 2 * alpha)), alpha);
    findings.compare(centre, relative_difference<R>(one.centre, R(-2 * alpha)));
    findings.compare(peak, relative_difference<R>(one.peak, R(ratio * miss)));
    findings.compare(width, relative_difference<R>(one.width, R(1 / sqrt(R(1 - 4 * alpha * alpha)))));
    if (abs(one.s) > Rational(1, 1000)) continue;
    const auto inverse = numeric::to_real<double>(Rational(1 / one.s));
    peaks.push_back({inverse, static_cast<double>(R(1 - one.peak))});
    centres.push_back({inverse, static_cast<double>(R(abs(one.centre)))});
    middles.push_back({inverse, static_cast<double>(R(abs(one.middle - 1)))});
  }
  findings.begin_case("s -> 0");
  const auto order = [&](const std::string& what, const std::vector<Level>& levels, double expected) {
    const Rate rate = fitted_rate(levels);
    findings.measure({what, rate.value, rate.error_bar, expected, 0.01, "s from 1e-4 to 1e-8"});
  };
  order("loss of the largest pressure", peaks, said.peak_rate);
  order("shift of the contact", centres, said.centre_rate);
  const double coefficient = peaks.back().error * peaks.back().cells * peaks.back().cells;
  const double pi = numeric::pi<double>();
  findings.compare({"loss of the largest pressure over s^2, s = 1e-8", {"solved problems", "1/2 - 4/pi^2"}, 1e-12},
                   relative_difference(coefficient, 0.5 - 4 / (pi * pi)));
}

std::vector<Evidence> check(const Context& context, Once<NeglectFacts>& once, const NeglectSaid& said) {
  return gather_at_fifty(context, [&]<Real R>() {
    const Quantity power{"power with friction's influence",
                         {"where the residual of A |x|^p vanishes, by quadrature", "edges, jump"},
                         tolerance<R>()};
    const Quantity equation{
        "equation, solved in double with these powers", {"trapezoidal rule", "psi_bar'"}, equation_tolerance};
    const NeglectFacts<R>& facts = once.at<R>(context.quick, [&] { return measure<R>(context.quick); });
    Findings findings;
    for (const Rough<R>& rough : facts.rough) {
      findings.begin_case(rough.name);
      const Exponent& expected = said.exponents_change ? rough.expected : rough.neglected;
      findings.decide("the power is another one than without friction", !(expected == rough.neglected));
      findings.compare(power, relative_difference<R>(rough.found, numeric::to_real<R>(expected)));
      findings.compare(equation, rough.equation_error);
    }
    check_smooth<R>(findings, facts.smooth, said);
    return findings.evidence(std::to_string(facts.smooth.size()) + " parabolas, a punch and a friction jump, solved");
  });
}

}  // namespace

Claim remark_neglect() {
  return make_claim(
      {"rem-01-neglect", "[Bal16, remark 1]: neglecting the influence of friction on the pressure",
       "With `s = gamma f != 0` the powers at edges, `-1/2 -+ alpha` for `-1/2`, and at jumps of `f`, `beta` for `0`, "
       "are other ones than without friction, so that the pressure is wrong there by an unbounded or a vanishing "
       "factor. Under a smooth profile and constant friction little is lost: the largest pressure under a parabola is "
       "`cos(pi alpha) ((1+2 alpha)/(1-2 alpha))^alpha = 1 - (1/2 - 4/pi^2) s^2 + O(s^4)` of the frictionless one, "
       "with the contact wider by `1/sqrt(1-4 alpha^2)`; its centre moves by `-2 alpha` of its half-width, which is "
       "`O(s)`.",
       "`-1 < gamma < 1`. For the second part a parabola as the smooth profile. The printed sentence names a nonsmooth "
       "indenter and a friction coefficient that is not constant: either of the two suffices.",
       "With `a_0` the frictionless half-width, `a = a_0/sqrt(1-4 alpha^2)`, and the traction at its largest, `x = -4 "
       "alpha a`, is `-(cos(pi alpha)/R) ((1-2 alpha) a)^{1/2-alpha} ((1+2 alpha) a)^{1/2+alpha}` against `-a_0/R`. "
       "The ratio is even in `alpha` because the rear of one sliding direction is the front of the other; `cos(pi "
       "alpha) = 1 - s^2/2 + O(s^4)` and `4 alpha^2 = 4 s^2/pi^2 + O(s^4)` give its second order: `0.1` per cent at `s "
       "= 0.1`, where the contact has moved by `6` per cent of its half-width."},
      [once = std::make_shared<Once<NeglectFacts>>()](const Context& context, const NeglectSaid& said) {
        return check(context, *once, said);
      },
      NeglectSaid{},
      std::vector<Wrong<NeglectSaid>>{
          {"the printed 'of': no other power unless the indenter is nonsmooth and friction not constant",
           changed<NeglectSaid>([](NeglectSaid& said) { said.exponents_change = false; })},
          {"the largest pressure lost at first order",
           changed<NeglectSaid>([](NeglectSaid& said) { said.peak_rate = 1; })},
          {"the contact shifted at second order",
           changed<NeglectSaid>([](NeglectSaid& said) { said.centre_rate = 2; })},
          {"the contact shifted to the front", changed<NeglectSaid>([](NeglectSaid& said) { said.angle_sign = -1; })},
          {"near miss: the largest pressure moved by ten times the tolerance",
           changed<NeglectSaid>([](NeglectSaid& said) { said.miss = 10; })}});
}

}  // namespace steadyslide::proofs_checks
