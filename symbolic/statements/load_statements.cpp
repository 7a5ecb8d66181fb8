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

/// With sigma_1 = M_0, sigma_2 = 2 M_1 - 1, the edges of [-1, 1] lift at delta = P/(pi (1 + M_0)), -P/(pi (1 - M_0)).
DecidedStatement core_ends() {
  const PhaseField field;
  const symbol m0("M_0"), m1("M_1"), load("P"), pi("pi");
  const auto decided = [&](const std::string& words, const ex& at_right, const ex& at_left, const ex& left,
                           const ex& right) {
    const ex spread = -(m0 * m0 + 2 * m1 - 1) / 2;
    const auto place = [&](const ex& tilt) -> ex { return -(load * m0 + pi * tilt * spread); };
    return Comparison(field)
        .equal("the right edge lifts", place(at_right), load * left)
        .equal("the left edge lifts", place(at_left), load * right)
        .as(words);
  };
  const ex at_right = load / (pi * (1 + m0));
  const ex at_left = -load / (pi * (1 - m0));
  const ex left = m1 / (1 + m0) - (1 + m0) / 2;
  const ex right = (1 - m0) / 2 - m1 / (1 - m0);
  return {
      "rh-core-ends",
      decided("on [-1, 1] the right edge lifts where the load acts at M_1/(1+M_0) - (1+M_0)/2, the left one where it "
              "acts at (1-M_0)/2 - M_1/(1-M_0)",
              at_right, at_left, left, right),
      {decided("the edges exchanged", at_left, at_right, left, right),
       decided("M_1 of the other sign", at_right, at_left, left.subs(m1 == -m1), right.subs(m1 == -m1)),
       decided("without friction, -1/2 and 1/2", at_right, at_left, ex(-1) / 2, ex(1) / 2),
       decided("M_0 of the other sign", at_right, at_left, left.subs(m0 == -m0), right.subs(m0 == -m0))}};
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

/// The parts of B_l and B_r that depend on x, at places at the distances d_0 > d_1 > 0 from x', weight w = cos(pi alpha)/|Y|.
DecidedStatement notch_slopes() {
  const PhaseField field;
  const symbol place("y"), from("d_0"), to("d_1"), weight("w"), g("g"), wedge("D"), pi("pi"), sum("sigma_1"), load("P");
  const auto decided = [&](const std::string& words, int sign, int part, const ex& distances) {
    Comparison comparison(field);
    for (const int side : {1, -1}) {  // x left of x', g = g_l there and g_r at x'; x right of x'
      const auto factor = [&](const ex& d) -> ex {
        return g * (place - side * d + sum) - load / pi - part * side * wedge * weight / (pi * side * d);
      };
      comparison.equal(side > 0 ? "B_l" : "B_r", factor(to) - factor(from),
                       (from - to) * (side * g - sign * wedge * weight / (pi * distances)));
    }
    return comparison.as(words);
  };
  return {"rh-notch-slopes",
          decided("B_l(x_1) - B_l(x_0) = (x_1-x_0) (g_l - (D/pi) w/(d_0 d_1)), and towards the notch from the right "
                  "B_r(x_1) - B_r(x_0) = (x_0-x_1) (-g_r - (D/pi) w/(d_0 d_1))",
                  1, 1, from * to),
          {decided("+D", -1, 1, from * to), decided("1/d^2", 1, 1, from * from),
           decided("the integral's other sign", 1, -1, from * to), decided("without the integral", 0, 1, from * to)}};
}

/// Galin's t in the distance w a from the rear end: a t/P, with P = 2 pi (1/4 - alpha^2) a^2/R.
DecidedStatement scaled_galin() {
  const ContactSymbols data(FundamentalSolution(EndKind::free, EndKind::free, 0));
  const auto& f = data.field.friction(0);
  const ex& alpha = data.alpha[0];
  const symbol a("a"), radius("R");
  const auto decided = [&](const std::string& words, const ex& amplitude, const ex& rear, const ex& width) {
    const ex load = 2 * data.pi * (ex(1) / 4 - alpha * alpha) * a * a / radius;
    return Comparison(data.field)
        .equal("a t, without the powers of w and 2 - w", -f.cos / radius * a * a, amplitude * load)
        .equal("powers", (ex(1) / 2 - alpha) + (ex(1) / 2 + alpha), 1)
        .equal("rear end", -(1 + 2 * alpha) * a, rear)
        .equal("width", (1 - 2 * alpha) * a + (1 + 2 * alpha) * a, width)
        .as(words);
  };
  const ex amplitude = -f.cos / (2 * data.pi * (ex(1) / 2 - alpha) * (ex(1) / 2 + alpha));
  const ex rear = -(1 + 2 * alpha) * a;
  return {
      "rh-parabola-scaled",
      decided("a t/P = -cos(pi alpha)/(2 pi (1/4 - alpha^2)) w^(1/2-alpha) (2-w)^(1/2+alpha), x = -(1+2 alpha) a + a w",
              amplitude, rear, 2 * a),
      {decided("without the 2", 2 * amplitude, rear, 2 * a), decided("without pi", amplitude * data.pi, rear, 2 * a),
       decided("of the other sign", -amplitude, rear, 2 * a),
       decided("w from the front", amplitude, (1 - 2 * alpha) * a, 2 * a)}};
}

/// r/(z-e) + M/Q over the common denominator is N = r Q + (z-e) M: N(e) = r Q(e).
DecidedStatement principal_part() {
  const PhaseField field;
  const symbol z("z"), e("e"), r("r");
  const std::vector<ex> q = symbols("q", 4);
  const std::vector<ex> m = symbols("m", 3);
  const auto polynomial = [](const std::vector<ex>& c, const ex& at) {
    ex value = 0;
    for (std::size_t k = c.size(); k-- > 0;) value = value * at + c[k];
    return value;
  };
  const auto decided = [&](const std::string& words, const ex& factor, const ex& value) {
    const ex numerator = r * polynomial(q, z) + factor * polynomial(m, z);
    return Comparison(field).equal("N(e)", numerator.subs(z == e), value).as(words);
  };
  return {"rh-principal-part",
          decided("r/(z-e) + M/Q has the numerator N = r Q + (z-e) M, and N(e) = r Q(e)", z - e, r * polynomial(q, e)),
          {decided("z + e", z + e, r * polynomial(q, e)), decided("z - 2 e", z - 2 * e, r * polynomial(q, e)),
           decided("Q for r Q", z - e, polynomial(q, e)), decided("N(e) = 0", z - e, 0)}};
}

/// Lengths l, friction f, r = 1/k: p = C r has k p = C, and C sum l r for its load, C sum f l r for its friction.
DecidedStatement run_in() {
  const PhaseField field;
  const auto decided = [&](const std::string& words, int pressure, int wear, bool mean) {
    const symbol c("C"), lengths("L"), worn("W"), l("l"), f("f"), k("k");
    const ex r = GiNaC::pow(k, wear);
    const ex p = c * GiNaC::pow(k, pressure);
    Comparison comparison(field);
    // One coating, and one more beside any number of them with sum l r = L, sum f l r = W, load C L and friction C W.
    comparison.equal("k p", k * p, c)
        .equal("one coating", (f * l * p) * (l * r), (l * p) * (f * l * (mean ? r : ex(1))))
        .equal("one more", (c * worn + f * l * p) * (lengths + l * r),
               (c * lengths + l * p) * (worn + f * l * (mean ? r : ex(1))));
    return comparison.as(words);
  };
  return {"rh-run-in",
          decided("p = C/k: (sum f l p) (sum l/k) = (sum l p) (sum f l/k), for any number of coatings", -1, -1, true),
          {decided("k for 1/k", -1, 1, true), decided("the mean of f by lengths", -1, 0, true),
           decided("f l for f l/k", -1, -1, false), decided("p = C", 0, -1, true)}};
}

}  // namespace

void add_loads(std::vector<DecidedStatement>& all) {
  for (const auto& statement :
       {sums_by_parts, load_place, core_ends, alternating_signs, notch_slopes, scaled_galin, principal_part, run_in}) {
    all.push_back(statement());
  }
}

}  // namespace steadyslide::symbolic
