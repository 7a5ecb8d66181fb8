// psi' a polynomial: F = psi' - Y N solves A t = psi' whatever N is, N = Q + q gives it its order at infinity.

#include <algorithm>

#include "symbolic/statements/contact_symbols.hpp"

namespace steadyslide::symbolic {
namespace {

using GiNaC::ex;
using GiNaC::symbol;

DecidedStatement substitution() {
  const FundamentalSolution y({{EndKind::edge, EndKind::free, 2}, {EndKind::free, EndKind::edge, 2}});
  const ContactSymbols data(y);
  const PhaseField& field = data.field;
  const symbol modulus("Y");
  const symbol slope("psi'");
  const symbol factor("N");
  struct Variant {
    int sign = 1;          // of t = epsilon cos |Y| N
    bool with_cos = true;  // or sin
    int friction = 1;      // sign of s in A
    ex slope_factor = 1;   // of psi' in F
  };
  const auto decided = [&](const std::string& words, const Variant& variant) {
    Comparison comparison(field);
    for (const auto& region : y.regions()) {
      if (!region.friction) continue;
      const auto& f = field.friction(*region.friction);
      const ex above = variant.slope_factor * slope - modulus * field.phase(region.sigma, 1) * factor;
      const ex below = variant.slope_factor * slope - modulus * field.phase(region.sigma, -1) * factor;
      const ex traction = (above - below) / (2 * field.i());
      const std::string panel = "panel " + std::to_string(*region.friction) + ": ";
      comparison.equal(panel + "A t", (above + below) / 2 + variant.friction * f.s * traction, slope)
          .equal(panel + "t", traction,
                 variant.sign * y.sign_on(field, region) * (variant.with_cos ? f.cos : f.sin) * modulus * factor);
    }
    return comparison.as(words);
  };
  return {"rh-polynomial-substitution",
          decided("F = psi' - Y N gives A t = psi' and t = epsilon cos(pi alpha) |Y| N on every panel", {}),
          {decided("t of the other sign", {.sign = -1}), decided("sin for cos", {.with_cos = false}),
           decided("s of the other sign", {.friction = -1}), decided("F = 2 psi' - Y N", {.slope_factor = 2}),
           decided("F = -Y N", {.slope_factor = 0})}};
}

/// Over a grid of orders S and degrees of psi', with power sums, coefficients and load as symbols.
DecidedStatement decay() {
  const ex load = symbol("P_over_pi");
  const PhaseField field;
  enum class Variant { right, series, weights, load, no_q };
  const auto decided = [&](const std::string& words, Variant variant) {
    Comparison comparison(field);
    for (int order = -3; order <= 3; ++order) {
      for (std::size_t size = 0; size <= 4; ++size) {
        const std::vector<ex> slope = symbols("a", size);
        const std::size_t needed = PolynomialSlope::sums_needed(order, size);
        const std::vector<ex> sums =
            power_sum_symbols(std::max(needed, static_cast<std::size_t>(std::max(order + 1, 0))));
        std::vector<ex> used = sums;
        if (variant == Variant::series) {
          for (ex& sum : used) sum = -sum;
        }
        if (variant == Variant::weights) {
          for (std::size_t k = 0; k < used.size(); ++k) used[k] *= static_cast<int>(k + 1);
        }
        const PolynomialSlope solution(order, slope, used, variant == Variant::load ? -load : load);
        std::vector<ex> factor = solution.factor();
        if (variant == Variant::no_q && order == -1) factor[0] += load;
        const std::vector<ex> series = series_at_infinity(sums, -1, sums.size());
        const std::string name = "S = " + std::to_string(order) + ", z^";
        for (int power = std::max(static_cast<int>(size) - 1, -1); power >= -1; --power) {
          // The conditions are combined as the series says, with the first one's coefficient 1: they vanish together.
          ex expected = power == -1 ? load : ex(0);
          for (int k = 0; order >= 0 && k < static_cast<int>(solution.conditions().size()) && k + 1 <= order - power;
               ++k) {
            expected += solution.conditions()[static_cast<std::size_t>(k)] *
                        series[static_cast<std::size_t>(order - power - k - 1)];
          }
          comparison.equal(name + std::to_string(power), field_coefficient(order, slope, factor, series, power),
                           expected);
        }
      }
    }
    return comparison.as(words);
  };
  return {"rh-polynomial-decay",
          decided("F = P/(pi z) + O(1/z^2) if and only if the conditions hold; -3 <= S <= 3, psi' to degree 3",
                  Variant::right),
          {decided("Y's series for that of 1/Y", Variant::series), decided("power sums without 1/k", Variant::weights),
           decided("the load's other sign", Variant::load), decided("without q at S = -1", Variant::no_q)}};
}

DecidedStatement series() {
  const std::vector<ex> p = symbols("p", 3);
  const std::vector<ex> e = symbols("e", 3);
  const PhaseField field;
  const auto decided = [&](const std::string& words, int sign, const std::vector<ex>& sums) {
    Comparison comparison(field);
    const std::vector<ex> one = series_at_infinity(sums, sign, 4);
    const std::vector<ex> two = binomial_product(p, e, 4);
    for (std::size_t n = 1; n <= 4; ++n) comparison.equal("z^-" + std::to_string(n), one[n], two[n]);
    return comparison.as(words);
  };
  const std::vector<ex> sums = power_sums(p, e, 4);
  std::vector<ex> shifted = power_sums(p, e, 5);
  shifted.erase(shifted.begin());
  return {"rh-power-sums",
          decided("prod (1 - e_j/z)^p_j = exp(-sum_k sum_j p_j e_j^k/(k z^k)), to the fourth order", -1, sums),
          {decided("exp(+...)", +1, sums), decided("p of the other sign", -1, power_sums({-p[0], -p[1], -p[2]}, e, 4)),
           decided("e^(k+1) for e^k", -1, shifted),
           decided("one point missing", -1, power_sums({p[0], p[1]}, {e[0], e[1]}, 4))}};
}

/// A linear B is (m/Y)_{poly} and a constant: F = m - Y B is O(1/z), Y of the order -1.
DecidedStatement row_candidate() {
  const PhaseField field;
  const symbol slope("m"), a("a"), x("y");
  const std::vector<ex> sums = power_sum_symbols(1);
  const auto decided = [&](const std::string& words, const ex& first, int order) {
    const std::vector<ex> y = series_at_infinity(sums, -1, 1);
    return Comparison(field)
        .equal("F far away, constant", field_coefficient(order, {slope}, {a, first}, y, 0), 0)
        .equal("B", PolynomialSlope(-1, {slope}, sums, slope * sums[0] - a).factor(x), a + first * x)
        .as(words);
  };
  return {"rh-row-candidate",
          decided("B = a + m y is the polynomial part of m/Y and a constant, for any a", slope, -1),
          {decided("2 m", 2 * slope, -1), decided("-m", -slope, -1), decided("without m", 0, -1),
           decided("m + 1", slope + 1, -1)}};
}

}  // namespace

void add_polynomial_slope(std::vector<DecidedStatement>& all) {
  all.push_back(substitution());
  all.push_back(decay());
  all.push_back(series());
  all.push_back(row_candidate());
}

}  // namespace steadyslide::symbolic
