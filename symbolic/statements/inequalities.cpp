// What the proofs of proposition 5, of (16), of the uniqueness in theorem 1 and of the bound for cells do with
// pairings: bilinear identities, each product of two symbols a symbol. Displacements u = psi - g - C with gaps g and
// constants C, tractions t under equal loads. [Bal16, section 3.2, theorem 1]

#include "symbolic/statements/cosines.hpp"

namespace steadyslide::symbolic {
namespace {

using GiNaC::ex;
using GiNaC::symbol;

/// <u1-u2, t1-t2> with u_i = psi - g_i - C_i: g1t2 stands for <g1, t2>, and loads for <1, t_i>.
DecidedStatement two_contacts() {
  const auto decided = [](const std::string& words, int sign, int own, bool equal_loads) {
    const symbol g11("g1t1"), g12("g1t2"), g21("g2t1"), g22("g2t2"), c1("C1"), c2("C2"), p1("P1"), p2("P2");
    const PhaseField field;
    const ex second = equal_loads ? p1 : p2;
    // u1 - u2 = g2 - g1 + C2 - C1
    const ex pairing = (g21 - g22) - (g11 - g12) - (c2 - c1) * (p1 - second);
    return Comparison(field).equal("pairing", pairing, sign * (g12 + g21) - own * (g11 + g22)).as(words);
  };
  return {"pairing-two-contacts",
          decided("<u1-u2, t1-t2> = <g1, t2> + <g2, t1> - <g1, t1> - <g2, t2> under equal loads", 1, 1, true),
          {decided("loads that differ", 1, 1, false), decided("<g1, t1> + <g2, t2> twice", 1, 2, true),
           decided("the other sign", -1, 1, true)}};
}

/// phi of the displacement psi + v: -P (m + C), m = <t0, v>, falls with C down to P (S - m) at C = -S, S = sup v.
DecidedStatement gap_functional() {
  const auto decided = [](const std::string& words, int at, int sign, bool scaled) {
    const symbol p("P"), m("m"), c("C"), sup("S"), k("k"), d("D");
    const PhaseField field;
    const auto least = [&](const ex& s, const ex& mean) { return sign * p * (s - mean); };
    return Comparison(field)
        .equal("at C = -S", -p * (m + at * sup), least(sup, m))
        .equal("above it", -p * (m + c) - least(sup, m), p * (-sup - c))
        .equal("k v + D", least(k * sup + d, k * m + (scaled ? ex(d) : ex(0))), k * least(sup, m))
        .as(words);
  };
  return {
      "pairing-gap-functional",
      decided("-P (m+C) is P (S-m) at C = -S and P (-S-C) more at C; for k v + D it is k times as much", -1, 1, true),
      {decided("at C = S", 1, 1, true), decided("P (m-S)", -1, -1, true),
       decided("a constant that t0 does not feel", -1, 1, false)}};
}

/// p = P t0 - t_hat: <-t_hat, psi + v> - P (S - <t0, v>) = -<psi, t_hat> + <p, v> - P S.
DecidedStatement conjugate() {
  const auto decided = [](const std::string& words, int sign, int load, int sup_sign) {
    const symbol p("P"), m("m"), sup("S"), psi("psit"), v("vt");
    const PhaseField field;
    const ex force = load * p * m - v;  // <p, v>
    return Comparison(field)
        .equal("difference", -psi - v - p * (sup - m), sign * psi + force - sup_sign * p * sup)
        .as(words);
  };
  return {"pairing-conjugate",
          decided("<-t_hat, u_hat> - phi(u_hat) = -<psi, t_hat> + <p, v> - P S, p = P t0 - t_hat, v = u_hat - psi", -1,
                  1, 1),
          {decided("+<psi, t_hat>", 1, 1, 1), decided("p = -P t0 - t_hat", -1, -1, 1), decided("+ P S", -1, 1, -1)}};
}

/// A load P spread evenly over a set of length m: mass, mean of t_hat = P t0 - p, and what is left where w >= M there.
DecidedStatement spread_load() {
  const auto decided = [](const std::string& words, int density, int unit, bool level) {
    const symbol p("p"), m("m"), excess("e"), most("M");
    const PhaseField field;
    const ex load = p * GiNaC::pow(m, density);
    return Comparison(field)
        .equal("mass", p * m, load)
        .equal("mean of P t0 - p", load * unit - p * m, 0)
        .equal("<p, w>", p * (most * m + excess), load * most + (level ? p : ex(1)) * excess)
        .as(words);
  };
  return {
      "pairing-spread-load",
      decided("p = P/m on a set of length m has the mass P, P t0 - p the mean 0, and <p, w> = P M + P e/m for w = M "
              "+ a part of integral e",
              1, 1, true),
      {decided("P for P/m", 0, 1, true), decided("t0 of mass 2", 1, 2, true), decided("e for p e", 1, 1, false)}};
}

/// F by cells, with the mean lambda = <F, p>/P under the pressures p: all of the load on one cell, where it is F_i.
DecidedStatement one_cell() {
  const auto decided = [](const std::string& words, const ex& load, int sign, int under) {
    const symbol p("P"), f("F_i"), mean("lambda");
    const PhaseField field;
    const ex pairing = under * mean * p;  // <F, p>
    return Comparison(field)
        .equal("change", load * p * f - pairing, sign * p * (f - mean))
        .equal("<F - lambda, p>", pairing - mean * p, 0)
        .as(words);
  };
  return {"pairing-one-cell",
          decided("moving the load to a cell changes <F, p> by P (F_i - lambda), and <F - lambda, p> = 0", 1, 1, 1),
          {decided("twice the load", 2, 1, 1), decided("P (lambda - F_i)", 1, -1, 1),
           decided("a mean over twice the load", 1, 1, 2)}};
}

/// X(v) = <t~ - P t0, v - sup v>; (ii) of proposition 5 is X(v^) - X(v) >= 0. t~ has the mean 0 and t0 the mass 1.
DecidedStatement displacement_form() {
  struct Variant {
    ex mean = 0;
    ex mass = 1;
    int sign = 1;
  };
  const auto decided = [](const std::string& words, const Variant& variant) {
    const symbol p("P"), m("m"), sup("S"), tv("tv"), m2("m2"), sup2("S2"), tv2("tv2"), k("k");
    const PhaseField field;
    const auto x = [&](const ex& pairing, const ex& mean, const ex& largest) {
      return variant.sign * (pairing - p * mean - largest * (variant.mean - p * variant.mass));
    };
    const auto phi = [&](const ex& mean, const ex& largest) { return p * (largest - mean); };
    return Comparison(field)
        .equal("(ii)", (tv2 - tv) + phi(m2, sup2) - phi(m, sup), x(tv2, m2, sup2) - x(tv, m, sup))
        .equal("k v", x(k * tv, k * m, k * sup), k * x(tv, m, sup))
        .equal("<t~ - P t0, v>", tv - p * m, x(tv, m, sup) - p * sup)
        .as(words);
  };
  return {"pairing-displacement-form",
          decided("(ii) of proposition 5 is X(v^) - X(v) >= 0, X(v) = <t~ - P t0, v - sup v>, X(k v) = k X(v), and "
                  "<t~ - P t0, v> = X(v) - P sup v",
                  {}),
          {decided("t~ of mean P", {.mean = symbol("P_t")}), decided("t0 of mass 2", {.mass = 2}),
           decided("-X", {.sign = -1})}};
}

/// G of the solution, G_h of any pressures p_h: <G-G_h, p-p_h> where <G, p> = 0.
DecidedStatement cells_bound() {
  const auto decided = [](const std::string& words, int own, int sign, bool contact) {
    const symbol gp("Gp"), gh("Gph"), hp("Ghp"), hh("Ghph");
    const PhaseField field;
    const ex exact = contact ? ex(0) : ex(gp);
    return Comparison(field).equal("pairing", exact - gh - hp + hh, own * hh - sign * (gh + hp)).as(words);
  };
  return {"pairing-cells-bound",
          decided("<G-G_h, p-p_h> = <G_h, p_h> - <G, p_h> - <G_h, p> where <G, p> = 0", 1, 1, true),
          {decided("without contact", 1, 1, false), decided("twice <G_h, p_h>", 2, 1, true),
           decided("+<G, p_h> + <G_h, p>", 1, -1, true)}};
}

}  // namespace

void add_inequalities(std::vector<DecidedStatement>& all) {
  for (const auto& statement :
       {two_contacts, gap_functional, conjugate, spread_load, one_cell, displacement_form, cells_bound}) {
    all.push_back(statement());
  }
}

}  // namespace steadyslide::symbolic
