// How F = g_k - Y B changes as a free end e with the power p moves, at fixed q: k is the piece at e, so that the integral J
// in B = Q - J - q/pi, Q the polynomial part of g_k/Y, stays clear of e. With dY/de = -p Y/(z-e),
//
//   dQ/de = p (Q(z) - Q(e))/(z-e),   dJ/de = p (J(z) - J(e))/(z-e),
//
// the latter by (z-e)/((x'-e)(x'-z)) = 1/(x'-z) - 1/(x'-e). All equations are multiplied by z - e.

#include "symbolic/statements/contact_symbols.hpp"

namespace steadyslide::symbolic {
namespace {

using GiNaC::ex;
using GiNaC::symbol;

struct Linearised {
  int power = 1;         // sign of p in dY/de
  int integral = 1;      // of dJ/de
  bool at_end = true;    // B(e), not B(z), in the result
  bool with_q = true;    // the polynomial in the result
  ex fraction_sign = 1;  // of 1/(x'-e)
};

DecidedStatement linearisation() {
  const PhaseField field({symbol("s")});
  const symbol z("z"), e("e"), x("x"), p("p"), y("Y"), pi("pi");
  const symbol big_q("Q"), big_q_e("Q_e"), j("J"), j_e("J_e"), q("q"), q_e("q_e");
  const ex b = big_q - j - q / pi;
  const ex b_e = big_q_e - j_e - q_e / pi;
  const auto decided = [&](const std::string& words, const Linearised& v) {
    const ex dy = -v.power * p * y;
    const ex db = p * (big_q - big_q_e) - v.integral * p * (j - j_e);
    const ex rest = p * (v.at_end ? b_e : b) - (v.with_q ? ex(1) : ex(0)) * p / pi * (q - q_e);
    const auto& f = field.friction(0);
    Comparison comparison(field);
    comparison.equal("partial fractions", (x - e) - v.fraction_sign * (x - z), z - e)
        .equal("(z-e) dF/de", -(dy * b + y * db), y * rest);
    for (const int epsilon : {1, -1}) {
      comparison.equal("(x-e) dt/de", epsilon * f.cos * (dy * b + y * db), -epsilon * f.cos * y * rest);
    }
    return comparison.as(words);
  };
  return {
      "rh-linearisation",
      decided("dF/de = Y (p B(e)/(z-e) - (p/pi) (q(z) - q(e))/(z-e)), and -epsilon cos(pi alpha) |Y| for Y in dt/de",
              {}),
      {decided("p of the other sign", {.power = -1}), decided("the integral's other sign", {.integral = -1}),
       decided("B(z) for B(e)", {.at_end = false}), decided("without q", {.with_q = false}),
       decided("partial fractions with a sum", {.fraction_sign = -1})}};
}

}  // namespace

void add_linearisation(std::vector<DecidedStatement>& all) { all.push_back(linearisation()); }

}  // namespace steadyslide::symbolic
