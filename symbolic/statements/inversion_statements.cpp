// The inverse of the operator in full contact: with w = 1/|Y|,
//   t = s u'/(1+s^2) - (cos(pi alpha)/w) (1/pi) PV int cos(pi alpha') w' u'(x')/(x'-x) dx' - P t0,
// equals cos(pi alpha) |Y| (Q + q) where u' is a polynomial; without jump the two cos make 1/(1+s^2): [Bal16, (10)].
//
// The integral by Plemelj: V = u'/Y - Q vanishes at infinity, so V is the Cauchy integral of its own jump. If
// (V+ - V-)/(2i) is cos(pi alpha) w u', then (1/pi) PV int cos w' u'/(x'-x) = (V+ + V-)/2.

#include <algorithm>

#include "symbolic/statements/contact_symbols.hpp"

namespace steadyslide::symbolic {
namespace {

using GiNaC::ex;
using GiNaC::symbol;

constexpr int most_degree = 4;

struct InversionVariant {
  int integral_sign = -1;
  int load_sign = -1;
  bool first_divided = true;   // s u'/(1+s^2), not s u'
  bool second_divided = true;  // the cos before the integral
  bool other_weight = false;   // alpha of the other sign in w
};

/// Monomials u' = x^d, d = 0..4, contact on [e_0, e_{jumps+1}].
ExactIdentity decided(const std::string& words, std::size_t jumps, const InversionVariant& variant) {
  const FundamentalSolution y(EndKind::edge, EndKind::edge, jumps);
  const ContactSymbols data(y);
  const PhaseField& field = data.field;
  const symbol w("w");
  const ex i = field.i();
  const ex x = data.x;
  const ex load = data.load / data.pi;
  Comparison comparison(field);
  for (int degree = 0; degree <= most_degree; ++degree) {
    std::vector<ex> slope(static_cast<std::size_t>(degree) + 1, 0);
    slope.back() = 1;
    const std::vector<ex> powers = data.powers(y);
    const std::vector<ex> sums =
        jumps == 0 ? power_sums(powers, {-1, 1}, slope.size() + 1) : power_sum_symbols(slope.size() + 1);
    const PolynomialSlope without_load(-1, slope, sums, 0);
    const PolynomialSlope with_load(-1, slope, sums, load);
    const std::string name = "x^" + std::to_string(degree) + ": ";
    // V = x^d/Y - Q has no power of z from 0 up: z^d times the series of 1/Y, and Q, agree there.
    const std::vector<ex> reciprocal = series_at_infinity(sums, +1, slope.size());
    for (std::size_t n = 0; n <= slope.size(); ++n) {
      comparison.equal(name + "V at infinity", reciprocal[n], without_load.factor()[slope.size() - n]);
    }
    const ex monomial = GiNaC::pow(x, degree);
    for (const auto& region : y.regions()) {
      if (!region.friction) continue;
      const auto& f = field.friction(*region.friction);
      const AngleForm sigma = variant.other_weight ? region.sigma.mirrored() : region.sigma;
      const ex above = monomial * w * field.phase(sigma, -1);
      const ex below = monomial * w * field.phase(sigma, 1);
      const std::string panel = name + "panel " + std::to_string(*region.friction) + ": ";
      comparison.equal(panel + "density", (above - below) / (2 * i), f.cos * w * monomial);
      const ex integral = (above + below) / 2 - without_load.factor(x);
      const ex t0 = f.cos / (data.pi * w);
      const ex formula = f.s * monomial / (variant.first_divided ? 1 + f.s * f.s : ex(1)) +
                         variant.integral_sign * (variant.second_divided ? f.cos : ex(1)) / w * integral +
                         variant.load_sign * data.load * t0;
      comparison.equal(panel + "t", formula, y.sign_on(field, region) * f.cos / w * with_load.factor(x));
    }
  }
  return comparison.as(words);
}

DecidedStatement inversion(const std::string& id, const std::string& words, std::size_t jumps) {
  return {id,
          decided(words, jumps, {}),
          {decided("the integral's other sign", jumps, {.integral_sign = 1}),
           decided("the load's other sign", jumps, {.load_sign = 1}),
           decided("s u' for s u'/(1+s^2)", jumps, {.first_divided = false}),
           decided("1/sqrt(1+s^2) for 1/(1+s^2) before the integral", jumps, {.second_divided = false}),
           decided("alpha of the other sign in the weight", jumps, {.other_weight = true})}};
}

}  // namespace

void add_inversion(std::vector<DecidedStatement>& all) {
  all.push_back(
      inversion("rh-inversion-0", "[Bal16, (10)] - P t0 is cos(pi alpha) |Y| (Q - P/pi) for u' = 1, x, ..., x^4", 0));
  all.push_back(inversion("rh-inversion-1", "the same with one jump, for u' = 1, x, ..., x^4", 1));
  all.push_back(inversion("rh-inversion-3", "the same with three jumps, for u' = 1, x, ..., x^4", 3));
}

}  // namespace steadyslide::symbolic
