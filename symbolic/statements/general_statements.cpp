// The general solution: (s+i) Y+ is real, h = epsilon cos(pi alpha) psi'/|Y|, and as many conditions as unknowns.

#include "symbolic/riemann_hilbert/contact_symbols.hpp"

namespace steadyslide::symbolic {
namespace {

using GiNaC::ex;
using GiNaC::symbol;

/// What (s+i) Y+ cos(pi alpha)/|Y| is next to a right end, and that it does not change over a jump.
DecidedStatement real_on_contact() {
  const PhaseField field({symbol("s_l"), symbol("s_r")});
  const auto& left = field.friction(0);
  const auto& right = field.friction(1);
  const ex i = field.i();
  const auto decided = [&](const std::string& words, const AngleForm& jump, const ex& cos_left, const ex& cos_right,
                           int edge, int free) {
    const AngleForm sigma(3);  // at the right of the jump, whatever it is
    const auto epsilon = [&](PointKind kind) {
      return (left.s + i) * phase(field, derived_exponent(kind).renamed({0, 0}), 1) * cos_left;
    };
    return Comparison(field)
        .equal("over a jump", (left.s + i) * phase(field, sigma + jump, 1) * cos_left,
               (right.s + i) * phase(field, sigma, 1) * cos_right)
        .equal("at a right edge", epsilon(PointKind::right_edge), edge)
        .equal("at a free right end", epsilon(PointKind::right_free), free)
        .as(words);
  };
  const AngleForm beta = derived_exponent(PointKind::jump);
  return {"rh-real",
          decided("(s+i) Y+ = epsilon |Y|/cos(pi alpha), epsilon constant over jumps, +1 at a right edge, -1 at a free "
                  "right end",
                  beta, left.cos, right.cos, 1, -1),
          {decided("beta of the other sign", -beta, left.cos, right.cos, 1, -1),
           decided("without cos", beta, 1, 1, 1, -1), decided("sin for cos", beta, left.sin, right.sin, 1, -1),
           decided("+1 at a free right end", beta, left.cos, right.cos, 1, 1),
           decided("cos of the other side", beta, right.cos, left.cos, 1, -1)}};
}

/// Phi = Y X with X+ - X- = h: the sum X+ + X- is free.
DecidedStatement general_solution() {
  const FundamentalSolution y({{EndKind::edge, EndKind::free, 2}, {EndKind::free, EndKind::edge, 2}});
  const ContactSymbols data(y);
  const PhaseField& field = data.field;
  const symbol modulus("Y");
  const symbol slope("psi'");
  const symbol mean("X");
  const ex i = field.i();
  enum class Variant { right, no_cos, other_sign, doubled, times_modulus, sin };
  const auto decided = [&](const std::string& words, Variant variant) {
    Comparison comparison(field);
    for (const auto& region : y.regions()) {
      if (!region.friction) continue;
      const auto& f = field.friction(*region.friction);
      const int epsilon = y.sign_on(field, region);
      ex h = epsilon * f.cos * slope / modulus;
      if (variant == Variant::no_cos) h = epsilon * slope / modulus;
      if (variant == Variant::other_sign) h = -h;
      if (variant == Variant::doubled) h = 2 * h;
      if (variant == Variant::times_modulus) h = h * modulus * modulus;
      if (variant == Variant::sin) h = epsilon * f.sin * slope / modulus;
      const ex plus = modulus * phase(field, region.sigma, 1) * (mean + h / 2);
      const ex minus = modulus * phase(field, region.sigma, -1) * (mean - h / 2);
      const std::string panel = "panel " + std::to_string(*region.friction) + ": ";
      const JumpRelation relation = jump_relation(f.s, i);
      comparison.equal(panel + "Phi+ - G Phi-", plus - relation.ratio * minus, slope * relation.source)
          .equal(panel + "A t", i * (plus + minus) + f.s * (plus - minus), slope);
    }
    return comparison.as(words);
  };
  return {"rh-general-solution",
          decided("Phi = Y X with X+ - X- = epsilon cos(pi alpha) psi'/|Y| solves A t = psi' on every panel",
                  Variant::right),
          {decided("h without cos", Variant::no_cos), decided("h of the other sign", Variant::other_sign),
           decided("h doubled", Variant::doubled), decided("h = epsilon cos psi' |Y|", Variant::times_modulus),
           decided("sin for cos", Variant::sin)}};
}

/// n components, k free ends, S = k - n. Conditions: the load, the moments that S > 0 asks for, the n - 1 gaps.
DecidedStatement count() {
  const symbol n("n");
  const symbol k("k");
  const PhaseField field;
  const auto decided = [&](const std::string& words, const ex& order, const ex& loads, const ex& gaps,
                           const ex& coefficients) {
    return Comparison(field)
        .equal("S >= 0: free ends", k, loads + order + gaps)
        .equal("S < 0: free ends and coefficients of q", k + coefficients, loads + gaps)
        .as(words);
  };
  const ex order = k - n;
  return {"rh-count",
          decided("as many unknowns as conditions: k + max(0, -S) = 1 + max(0, S) + (n - 1)", order, 1, n - 1, -order),
          {decided("without the load", order, 0, n - 1, -order),
           decided("a condition for every component", order, 1, n, -order),
           decided("S = n - k", -order, 1, n - 1, order), decided("one coefficient more", order, 1, n - 1, 1 - order)}};
}

}  // namespace

void add_general_solution(std::vector<DecidedStatement>& all) {
  all.push_back(real_on_contact());
  all.push_back(general_solution());
  all.push_back(count());
}

}  // namespace steadyslide::symbolic
