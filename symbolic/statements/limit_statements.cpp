// How the influence of friction on the pressure vanishes with s: what is left under a flat punch and under a parabola, with the
// derivatives at s = 0 and, for Taylor's theorem, the second one everywhere. d alpha/ds = 1/(pi (1+s^2)). [Bal16, remark 1]

#include "symbolic/statements/contact_symbols.hpp"

namespace steadyslide::symbolic {
namespace {

using GiNaC::ex;
using GiNaC::symbol;

/// h = cos(pi alpha) exp(-alpha L), l = L/pi; cos(pi alpha) = 1/r, E the exponential.
DecidedStatement limit_punch() {
  const symbol s("s"), exponential("E"), l("l"), alpha("alpha");
  const PhaseField field({s});
  const ex r = field.friction(0).r;
  const symbol root = GiNaC::ex_to<symbol>(r);
  const ex square = 1 + s * s;
  const auto derived = [&](const ex& f) -> ex {
    return f.diff(s) + f.diff(root) * s / r - f.diff(exponential) * exponential * l / square;
  };
  const auto decided = [&](const std::string& words, const ex& h, const ex& first, const ex& second) {
    const auto at_zero = [&](const ex& f) { return f.subs(GiNaC::lst{s == 0, root == 1, exponential == 1}); };
    const auto power = [&](PointKind kind) -> ex {
      return expression(derived_exponent(kind).renamed({0, 0}), {alpha}) + ex(1) / 2;
    };
    return Comparison(field)
        .equal("power of 1+x in h", power(PointKind::left_edge), -alpha)
        .equal("power of 1-x in h", power(PointKind::right_edge), alpha)
        .equal("h(0)", at_zero(h), 1)
        .equal("h'(0)", at_zero(derived(h)), first)
        .equal("h''", derived(derived(h)), h * second / GiNaC::pow(square, 2))
        .as(words);
  };
  const ex h = exponential / r;
  const ex second = 2 * s * s + 4 * s * l + l * l - 1;
  return {
      "rh-limit-punch",
      decided("h = cos(pi alpha) ((1-x)/(1+x))^alpha, L = log((1+x)/(1-x)), l = L/pi: h(0) = 1, h'(0) = -l, h'' = h (2 "
              "s^2 + 4 s l + l^2 - 1)/(1+s^2)^2",
              h, -l, second),
      {decided("h'(0) = l", h, l, second), decided("h'(0) = -pi l", h, -symbol("pi") * l, second),
       decided("without cos(pi alpha)", exponential, -l, second),
       decided("h'' = h (2 s^2 + 4 s l + l^2)/(1+s^2)^2", h, -l, second + 1)}};
}

/// The middle of the contact under a parabola, -(2/pi) a arctan(s); arctan' = 1/(1+s^2).
DecidedStatement limit_zone() {
  const symbol s("s"), a("a"), alpha("alpha");
  const PhaseField field;
  const auto decided = [&](const std::string& words, const ex& middle, const ex& first, const ex& second) {
    const ex rate = 1 / (1 + s * s);
    return Comparison(field)
        .equal("middle", (-(1 + 2 * alpha) * a + (1 - 2 * alpha) * a) / 2, middle)
        .equal("arctan'(0)", rate.subs(s == 0), first)
        .equal("arctan''", rate.diff(s), second / GiNaC::pow(1 + s * s, 2))
        .as(words);
  };
  const ex middle = -2 * alpha * a;
  return {
      "rh-limit-zone",
      decided("the middle of -(1+2 alpha) a and (1-2 alpha) a is -2 alpha a; arctan'(0) = 1, arctan'' = -2 s/(1+s^2)^2",
              middle, 1, -2 * s),
      {decided("2 alpha a", -middle, 1, -2 * s), decided("-alpha a", middle / 2, 1, -2 * s),
       decided("arctan'(0) = 2", middle, 2, -2 * s), decided("arctan'' = 2 s/(1+s^2)^2", middle, 1, 2 * s)}};
}

/// The largest pressure of the parabola, at x = -4 alpha a, over a_0/R: powers of 1-2 alpha, 1+2 alpha and a.
DecidedStatement limit_peak() {
  const symbol a("a"), alpha("alpha"), load("P"), radius("R"), pi("pi");
  const PhaseField field;
  const auto decided = [&](const std::string& words, const ex& place, const ex& less, const ex& more, int sign) {
    const auto power = [&](PointKind kind) { return expression(derived_exponent(kind).renamed({0, 0}), {alpha}); };
    const ex left = power(PointKind::left_free);
    const ex right = power(PointKind::right_free);
    // a^2 = P R/(2 pi (1/4 - alpha^2)), so that a = a_0 ((1-2 alpha) (1+2 alpha))^{-1/2}.
    const auto squared = [&](const ex& angle) -> ex { return load * radius / (2 * pi * (ex(1) / 4 - angle * angle)); };
    return Comparison(field)
        .equal("distance from the rear", place + (1 + 2 * alpha) * a, (1 - 2 * alpha) * a)
        .equal("distance from the front", (1 - 2 * alpha) * a - place, (1 + 2 * alpha) * a)
        .equal("a_0^2", squared(alpha) * (1 + sign * 2 * alpha) * (1 + 2 * alpha), squared(0))
        .equal("power of a", left + right, 1)
        .equal("power of 1-2 alpha", left - ex(1) / 2, less)
        .equal("power of 1+2 alpha", right - ex(1) / 2, more)
        .as(words);
  };
  const ex place = -4 * alpha * a;
  return {
      "rh-limit-peak",
      decided("at x = -4 alpha a: |t| = cos(pi alpha) ((1+2 alpha)/(1-2 alpha))^alpha a_0/R, a = a_0/sqrt(1-4 alpha^2)",
              place, -alpha, alpha, -1),
      {decided("at 4 alpha a", -place, -alpha, alpha, -1), decided("the quotient turned", place, alpha, -alpha, -1),
       decided("a = a_0/(1+2 alpha)", place, -alpha, alpha, 1),
       decided("the power 2 alpha", place, -2 * alpha, 2 * alpha, -1)}};
}

/// Up to s^3: log cos(pi alpha) = -log(1+s^2)/2, alpha = (s - s^3/3)/pi, log((1+2 alpha)/(1-2 alpha)) = 4 alpha + O(alpha^3).
DecidedStatement limit_peak_series() {
  const symbol s("s"), pi("pi");
  const PhaseField field;
  const auto decided = [&](const std::string& words, const ex& second, int logarithm) {
    const ex alpha = (s - s * s * s / 3) / pi;
    const ex exponent = -s * s / 2 + alpha * logarithm * alpha;
    const ex ratio = (1 + exponent).expand();  // the square of the exponent begins with s^4
    Comparison comparison(field);
    for (int k = 0; k < 4; ++k) {
      const ex expected = k == 0 ? ex(1) : k == 2 ? second : ex(0);
      comparison.equal("coefficient of s^" + std::to_string(k), ratio.coeff(s, k), expected);
    }
    return comparison.as(words);
  };
  const ex half = ex(1) / 2;
  const ex gain = 4 / (pi * pi);
  return {"rh-limit-peak-series",
          decided("cos(pi alpha) ((1+2 alpha)/(1-2 alpha))^alpha = 1 - (1/2 - 4/pi^2) s^2 + O(s^4)", gain - half, 4),
          {decided("-s^2/2", -half, 4), decided("1/2 - 2/pi^2", gain / 2 - half, 4),
           decided("1/2 + 4/pi^2", -gain - half, 4),
           decided("log((1+2 alpha)/(1-2 alpha)) = 2 alpha + ...", gain - half, 2)}};
}

}  // namespace

void add_limits(std::vector<DecidedStatement>& all) {
  for (const auto& statement : {limit_punch, limit_zone, limit_peak, limit_peak_series}) all.push_back(statement());
}

}  // namespace steadyslide::symbolic
