// What follows from the closed forms for loads and friction, whatever the number of friction jumps: power sums by parts,
// where the load of a tilted punch acts, the sign of a growing load's traction, a notch in full contact, Galin's pressure
// under strong friction, what the slope beside a punch says, and a punch that has run in.

#include "symbolic/statements/contact_symbols.hpp"

namespace steadyslide::symbolic {
namespace {

using GiNaC::ex;
using GiNaC::symbol;

constexpr std::size_t most_jumps = 4;

/// sum p_j h(e_j) = -+(h(e_0) + h(e_(m+1)))/2 + sum alpha_k (h(e_(k+1)) - h(e_k)), h_j for h(e_j): edges, free ends.
DecidedStatement sums_by_parts() {
  struct Variant {
    int angle = 1;
    int beta = 1;
    int end = 1;
    ex half = ex(1) / 2;
  };
  const ContactSymbols data(FundamentalSolution(EndKind::edge, EndKind::edge, most_jumps + 1));
  const std::vector<ex> h = symbols("h", most_jumps + 2);
  const auto decided = [&](const std::string& words, const Variant& variant) {
    Comparison comparison(data.field);
    for (const EndKind end : {EndKind::edge, EndKind::free}) {
      const int sign = variant.end * (end == EndKind::edge ? -1 : 1);
      for (std::size_t jumps = 0; jumps <= most_jumps; ++jumps) {
        const std::vector<ex> powers = data.powers(FundamentalSolution(end, end, jumps));
        ex sum = 0;
        ex parts = sign * variant.half * (h[0] + h[jumps + 1]);
        for (std::size_t j = 0; j < powers.size(); ++j) {
          sum += (j == 0 || j == jumps + 1 ? 1 : variant.beta) * powers[j] * h[j];
          if (j > 0) parts += variant.angle * data.alpha[j - 1] * (h[j] - h[j - 1]);
        }
        comparison.equal((end == EndKind::edge ? "edges, " : "free ends, ") + std::to_string(jumps) + " jumps", sum,
                         parts);
      }
    }
    // One more jump, at c before the right end b: what changes is next to b, whatever is on its left.
    const ex change = data.alpha[1] - data.alpha[0];
    return comparison
        .equal("one more jump", change * h[1] - variant.beta * change * h[0], variant.angle * change * (h[1] - h[0]))
        .as(words);
  };
  return {
      "rh-sums-by-parts",
      decided("sum p_j h(e_j) = -+(h(e_0) + h(e_(m+1)))/2 + sum alpha_k (h(e_(k+1)) - h(e_k)), - with edges and + with "
              "free ends, for any number of jumps",
              {}),
      {decided("alpha of the other sign", {.angle = -1}), decided("beta of the other sign", {.beta = -1}),
       decided("without alpha", {.angle = 0}), decided("edges and free ends exchanged", {.end = -1}),
       decided("the ends without 1/2", {.half = 1})}};
}

/// The coefficient of 1/z^2 in F = delta - Y (delta (z + sigma_1) - P/pi) is -1/pi times int x t.
DecidedStatement load_place() {
  struct Variant {
    int mean = 1;
    int spread = 1;
    ex half = ex(1) / 2;
    bool squared = true;
  };
  const PhaseField field;
  const symbol delta("delta"), load("P"), pi("pi");
  const std::vector<ex> s = power_sum_symbols(3);
  const auto decided = [&](const std::string& words, const Variant& variant) {
    const std::vector<ex> y = series_at_infinity(s, -1, 3);
    const ex spread = -variant.half * ((variant.squared ? ex(s[0] * s[0]) : ex(0)) + s[1]);
    const std::vector<ex> factor{delta * s[0] - load / pi, delta};
    return Comparison(field)
        .equal("int t", -pi * field_coefficient(-1, {delta}, factor, y, -1), -load)
        .equal("int x t", -pi * field_coefficient(-1, {delta}, factor, y, -2),
               variant.mean * load * s[0] + variant.spread * pi * delta * spread)
        .equal("int x^2 t_0 - (int x t_0)^2", y[2] - y[1] * y[1], spread)
        .as(words);
  };
  return {
      "rh-load-place",
      decided("tilted punch: int x t = P sigma_1 + pi delta V, V = -(sigma_1^2 + sigma_2)/2 the variance of t_0", {}),
      {decided("-P sigma_1", {.mean = -1}), decided("-pi delta V", {.spread = -1}),
       decided("V without the 1/2", {.half = 1}), decided("V without sigma_1^2", {.squared = false})}};
}

/// With edges at all ends Y = (-1)^k |Y| off the contact and epsilon = (-1)^k, k components further right.
DecidedStatement alternating_signs() {
  const auto decided = [](const std::string& words, int gap, int inside, const auto& spoil) {
    const PhaseField field(symbols("s", 4));
    Comparison comparison(field);
    std::vector<Component> components;
    for (const std::size_t panels : {1U, 2U, 1U}) {
      components.push_back({EndKind::edge, EndKind::edge, panels});
      const FundamentalSolution y = spoil(FundamentalSolution(components));
      for (const auto& region : y.regions()) {
        const std::size_t further =
            components.size() - region.component;  // the component itself, and those on its right
        const std::string name = std::to_string(components.size()) + " components, " + std::to_string(further);
        const ex phase = field.phase(region.sigma, 1);
        if (!region.friction) {
          comparison.equal(name + ": Y", phase, further % 2 == 0 ? 1 : gap);
        } else {
          const auto& f = field.friction(*region.friction);
          comparison.equal(name + ": epsilon", (f.s + field.i()) * phase * f.cos, (further - 1) % 2 == 0 ? 1 : inside);
        }
      }
    }
    // A component more: its powers sum to -1.
    return comparison.equal("one more component", field.phase(AngleForm(-2), 1), gap)
        .equal("one more epsilon", inside, gap)
        .as(words);
  };
  const auto same = [](const FundamentalSolution& y) { return y; };
  return {
      "rh-alternating-signs",
      decided("with edges at all ends Y = (-1)^k |Y| off the contact and epsilon = (-1)^k on it, k components further "
              "right: the powers of each component sum to -1",
              -1, -1, same),
      {decided("Y positive in all gaps", 1, -1, same), decided("epsilon = 1 on all components", -1, 1, same),
       decided("no sign changes", 1, 1, same), decided("every power of the other sign", -1, -1, [](const auto& y) {
         std::vector<AngleForm> powers;
         for (const auto& point : y.points()) powers.push_back(-point.power);
         return y.with_powers(powers);
       })}};
}

}  // namespace

void add_loads(std::vector<DecidedStatement>& all) {
  for (const auto& statement : {sums_by_parts, load_place, alternating_signs}) all.push_back(statement());
}

}  // namespace steadyslide::symbolic
