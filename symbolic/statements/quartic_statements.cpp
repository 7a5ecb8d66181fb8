// psi = kappa x^4/4 with free ends. N = kappa (x^2 + sigma_1 x + h_2), h_3 = 0 and kappa h_4 = P/pi, where
// sum h_n u^n = exp(sum sigma_k u^k/k). Without jump, with the contact [(u-1) h, (u+1) h]:
//
//   6u^3 + 36 alpha u^2 + (36 alpha^2 + 9) u + 8 alpha^3 + 10 alpha = 0,   kappa h^4 H(u, alpha) = P/pi,
//   24 H = 24u^4 + 192 alpha u^3 + (288 alpha^2 + 72) u^2 + (128 alpha^3 + 160 alpha) u + 16 alpha^4 + 56 alpha^2 + 9.
//
// Without friction u = 0 and (3/8) kappa h^4 = P/pi. The equilibrium measure of the potential V = x^4 is
// 2 PV int dmu(y)/(x-y) = V': psi' = V'/(2 pi), P = 1, so kappa = 2/pi and h^4 = 4/3.

#include "symbolic/statements/contact_symbols.hpp"

namespace steadyslide::symbolic {
namespace {

using GiNaC::ex;
using GiNaC::symbol;

constexpr std::size_t quartic_jumps = 2;

/// Any number of jumps by power sums, 0 to 2 by binomial series.
DecidedStatement any_jumps() {
  const ContactSymbols data(FundamentalSolution(EndKind::free, EndKind::free, quartic_jumps));
  const symbol kappa("kappa");
  struct Variant {
    int first = 1;    // sign of sigma_1 x
    int squared = 1;  // of sigma_1^2 in h_2
    int cube = 6;     // sigma_1^3/6 in h_3
    int fourth = 4;   // sigma_4/4 in h_4
  };
  const auto decided = [&](const std::string& words, const Variant& variant) {
    const auto stated = [&](const std::vector<ex>& s) {
      const ex h2 = (s[1] + variant.squared * s[0] * s[0]) / 2;
      const ex h3 = s[2] / 3 + s[0] * s[1] / 2 + GiNaC::pow(s[0], 3) / variant.cube;
      const ex h4 =
          s[3] / variant.fourth + s[0] * s[2] / 3 + s[1] * s[1] / 8 + s[0] * s[0] * s[1] / 4 + GiNaC::pow(s[0], 4) / 24;
      return std::vector<ex>{kappa * h2, kappa * variant.first * s[0], kappa, kappa * h3, kappa * h4};
    };
    Comparison comparison(data.field);
    const std::vector<ex> sums = power_sum_symbols(4);
    const std::vector<ex> slope{0, 0, 0, kappa};
    const ex load = data.load / data.pi;
    const PolynomialSlope any(1, slope, sums, load);
    const std::vector<ex> n = stated(sums);
    comparison.equal("N", any.factor(data.x), n[0] + n[1] * data.x + n[2] * data.x * data.x)
        .equal("c_1", any.conditions()[0], n[3])
        .equal("c_2 - P/pi", any.conditions()[1], n[4] - load);
    for (std::size_t jumps = 0; jumps <= quartic_jumps; ++jumps) {
      const FundamentalSolution y(EndKind::free, EndKind::free, jumps);
      const std::vector<ex> powers = data.powers(y);
      const std::vector<ex> places(data.places.begin(),
                                   data.places.begin() + static_cast<std::ptrdiff_t>(powers.size()));
      const std::vector<ex> series = binomial_product(powers, places, 4);
      const std::vector<ex> m = stated(power_sums(powers, places, 4));
      const std::vector<ex> expected{m[4] - m[3] * power_sums(powers, places, 1)[0], m[3], 0, 0, 0};
      for (int power = -1; power <= 3; ++power) {
        comparison.equal(std::to_string(jumps) + " jumps: F, z^" + std::to_string(power),
                         field_coefficient(1, slope, {m[0], m[1], m[2]}, series, power),
                         expected[static_cast<std::size_t>(power + 1)]);
      }
    }
    return comparison.as(words);
  };
  return {"rh-quartic",
          decided("psi' = kappa x^3, free ends: N = kappa (x^2 + sigma_1 x + h_2), h_3 = 0, kappa h_4 = P/pi", {}),
          {decided("-sigma_1 x", {.first = -1}), decided("h_2 = (sigma_2 - sigma_1^2)/2", {.squared = -1}),
           decided("sigma_1^3/3 in h_3", {.cube = 3}), decided("sigma_4/2 in h_4", {.fourth = 2})}};
}

DecidedStatement ends() {
  const FundamentalSolution y(EndKind::free, EndKind::free, 0);
  const ContactSymbols data(y);
  const ex a = data.alpha[0];
  const symbol u("u");
  const symbol h("h");
  const symbol kappa("kappa");
  const auto decided = [&](const std::string& words, const ex& cubic, const ex& quartic) {
    const std::vector<ex> sums = power_sums(data.powers(y), {(u - 1) * h, (u + 1) * h}, 4);
    const PolynomialSlope solution(1, {0, 0, 0, kappa}, sums, data.load / data.pi);
    return Comparison(data.field)
        .equal("c_1", solution.conditions()[0], kappa * GiNaC::pow(h, 3) * cubic / 6)
        .equal("c_2 - P/pi", solution.conditions()[1], kappa * GiNaC::pow(h, 4) * quartic / 24 - data.load / data.pi)
        .as(words);
  };
  const ex cubic = 6 * u * u * u + 36 * a * u * u + (36 * a * a + 9) * u + 8 * a * a * a + 10 * a;
  const ex quartic = 24 * GiNaC::pow(u, 4) + 192 * a * GiNaC::pow(u, 3) + (288 * a * a + 72) * u * u +
                     (128 * a * a * a + 160 * a) * u + 16 * GiNaC::pow(a, 4) + 56 * a * a + 9;
  return {"rh-quartic-ends",
          decided("psi' = kappa x^3, constant friction: the cubic of the middle and the quartic of the width", cubic,
                  quartic),
          {decided("alpha of the other sign", cubic.subs(a == -a), quartic.subs(a == -a)),
           decided("the middle at 0", cubic - cubic.subs(u == 0), quartic),
           decided("10 alpha missing", cubic - 10 * a, quartic),
           decided("56 alpha^2 missing", cubic, quartic - 56 * a * a), decided("twice the load", cubic, 2 * quartic)}};
}

DecidedStatement frictionless() {
  const FundamentalSolution y(EndKind::free, EndKind::free, 0);
  const ContactSymbols data(y);
  const symbol width("a");
  const ex x = data.x;
  const auto decided = [&](const std::string& words, const ex& kappa, const ex& fourth, const ex& factor) {
    const std::vector<ex> sums = power_sums({ex(1) / 2, ex(1) / 2}, {-width, width}, 4);
    const PolynomialSlope solution(1, {0, 0, 0, kappa}, sums, 1 / data.pi);
    return Comparison(data.field)
        .equal("c_1", solution.conditions()[0], 0)
        .equal("c_2 - P/pi", solution.conditions()[1].expand().subs(GiNaC::pow(width, 4) == fourth), 0)
        .equal("N", solution.factor(x), factor)
        .as(words);
  };
  const ex good = 2 / data.pi * (x * x + width * width / 2);
  return {
      "rh-quartic-frictionless",
      decided("psi' = 2 x^3/pi, P = 1, s = 0: a^4 = 4/3, p = (2/pi) (x^2 + a^2/2) sqrt(a^2 - x^2)", 2 / data.pi,
              ex(4) / 3, good),
      {decided("psi' = 4 x^3", 4, ex(4) / 3, 2 * data.pi * good), decided("a^4 = 3/4", 2 / data.pi, ex(3) / 4, good),
       decided("a^2 for a^2/2", 2 / data.pi, ex(4) / 3, 2 / data.pi * (x * x + width * width)),
       decided("half the pressure", 2 / data.pi, ex(4) / 3, good / 2)}};
}

}  // namespace

void add_quartic(std::vector<DecidedStatement>& all) {
  all.push_back(any_jumps());
  all.push_back(ends());
  all.push_back(frictionless());
}

}  // namespace steadyslide::symbolic
