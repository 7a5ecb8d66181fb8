// For one friction value b = b_0 (1 + K) on tractions of zero mean, b_0 the scalar product without friction and K skew,
// ||K|| <= |s|. What follows from b_0(t, K t) = 0 alone, and the inverse (10) for any slope. [Bal16, section 3]

#include "symbolic/statements/cosines.hpp"

namespace steadyslide::symbolic {
namespace {

using GiNaC::ex;
using GiNaC::symbol;

/// |p t + q K t|^2, products <t, Kt> = -<Kt, t> and <Kt, t> being equal by symmetry of the scalar product.
struct Products {
  symbol tt{"tt"}, kk{"KtKt"}, cross{"tKt"};
  /// skew: <t,Kt> = -<Kt,t> = -<t,Kt>.
  ex square(const ex& p, const ex& q, bool skew) const {
    const ex other = skew ? -cross : ex(cross);
    return p * p * tt + p * q * (cross + other) + q * q * kk;
  }
};

/// a_0(u,u) = |t + Kt|^2, a(u,u) = |t|^2 for u the displacement of t.
DecidedStatement inverse() {
  const auto decided = [](const std::string& words, bool skew, int sign, int bound) {
    const Products of;
    const symbol s("s");
    const PhaseField field;
    const ex a0 = of.square(1, 1, skew);
    const ex a = of.tt;
    return Comparison(field)
        .equal("a_0 - a", a0 - a, sign * of.kk)
        .equal("(1+s^2) a - a_0", (1 + s * s) * a - a0, GiNaC::pow(s, bound) * of.tt - of.kk)
        .as(words);
  };
  return {
      "skew-inverse",
      decided("a_0 - a = |Kt|^2 and (1+s^2) a - a_0 = s^2 |t|^2 - |Kt|^2 for a skew K", true, 1, 2),
      {decided("K not skew", false, 1, 2), decided("a - a_0 = |Kt|^2", true, -1, 2), decided("s |t|^2", true, 1, 1)}};
}

/// b(t_1, t_2) = b_0((1+K) t_1, t_2): |(1+K) t|^2 <= (1+s^2) |t|^2.
DecidedStatement bound() {
  const auto decided = [](const std::string& words, bool skew, const ex& cross, int power) {
    const Products of;
    const symbol s("s");
    const PhaseField field;
    const ex squared = of.square(1, 1, skew) + cross * s * of.tt;
    return Comparison(field)
        .equal("b(t, t)", of.square(1, 0, skew) + (skew ? ex(0) : ex(of.cross)), of.tt)
        .equal("(1+s^2) |t|^2 - |(1+K) t|^2", (1 + s * s) * of.tt - squared, GiNaC::pow(s, power) * of.tt - of.kk)
        .as(words);
  };
  return {
      "skew-bound",
      decided("b(t,t) = |t|^2 and (1+s^2)|t|^2 - |(1+K)t|^2 = s^2 |t|^2 - |Kt|^2 for a skew K", true, 0, 2),
      {decided("K not skew", false, 0, 2), decided("(1+|s|)^2 for 1+s^2", true, 2, 2), decided("s |t|^2", true, 0, 1)}};
}

/// |t - rho (1+K) t|^2 = ((1-rho)^2 + rho^2 s^2) |t|^2 at most, rho = 1/(1+s^2).
DecidedStatement contraction() {
  struct Variant {
    bool skew = true;
    ex moved = 0;  // rho = 1/(1+s^2) + moved
    bool cosine = false;
  };
  const auto decided = [](const std::string& words, const Variant& v) {
    const Products of;
    const symbol s("s"), any("rho");
    const PhaseField field({s});
    const ex rho = 1 / (1 + s * s) + v.moved;
    const ex factor = v.cosine ? field.friction(0).cos : field.friction(0).sin;
    const ex other = GiNaC::pow(1 - any, 2) + any * any * s * s;
    return Comparison(field)
        .equal("|t - rho (1+K) t|^2", of.square(1 - rho, -rho, v.skew),
               GiNaC::pow(1 - rho, 2) * of.tt + rho * rho * of.kk)
        .equal("largest, over |t|^2", GiNaC::pow(1 - rho, 2) + rho * rho * s * s, factor * factor)
        .equal("less for no rho", other - factor * factor, (1 + s * s) * GiNaC::pow(any - rho, 2))
        .as(words);
  };
  return {"skew-contraction",
          decided("|t - rho (1+K) t|^2 = (1-rho)^2 |t|^2 + rho^2 |Kt|^2, at most sin(pi alpha)^2 |t|^2 for rho = "
                  "1/(1+s^2), the best rho",
                  {}),
          {decided("K not skew", {.skew = false}), decided("rho = 1 + 1/(1+s^2)", {.moved = 1}),
           decided("cos(pi alpha)", {.cosine = true})}};
}

/// The transforms of b and of b_0 without the factor 1/|k|: 1 - i s sgn(k), whose conjugate is that of -k.
DecidedStatement transform() {
  const auto decided = [](const std::string& words, int sign, int even) {
    const symbol s("s");
    const PhaseField field;
    const ex i = field.i();
    const ex skew = -i * s;
    return Comparison(field)
        .equal("modulus squared", (1 + skew) * (1 - sign * skew), 1 + s * s)
        .equal("of K", skew * (-skew), s * s)
        .equal("conjugate", even * skew, i * s)
        .as(words);
  };
  return {
      "skew-transform",
      decided("|1 - i s sgn(k)|^2 = 1+s^2, |i s sgn(k)|^2 = s^2, and -i s sgn(k) goes to its conjugate with -k", 1, -1),
      {decided("(1 - i s)^2", -1, -1), decided("even in k", 1, 1), decided("its own inverse", 2, -1)}};
}

/// (10) for any slope: h = u'/W and J = (1/pi) PV int h/(x'-x) dx' at x are free symbols. X is the Cauchy integral of
/// u'/((s+i) Y+) = h/r, Phi = Y X.
DecidedStatement any_slope() {
  struct Variant {
    int load = 1;
    int sign = -1;
    bool divided = true;
    bool other_weight = false;
  };
  const auto decided = [](const std::string& words, const Variant& v) {
    const symbol s("s"), h("h"), integral("J"), w("W");
    const PhaseField field({s});
    const ex i = field.i();
    const ex r = field.friction(0).r;
    // Y = (z+1)^-(1/2+alpha) (z-1)^-(1/2-alpha): above, exp(-i pi (1/2-alpha)) W = -i (1+is)/r W.
    const int turn = v.other_weight ? -1 : 1;
    const ex above = -i * (1 + turn * i * s) / r * w;
    const ex below = i * (1 - turn * i * s) / r * w;
    const ex slope = h * w;
    const ex density = h / r;
    const ex mean = integral / (2 * i * r);  // (1/(2 pi i)) PV int of the density
    const ex phi_above = above * (mean + density / 2);
    const ex phi_below = below * (mean - density / 2);
    const ex ratio = (s - i) / (s + i);
    const ex first = s * slope / (v.divided ? 1 + s * s : ex(1));
    return Comparison(field)
        .equal("Y+ = G Y-", above, ratio * below)
        .equal("(s+i) Y+", (s + i) * above, r * w)
        .equal("Phi+ - G Phi-", phi_above - ratio * phi_below, slope / (s + i))
        .equal("t", phi_above - phi_below, first + v.sign * w * integral / (1 + s * s))
        .as(words);
  };
  return {"skew-any-slope",
          decided("(10) is Phi+ - Phi- for the solution of Phi+ = G Phi- + u'/(s+i), u' and its integral free", {}),
          {decided("the integral's other sign", {.sign = 1}), decided("s u' for s u'/(1+s^2)", {.divided = false}),
           decided("alpha of the other sign in the weight", {.other_weight = true})}};
}

/// K = -(1/pi) int t0 log(1-x) dx + s/2, the integral being log 2 + C_E + Psi(1/2+alpha), and Psi(1/2+alpha) -
/// Psi(1/2-alpha) = pi s.
DecidedStatement unit_constant() {
  const auto decided = [](const std::string& words, int reflected, const ex& half, int sign) {
    const symbol log2("log2"), euler("C_E"), psi("Psi"), s("s"), pi("pi");
    const PhaseField field;
    const ex other = psi - reflected * pi * s;
    return Comparison(field)
        .equal("pi K", sign * (log2 + euler + psi) + pi * s * half, -(log2 + euler + (psi + other) / 2))
        .as(words);
  };
  return {"skew-unit-constant",
          decided("-(log 2 + C_E + Psi(1/2+alpha))/pi + s/2 = -(log 2 + C_E + (Psi(1/2+alpha) + Psi(1/2-alpha))/2)/pi",
                  1, ex(1) / 2, -1),
          {decided("the reflection's other sign", -1, ex(1) / 2, -1), decided("without s/2", 1, 0, -1),
           decided("+int t0 log(1-x)", 1, ex(1) / 2, 1)}};
}

}  // namespace

void add_skew_operators(std::vector<DecidedStatement>& all) {
  for (const auto& statement : {inverse, bound, contraction, transform, any_slope, unit_constant})
    all.push_back(statement());
}

}  // namespace steadyslide::symbolic
