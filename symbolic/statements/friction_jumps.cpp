// The friction's part of the energy with any number of jumps, and the energy of tractions that are constant on cells.
//
//   J_n = int_{-1}^{c_n} s t T, T(-1) = 0:  -J_n = 1/2 sum_{k<n} (s_k - s_{k-1}) T(c_k)^2 - 1/2 s_{n-1} T(c_n)^2
//
// by induction over n; T_n = T(c_n), s_{n-1} the friction left of c_n. The same for pairs of T_j/sqrt(1-x^2) with j and
// k as symbols, as <int_{-1}^x s t_j, t_k> is written. [Bal16, sections 3.1 and 4]

#include "symbolic/field/expression.hpp"
#include "symbolic/statements/cosines.hpp"

namespace steadyslide::symbolic {
namespace {

using GiNaC::ex;
using GiNaC::symbol;

struct JumpVariant {
  ex factor = ex(1) / 2;
  int before = -1;
  int power = 2;
};

ex half_square(const JumpVariant& v, const ex& t) { return v.factor * GiNaC::pow(t, v.power); }

/// One panel, T = 0 at its left end.
DecidedStatement base() {
  const auto decided = [](const std::string& words, const JumpVariant& v, const ex& start) {
    const symbol s("s"), t("T");
    const PhaseField field;
    // -int s T dT from start to t
    return Comparison(field).equal("one panel", -s * (t * t - start * start) / 2, -s * half_square(v, t)).as(words);
  };
  return {"energy-jumps-base",
          decided("-int s t T = -1/2 s T(c)^2 on one panel, T = 0 at its left end", {}, 0),
          {decided("without 1/2", {.factor = 1}, 0), decided("T for T^2", {.power = 1}, 0),
           decided("T = T_0 at the left end", {}, symbol("T_0"))}};
}

/// From n to n + 1, and T = 0 at the right end.
DecidedStatement step() {
  const auto decided = [](const std::string& words, const JumpVariant& v, bool zero_mean) {
    const symbol sum("J"), left("s_l"), right("s_r"), t("T"), next("T_next");
    const PhaseField field;
    const ex before = sum - half_square(v, t) * left;
    const ex panel = -right * (next * next - t * t) / 2;
    const ex jump = (right + v.before * left) * half_square(v, t);
    const ex after = sum + jump - half_square(v, next) * right;
    return Comparison(field)
        .equal("step", before + panel, after)
        .equal("right end", after.subs(next == (zero_mean ? ex(0) : ex(next))), sum + jump)
        .as(words);
  };
  return {"energy-jumps-step",
          decided("one panel more adds 1/2 (s_n - s_(n-1)) T(c_n)^2, and T = 0 at the right end leaves nothing else",
                  {}, true),
          {decided("without 1/2", {.factor = 1}, true), decided("the sum for the difference", {.before = 1}, true),
           decided("T for T^2", {.power = 1}, true), decided("a mean that is not zero", {}, false)}};
}

/// t T = (T^2)'/2 and t U + u T = (T U)', for T' = t, U' = u.
DecidedStatement products() {
  const auto decided = [](const std::string& words, const ex& factor, int sign) {
    const symbol t("T"), u("U"), dt("t"), du("u");
    const PhaseField field;
    const auto derivative = [&](const ex& f) { return f.diff(t) * dt + f.diff(u) * du; };
    return Comparison(field)
        .equal("t T", factor * derivative(t * t), dt * t)
        .equal("both", dt * u + sign * du * t, derivative(t * u))
        .as(words);
  };
  return {"energy-jumps-product",
          decided("t T = (T^2)'/2 and t U + u T = (T U)'", ex(1) / 2, 1),
          {decided("without 1/2", 1, 1), decided("the difference", ex(1) / 2, -1), decided("-1/2", ex(-1) / 2, 1)}};
}

/// One jump at c, C and S there: <int_{-1}^x s t_j, t_k> by both integrals as they are written, every j != k >= 1; the
/// same with j = k.
DecidedStatement pair() {
  struct Variant {
    ex factor = 1;
    int before = -1;
    bool one_order = false;
  };
  const auto decided = [](const std::string& words, const Variant& v) {
    const Cosines c;
    const symbol left("s_l"), right("s_r");
    const auto t = [](const ex& sine, const ex& index) { return -sine / index; };
    Comparison comparison(c.field);
    for (const auto& [ej, ek] : parities) {
      // x from -1 to c is theta from pi to theta_c, and dx t_k = -cos(k theta) d theta.
      const auto form = [&](const ex& j, const ex& k, const ex& sj, const ex& cj, const ex& sk, const ex& ck, int ej_,
                            int ek_) {
        const ex first = t(sj, j);                                        // T_j(c)
        const ex there = -(j * cj * ck + k * sj * sk) / (j * j - k * k);  // primitive of sin(j.) cos(k.)
        const ex at_pi = -j * ej_ * ek_ / (j * j - k * k), at_zero = -j / (j * j - k * k);
        const ex rear = -left / j * (at_pi - there);
        const ex front = -right / j * (there - at_zero) + (left - right) * first * sk / k;
        return rear + front;
      };
      const ex one = form(c.j, c.k, c.sj, c.cj, c.sk, c.ck, ej, ek);
      const ex other = form(c.k, c.j, c.sk, c.ck, c.sj, c.cj, ek, ej);
      const ex jump = v.factor * (right + v.before * left) * t(c.sj, c.j) * t(c.sk, c.k);
      c.equal(comparison, "j != k", one + (v.one_order ? ex(0) : other), jump);
      const ex square = c.sj * c.sj / (2 * c.j);  // primitive of sin(j.) cos(j.), 0 at both ends
      const ex same = -left / c.j * (-square) - right / c.j * square + (left - right) * t(c.sj, c.j) * c.sj / c.j;
      c.equal(comparison, "j = k", 2 * same, v.factor * (right + v.before * left) * GiNaC::pow(t(c.sj, c.j), 2));
    }
    return comparison.as(words);
  };
  return {
      "energy-jumps-pair",
      decided("<int s t_j, t_k> + <int s t_k, t_j> = (s_r - s_l) T_j(c) T_k(c) with a jump at c, every j, k >= 1", {}),
      {decided("1/2 of it", {.factor = ex(1) / 2}), decided("the other sign", {.factor = -1}),
       decided("the sum for the difference", {.before = 1}), decided("one order", {.one_order = true})}};
}

/// F(r) = r^2 log|r|/2 - 3 r^2/4 has F'' = log|r|. On [a, b] x [c, d] the integral of log|x-x'| is the sum of F over the
/// corners, + at (a, d) and (b, c) and - at the others; with heights h and -h at the ends of a cell, minus the sum over
/// the ends. F is even; its part in r^2 leaves the product of the forces.
DecidedStatement cells() {
  struct Variant {
    ex constant = ex(3) / 4;
    int sign = -1;
    bool with_quadratic = true;
    int own = 2;
  };
  const auto decided = [](const std::string& words, const Variant& v) {
    const symbol r("r"), l("log"), a("a"), b("b"), c("c"), d("d"), ti("t_i"), tj("t_j"), q("q");
    const PhaseField field;
    const auto derivative = [&](const ex& f) { return (f.diff(r) + f.diff(l) / r).expand(); };
    const ex f = r * r * l / 2 - v.constant * r * r;
    const auto corners = [&](const auto& g) { return g(b - d) - g(b - c) - g(a - d) + g(a - c); };
    // d^2/(dx dx') of F(x-x') is -F''.
    const auto quadratic = [&](const ex& e) { return GiNaC::pow(e, v.with_quadratic ? 2 : 1); };
    return Comparison(field)
        .equal("F''", derivative(derivative(f)), l)
        .equal("d^2 F/(dx dx')", -(l + 1 + ex(1) / 2 - 2 * v.constant), v.sign * l)
        .equal("corners of r^2", ti * tj * corners(quadratic), -v.own * (ti * (b - a)) * (tj * (d - c)))
        .equal("corners of 1", corners([&](const ex&) { return q; }), 0)
        .as(words);
  };
  return {
      "energy-cells",
      decided("r^2 log|r|/2 - 3 r^2/4 is the second primitive of log|r|, and r^2 leaves -2 q_i q_j at the ends of two "
              "cells",
              {}),
      {decided("r^2/4", {.constant = ex(1) / 4}), decided("the other sign", {.sign = 1}),
       decided("r for r^2", {.with_quadratic = false}), decided("-q_i q_j", {.own = 1})}};
}

/// b(t,t) = E + 1/2 [s] T^2 against one jump's eigenvalue, and what a bound D on b says of T(c).
DecidedStatement one_jump() {
  const auto decided = [](const std::string& words, const ex& factor, int sign) {
    const symbol e("E"), jump("jump"), t2("T2"), mu("mu");
    const std::vector<ex> h = symbols("h", 3), w = symbols("w", 3);
    const auto across = [&](std::size_t k) {
      return h[(k + 1) % 3] * w[(k + 2) % 3] - h[(k + 2) % 3] * w[(k + 1) % 3];
    };
    const auto with = [&](const std::vector<ex>& f) { return f[0] * across(0) + f[1] * across(1) + f[2] * across(2); };
    const PhaseField field;
    const ex energy = e + jump * t2 / 2;
    return Comparison(field)
        .equal("above E", energy - e, factor * jump * t2)
        .equal("b - mu E", energy - mu * e, (sign * jump * t2 - 2 * (mu - 1) * e) / 2)
        .equal("mean on three cells", with(h), 0)
        .equal("T(c) on three cells", with(w), 0)
        .as(words);
  };
  return {
      "energy-one-jump",
      decided("b(t,t) - E = 1/2 [s] T(c)^2, and b - mu E = ([s] T(c)^2 - 2 (mu-1) E)/2; on three cells h x w has "
              "mean 0 and T(c) = 0",
              ex(1) / 2, 1),
      {decided("without 1/2", 1, 1), decided("-1/2", ex(-1) / 2, 1), decided("the other sign of [s]", ex(1) / 2, -1)}};
}

}  // namespace

void add_friction_jumps(std::vector<DecidedStatement>& all) {
  for (const auto& statement : {base, step, products, pair, cells, one_jump}) all.push_back(statement());
}

}  // namespace steadyslide::symbolic
