// What the places of strips do to the friction of a flat punch. Its weight, w = (1/pi) int (e^A/(x+y) + e^-B/(x-y))
// dx/sqrt(x^2-1), is strictly convex, and the derivative by the place of a jump; exchanges of coatings; fine periods.

#include "symbolic/statements/contact_symbols.hpp"

namespace steadyslide::symbolic {
namespace {

using GiNaC::ex;
using GiNaC::symbol;

/// k/(x+a) + (1-k)/(x+b) - 1/(x+k a+(1-k) b), times its denominators; with -a, -b the same of 1/(x-y).
DecidedStatement chord() {
  const auto decided = [](const std::string& words, int sign, int order, int middle) {
    const symbol x("x"), a("a"), b("b"), k("k");
    const PhaseField field;
    const auto excess = [&](int side) {
      const ex at_a = x + side * a;
      const ex at_b = x + side * b;
      return ex((k * at_b + (1 - k) * at_a) * (x + side * (k * a + middle * (1 - k) * b)) - at_a * at_b);
    };
    const ex chord = sign * k * (1 - k) * GiNaC::pow(a - b, order);
    return Comparison(field).equal("of 1/(x+y)", excess(1), chord).equal("of 1/(x-y)", excess(-1), chord).as(words);
  };
  return {"rh-layout-chord",
          decided("the chord of 1/(x+y) from a to b is k (1-k) (a-b)^2/((x+a) (x+b) (x+k a+(1-k) b)) above it, and the "
                  "like of 1/(x-y)",
                  1, 2, 1),
          {decided("below it", -1, 2, 1), decided("(a-b)^3", 1, 3, 1), decided("at another place", 1, 2, 2),
           decided("twice", 2, 2, 1)}};
}

/// A jump at y: A gains (alpha_l - alpha_r) log(x+y), B loses (alpha_l - alpha_r) log(x-y); exponentials are symbols.
DecidedStatement slopes() {
  const auto decided = [](const std::string& words, int jump, int front, int weight) {
    const symbol x("x"), y("y"), al("alpha_l"), ar("alpha_r"), a("exp_A"), nb("exp_minus_B");
    const PhaseField field;
    const ex slope_a = ((al - ar) * GiNaC::log(x + y)).diff(y);
    const ex slope_b = (front * (al - ar) * GiNaC::log(x - y)).diff(y);
    return Comparison(field)
        .equal("slope", a * slope_a + nb * slope_b, jump * (al - ar) * (a / (x + y) + weight * nb / (x - y)))
        .as(words);
  };
  return {
      "rh-layout-slopes",
      decided("the derivative of e^A - e^-B by the place y of a jump is (alpha_l - alpha_r) (e^A/(x+y) + e^-B/(x-y))",
              1, -1, 1),
      {decided("of the other sign", -1, -1, 1), decided("B of the other sign", 1, 1, 1),
       decided("e^A/(x+y) - e^-B/(x-y)", 1, -1, -1), decided("twice", 2, -1, 1)}};
}

/// Two jumps move so that the rough coating gains u at one and loses it at the other.
DecidedStatement exchange() {
  const auto decided = [](const std::string& words, int loss, int second) {
    const symbol d("D"), w1("w_1"), w2("w_2"), u("u");
    const PhaseField field;
    return Comparison(field).equal("change", d * (w1 * u + w2 * loss * u), d * u * (w1 + second * w2)).as(words);
  };
  return {"rh-layout-exchange",
          decided("what exchanging a length u of two coatings changes is D u (w_1 - w_2)", -1, -1),
          {decided("a gain at both jumps", 1, -1), decided("w_1 + w_2", -1, 1), decided("w_1 alone", -1, 0),
           decided("twice the loss", -2, -1)}};
}

/// Over a period from z on, 1/(x+y) differs from its value at z by (z-y)/((x+y) (x+z)), 1/(x-y) by (y-z)/((x-y) (x-z)).
DecidedStatement periods() {
  const auto decided = [](const std::string& words, int behind, int front) {
    const symbol x("x"), y("y"), z("z");
    const PhaseField field;
    return Comparison(field)
        .equal("behind", (x + z) - (x + y), behind * (z - y))
        .equal("in front", (x - z) - (x - y), front * (y - z))
        .as(words);
  };
  return {"rh-layout-periods",
          decided("1/(x+y) - 1/(x+z) = (z-y)/((x+y) (x+z)) and 1/(x-y) - 1/(x-z) = (y-z)/((x-y) (x-z))", 1, 1),
          {decided("both of the other sign", -1, -1), decided("1/(x+y) of the other sign", -1, 1),
           decided("1/(x-y) of the other sign", 1, -1), decided("twice", 2, 2)}};
}

/// arctan s <= arctan m + (s-m)/(1+m^2): the difference of the slopes, times (1+s^2) (1+m^2).
DecidedStatement tangent() {
  const auto decided = [](const std::string& words, int sign, int between) {
    const symbol s("s"), m("m");
    const PhaseField field;
    return Comparison(field).equal("slopes", (1 + s * s) - (1 + m * m), sign * (s - m) * (s + between * m)).as(words);
  };
  return {"rh-layout-tangent",
          decided("1/(1+m^2) - 1/(1+s^2) = (s-m) (s+m)/((1+s^2) (1+m^2))", 1, 1),
          {decided("the other sign", -1, 1), decided("(s-m)^2", 1, -1), decided("(s-m) (s+2 m)", 1, 2),
           decided("twice", 2, 1)}};
}

}  // namespace

void add_strip_weights(std::vector<DecidedStatement>& all) {
  for (const auto& statement : {chord, slopes, exchange, periods, tangent}) all.push_back(statement());
}

}  // namespace steadyslide::symbolic
