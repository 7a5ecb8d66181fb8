// The forms of section 3.1 on t = sum c_k T_k(x)/sqrt(1-x^2), x = cos(theta), t dx = -sum c_k cos(k theta) d theta, with
// j and k as symbols:
//
//   4 (x-x')^2 = (2 - 2 cos(theta-theta')) (2 - 2 cos(theta+theta')),
//   int_0^pi cos(j theta) cos(k theta) d theta = 0 for j != k, pi/2 for j = k >= 1, pi for j = k = 0,
//   <t_j * sgn, t_k> = 2 (1 - (-1)^(j+k))/(k^2 - j^2), 0 for j = k,
//   (1/pi) PV int T_k(x')/(sqrt(1-x'^2) (x'-x)) dx' = U_{k-1}(x), and T_k' = k U_{k-1}. [Bal16, section 3.1]

#include "symbolic/statements/cosines.hpp"

namespace steadyslide::symbolic {
namespace {

using GiNaC::ex;
using GiNaC::symbol;

/// With cos(theta+-theta') = x x' -+ sin sin', of which only the squares enter.
DecidedStatement kernel() {
  struct Variant {
    int sign = -1;  // of the second sine's term
    ex factor = 4;
    int between = -1;  // x - x'
    int power = 2;
  };
  const auto decided = [](const std::string& words, const Variant& v) {
    const symbol x("x"), y("y"), p("p"), q("q");
    const PhaseField field;
    const ex product = (2 - 2 * (x * y + p * q)) * (2 - 2 * (x * y + v.sign * p * q));
    const ex squared =
        product.expand().subs(GiNaC::lst{p * p == 1 - x * x, q * q == 1 - y * y}, GiNaC::subs_options::algebraic);
    return Comparison(field).equal("product", squared, v.factor * GiNaC::pow(x + v.between * y, v.power)).as(words);
  };
  return {"chebyshev-kernel",
          decided("(2 - 2 cos(theta-theta')) (2 - 2 cos(theta+theta')) = 4 (x-x')^2", {}),
          {decided("cos(theta-theta') twice", {.sign = 1}), decided("(x-x')^2", {.factor = 1}),
           decided("4 (x+x')^2", {.between = 1}), decided("4 (x-x')^4", {.power = 4})}};
}

/// A primitive of cos(j theta) cos(k theta) for j != k, one for j = k, and its integrals.
DecidedStatement orthogonality() {
  struct Variant {
    int between = -1;  // j S_j C_k - k C_j S_k
    int below = -1;    // j^2 - k^2
    int equal = 1;     // theta + S C/j
    ex value = ex(1) / 2;
  };
  const auto decided = [](const std::string& words, const Variant& v) {
    const Cosines c;
    const ex different = (c.j * c.sj * c.ck + v.between * c.k * c.cj * c.sk) / (c.j * c.j + v.below * c.k * c.k);
    const ex same = (c.theta + v.equal * c.sj * c.cj / c.j) / 2;
    Comparison comparison(c.field);
    c.equal(comparison, "j != k: derivative", c.derivative(different), c.cj * c.ck);
    c.equal(comparison, "j = k: derivative", c.derivative(same), c.cj * c.cj);
    c.equal(comparison, "k = 0: derivative", c.derivative(c.sj / c.j), c.cj);
    for (const auto& [ej, ek] : parities) {
      c.equal(comparison, "j != k", c.at_pi(different, ej, ek) - c.at_zero(different), 0);
      c.equal(comparison, "j = k", c.at_pi(same, ej, ek) - c.at_zero(same), v.value * c.pi);
      c.equal(comparison, "k = 0", c.at_pi(c.sj / c.j, ej, ek) - c.at_zero(c.sj / c.j), 0);
    }
    return comparison.as(words);
  };
  return {
      "chebyshev-orthogonality",
      decided("int_0^pi cos(j theta) cos(k theta) d theta = 0 for j != k, pi/2 for j = k, every j >= 1, k >= 0", {}),
      {decided("j S_j C_k + k C_j S_k in the primitive", {.between = 1}), decided("j^2 + k^2 below", {.below = 1}),
       decided("theta - S C/j for j = k", {.equal = -1}), decided("pi for j = k", {.value = 1})}};
}

struct EntryVariant {
  ex factor = 2;
  int parity = -1;  // 1 - (-1)^(j+k)
  int below = -1;   // k^2 - j^2
  bool swapped = false;
};

ex sign_entry(const EntryVariant& v, const ex& j, const ex& k, int ej, int ek) {
  const ex below = v.swapped ? j * j + v.below * k * k : k * k + v.below * j * j;
  return v.factor * (1 + v.parity * ej * ek) / below;
}

/// As it is written: int_0^pi cos(j theta') sgn(theta'-theta) d theta' first, j, k >= 0.
DecidedStatement sign_entries() {
  const auto decided = [](const std::string& words, const EntryVariant& v) {
    const Cosines c;
    Comparison comparison(c.field);
    // F(0) + F(pi) - 2 F(theta) with the primitive F, then a primitive of that times cos(k theta).
    const ex first = c.sj / c.j;
    const ex outer = (c.j * c.cj * c.ck + c.k * c.sj * c.sk) / (c.j * c.j - c.k * c.k);
    const ex same = c.sj * c.sj / (2 * c.j);
    const ex linear = (c.pi - 2 * c.theta) * c.sk / c.k - 2 * c.ck / (c.k * c.k);
    const auto equal = [&](const char* what, const ex& lhs, const ex& rhs) { c.equal(comparison, what, lhs, rhs); };
    equal("F'", c.derivative(first), c.cj);
    equal("j != k: derivative", c.derivative(outer), -c.sj * c.ck);
    equal("j = k: derivative", c.derivative(same), c.sj * c.cj);
    equal("j = 0: derivative", c.derivative(linear), (c.pi - 2 * c.theta) * c.ck);
    equal("k = 0: derivative", c.derivative(2 * c.cj / (c.j * c.j)), -2 * c.sj / c.j);
    for (const auto& [ej, ek] : parities) {
      const ex inner = c.at_pi(first, ej, ek) + c.at_zero(first) - 2 * first;
      const auto integral = [&](const ex& f) { return c.at_pi(f, ej, ek) - c.at_zero(f); };
      equal("inner", inner, -2 * c.sj / c.j);
      equal("j != k", 2 / c.j * integral(outer), sign_entry(v, c.j, c.k, ej, ek));
      equal("j = k", integral(same), 0);
      equal("j = 0", integral(linear), sign_entry(v, 0, c.k, 1, ek));
      equal("k = 0", integral(2 * c.cj / (c.j * c.j)), sign_entry(v, c.j, 0, ej, 1));
    }
    return comparison.as(words);
  };
  return {"chebyshev-sign-entries",
          decided("<t_j * sgn, t_k> = 2 (1-(-1)^(j+k))/(k^2-j^2) for j != k, 0 for j = k, every j, k >= 0", {}),
          {decided("1 for the factor 2", {.factor = 1}), decided("1+(-1)^(j+k)", {.parity = 1}),
           decided("k^2+j^2 below", {.below = 1}), decided("j^2-k^2 below", {.swapped = true})}};
}

DecidedStatement sign_skew() {
  const auto decided = [](const std::string& words, const EntryVariant& v, int sign) {
    const Cosines c;
    Comparison comparison(c.field);
    for (const auto& [ej, ek] : parities) {
      c.equal(comparison, "exchanged", sign_entry(v, c.k, c.j, ek, ej), sign * sign_entry(v, c.j, c.k, ej, ek));
    }
    return comparison.as(words);
  };
  return {"chebyshev-sign-skew",
          decided("<t_k * sgn, t_j> = -<t_j * sgn, t_k> for every j != k", {}, -1),
          {decided("+ for -", {}, 1), decided("k^2+j^2 below", {.below = 1}, -1), decided("twice as much", {}, -2)}};
}

/// T(x) = int_{-1}^x t, and t dx = -cos(k theta) d theta.
DecidedStatement primitive_by_angle() {
  const auto decided = [](const std::string& words, const auto& of) {
    const Cosines c;
    const ex t = of(c);
    Comparison comparison(c.field);
    c.equal(comparison, "derivative", c.derivative(t), -c.ck);
    c.equal(comparison, "x = 1", c.at_zero(t), 0);
    for (const auto& [ej, ek] : parities) c.equal(comparison, "x = -1", c.at_pi(t, ej, ek), 0);
    return comparison.as(words);
  };
  return {"chebyshev-primitive",
          decided("-sin(k theta)/k is the primitive of T_k/sqrt(1-x^2) that vanishes at both ends, every k >= 1",
                  [](const Cosines& c) { return -c.sk / c.k; }),
          {decided("the other sign", [](const Cosines& c) { return c.sk / c.k; }),
           decided("without 1/k", [](const Cosines& c) { return -c.sk; }),
           decided("cos(k theta)/k", [](const Cosines& c) { return -c.ck / c.k; })}};
}

/// Phi = (i/2) zeta^(-k)/sqrt(z^2-1), z = (zeta+1/zeta)/2, |zeta| > 1: on the interval zeta = e^(+-i theta) and the root
/// is +-i sin(theta). Both sides times sin(theta), S.
DecidedStatement potential_by_index() {
  struct Variant {
    int power = -1;
    int sign = 1;
    int power_of_k = 1;  // in T_k' = k U_{k-1}
    bool cosine = false;
  };
  const auto decided = [](const std::string& words, const Variant& v) {
    const Cosines c;
    const ex i = c.field.i();
    const auto side = [&](int above) {  // S Phi, 1/(i above) = -i above
      return v.sign * i / 2 * (c.ck + v.power * above * i * c.sk) * (-i) * above;
    };
    // Phi+ + Phi- = (1/(pi i)) PV int t/(x'-x); dx = -S d theta.
    return Comparison(c.field)
        .equal("S t", side(1) - side(-1), c.ck)
        .equal("S (1/pi) PV int t/(x'-x)", i * (side(1) + side(-1)), v.cosine ? c.ck : c.sk)
        .equal("S T_k'", -c.derivative(c.ck), GiNaC::pow(c.k, v.power_of_k) * c.sk)
        .as(words);
  };
  return {"chebyshev-potential",
          decided("(1/pi) PV int T_k/(sqrt(1-x'^2) (x'-x)) dx' = U_(k-1)(x) = T_k'(x)/k, every k >= 0", {}),
          {decided("zeta^k for zeta^(-k)", {.power = 1}), decided("-i/2 for i/2", {.sign = -1}),
           decided("T_k'/k^2", {.power_of_k = 2}), decided("T_k/sqrt(1-x^2) as its own potential", {.cosine = true})}};
}

}  // namespace

void add_chebyshev_forms(std::vector<DecidedStatement>& all) {
  for (const auto& statement :
       {kernel, orthogonality, sign_entries, sign_skew, primitive_by_angle, potential_by_index}) {
    all.push_back(statement());
  }
}

}  // namespace steadyslide::symbolic
