// Three calculations in the proof of theorem 10. [Bal16, theorem 10]

#include <array>

#include "numeric/cauchy/residuals.hpp"
#include "numeric/quadrature/tanh_sinh.hpp"
#include "proofs_checks/instruments/proofs.hpp"

namespace steadyslide::proofs_checks {
namespace {

std::vector<Rational> frictions(const Context& context, std::string_view stream) {
  std::vector<Rational> all{Rational(4, 7)};
  if (!context.quick) all.insert(all.end(), {0, Rational(3, 2), Rational(-1, 3)});
  Random random(context.seed, stream);
  all.push_back(random.between(0, 3));
  return all;
}

std::string detail_of(const Context& context, std::size_t count) {
  return std::to_string(count) + " values of s, the last random with seed " + std::to_string(context.seed);
}

struct SplittingSaid {
  int last_sign = 1;
  bool same_power = true;  ///< (1+x')^b in the last term
  bool factor = true;      ///< 1+x before the second integral
  int miss = 0;
};

/// (1+x')^b eta(x') with eta = (1-x')^{1/2-alpha}/(3+x'), b = b_0 + extra.
template <Real R>
numeric::PiecewiseDensity<R> powered(const Rational& s, int extra) {
  const Exponent alpha = Exponent::angle(s);
  return {{{R(-1), R(1), R(2)},
           numeric::Power<R>::of(half + alpha + Exponent(extra)),
           numeric::Power<R>::of(half - alpha),
           [](const numeric::Node<R>& node) { return R(1 / (3 + node.x)); }}};
}

std::vector<Evidence> check_splitting(const Context& context, const SplittingSaid& said) {
  return gather_quick_in_double(context, [&]<Real R>() {
    using std::abs;
    const Quantity integral{
        "the integral split in two", {"left side by tanh-sinh", "right side by the trapezoidal rule"}, tolerance<R>()};
    Findings findings;
    const auto all = frictions(context, "thm-10-proof-splitting");
    for (const Rational& s : all) {
      findings.begin_case("s = " + to_string(s));
      // Of first degree in x and in x': four corners of a rectangle decide it.
      for (const Rational& x : {Rational(-1, 2), Rational(1, 3)}) {
        for (const Rational& y : {Rational(1, 5), Rational(-2, 3)}) {
          const Rational last = said.last_sign * (y - x);
          findings.decide("1+x' = (1+x) + (x'-x), the common factor (1+x')^b taken out",
                          1 + y == (said.factor ? 1 + x : Rational(1)) + last);
        }
      }
      const numeric::trapezoidal::Grid<R> grid(powered<R>(s, 0));
      const auto at = grid.midpoint_near(0, R(3) / 10);
      const R left = numeric::tanh_sinh::hilbert<R>(powered<R>(s, 1), at).value;
      const R second = at.node.from_left * grid.hilbert(at) * (1 + said.miss * R(tolerance<R>()));
      const int extra = said.same_power ? 0 : 1;
      const R last = numeric::trapezoidal::Grid<R>(powered<R>(s, extra)).integral() / numeric::pi<R>();
      findings.compare(integral, static_cast<double>(R(abs(left - second - last) / abs(second))));
    }
    return findings.evidence(detail_of(context, all.size()));
  });
}

/// L(k (1+x)) = (a + b (1+x)) t_0.
struct LinearSaid {
  Rational a_angle = 2;  ///< a = -k pi (1 - a_angle alpha)
  int a_sign = -1;
  bool pi = true;
  bool printed = false;  ///< W with (1+x)^{-1/2}
  int miss = 0;
};

std::vector<Evidence> check_linear(const Context& context, const LinearSaid& said) {
  return gather_quick_in_double(context, [&]<Real R>() {
    using std::abs, std::max, std::pow;
    const Quantity formula{
        "L of a linear function", {"(10) by the trapezoidal rule", "(a + b (1+x)) t_0"}, tolerance<R>()};
    const Quantity equation{"A of it", {"trapezoidal rule", "k"}, tolerance<R>()};
    const R k = R(3) / 2;
    Findings findings;
    const auto all = frictions(context, "thm-10-proof-linear");
    for (const Rational& s : all) {
      findings.begin_case("s = " + to_string(s), s != 0);
      const R alpha = numeric::to_real<R>(Exponent::angle(s));
      const R b = k * (said.pi ? numeric::pi<R>() : R(1)) * (1 + said.miss * R(tolerance<R>()));
      const R a = said.a_sign * b * (1 - numeric::to_real<R>(said.a_angle) * alpha);
      const Inverse<R> inverse(s, {{R(-1), R(2), {R(0), R(1)}, {R(0), R(1)}, [k](const auto&) { return k; }}});
      for (const int percent : {30, 2}) {
        const auto at = inverse.point(0, R(percent) / 100);
        const R& d = at.node.from_left;
        R unit = unit_solution<R>(s, d, at.node.from_right);
        if (said.printed) unit *= pow(d, alpha);
        const R found = inverse.at(at);
        const R size = max(R(abs(found)), R(abs(b) * unit / 100));
        findings.compare(formula, static_cast<double>(R(abs(found - (a + b * d) * unit) / size)));
      }
      const R size = numeric::cos_pi_alpha<R>(s) / numeric::pi<R>();
      const numeric::PanelDensity<R> panel{{R(-1), R(1), R(2)},
                                           numeric::Power<R>::of(-(half + Exponent::angle(s))),
                                           numeric::Power<R>::of(-(half - Exponent::angle(s))),
                                           [=](const auto& node) { return R(size * (a + b * node.from_left)); }};
      const numeric::SurfaceCheck<R> check({panel}, {numeric::to_real<R>(s)},
                                           [k](std::size_t, const auto&) { return k; });
      findings.compare(equation, static_cast<double>(check.equation()));
    }
    return findings.evidence(detail_of(context, all.size()));
  });
}

struct SlopeSaid {
  bool sine = true;
  bool sine_of_alpha = false;
  int miss = 0;
};

std::vector<Evidence> check_slope(const Context& context, const SlopeSaid& said) {
  return gather_quick_in_double(context, [&]<Real R>() {
    using std::abs, std::pow, std::sin, std::sqrt;
    const Quantity sine{"sin(pi (1/2+alpha))", {"sine of the angle", "1/sqrt(1+s^2)"}, tolerance<R>()};
    const Quantity cauchy{"(1/pi) int_0^1 y^p/(y+d) dy, p = -(1/2+alpha)",
                          {"trapezoidal rule", "sqrt(1+s^2) d^p and a power series in d"},
                          tolerance<R>()};
    const Quantity by_tanh_sinh{"the same by tanh-sinh", {"tanh-sinh", "sqrt(1+s^2) d^p and a series"}, tolerance<R>()};
    Findings findings;
    const auto all = frictions(context, "thm-10-proof-slope");
    for (const Rational& s : all) {
      findings.begin_case("s = " + to_string(s), s != 0);
      // s = 2m/(1-m^2) is the tangent of twice the angle of m.
      const Rational m = s / 5;
      const Rational twice = 2 * m / (1 - m * m);
      const Rational root = (1 + m * m) / (1 - m * m);
      findings.decide(
          "tan(2 a) = 2m/(1-m^2) for m = tan(a), and 1 + tan(2 a)^2 is the square of 1/cos(2 a)",
          Exponent::angle(m) + Exponent::angle(m) == Exponent::angle(twice) && 1 + twice * twice == root * root);
      const Exponent alpha = Exponent::angle(s);
      const R exact = numeric::to_real<R>(s);
      R right = 1 / sqrt(R(1 + exact * exact));
      if (said.sine_of_alpha) right *= exact;
      right *= 1 + said.miss * R(tolerance<R>());
      findings.compare(
          sine, static_cast<double>(R(abs(sin(R(numeric::pi<R>() * numeric::to_real<R>(half + alpha))) - right))));
      const numeric::Power<R> p = numeric::Power<R>::of(-(half + alpha));
      const numeric::PiecewiseDensity<R> power{{{R(0), R(1), R(1)}, p, {R(0), R(1)}, [](const auto&) { return R(1); }}};
      const numeric::trapezoidal::Grid<R> grid(power);
      for (const Rational& distance : {Rational(1, 1000), Rational(1, 20)}) {
        const R d = numeric::to_real<R>(distance);
        R series = 0;
        R term = 1;
        for (int k = 0; k < 200 && abs(term) > numeric::epsilon<R>() / 100; ++k, term *= -d)
          series += term / (k - p.value);
        const R expected = pow(d, p.value) / (said.sine ? right : R(1)) - series / numeric::pi<R>();
        findings.compare(cauchy, relative_difference<R>(grid.cauchy(Side::left, d), expected));
        if (distance == Rational(1, 20)) {
          findings.compare(by_tanh_sinh,
                           relative_difference<R>(numeric::tanh_sinh::cauchy<R>(power, Side::left, d).value, expected));
        }
      }
    }
    return findings.evidence(detail_of(context, all.size()));
  });
}

}  // namespace

Claim proof_splitting() {
  using Said = SplittingSaid;
  return make_claim(claim_text("thm-10-proof-splitting"), check_splitting, Said{},
                    std::vector<Wrong<Said>>{
                        {"the last term's sign", changed<Said>([](Said& said) { said.last_sign = -1; })},
                        {"1+x missing before the second term", changed<Said>([](Said& said) { said.factor = false; })},
                        {"another power in the last term", changed<Said>([](Said& said) { said.same_power = false; })},
                        {"near miss: the second integral moved by ten times the tolerance",
                         changed<Said>([](Said& said) { said.miss = 10; })}});
}

Claim proof_linear() {
  using Said = LinearSaid;
  return make_claim(
      claim_text("thm-10-proof-linear"), check_linear, Said{},
      std::vector<Wrong<Said>>{
          {"the sign of a", changed<Said>([](Said& said) { said.a_sign = 1; })},
          {"alpha's sign in a", changed<Said>([](Said& said) { said.a_angle = -2; })},
          {"alpha for 2 alpha in a", changed<Said>([](Said& said) { said.a_angle = 1; })},
          {"pi missing", changed<Said>([](Said& said) { said.pi = false; })},
          {"the printed (1+x)^{1/2} in t_0", changed<Said>([](Said& said) { said.printed = true; })},
          {"near miss: a and b moved by ten times the tolerance", changed<Said>([](Said& said) { said.miss = 10; })}});
}

Claim proof_slope() {
  using Said = SlopeSaid;
  return make_claim(
      claim_text("thm-10-proof-slope"), check_slope, Said{},
      std::vector<Wrong<Said>>{
          {"without the sine", changed<Said>([](Said& said) { said.sine = false; })},
          {"the sine of pi alpha", changed<Said>([](Said& said) { said.sine_of_alpha = true; })},
          {"near miss: the sine moved by ten times the tolerance", changed<Said>([](Said& said) { said.miss = 10; })}});
}

}  // namespace steadyslide::proofs_checks
