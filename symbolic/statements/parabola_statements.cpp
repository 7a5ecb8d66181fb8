// Galin's parabola psi = x^2/(2R) [Bal16, section 2]: with free ends and constant friction, as it is printed.

#include "symbolic/statements/contact_symbols.hpp"

namespace steadyslide::symbolic {
namespace {

using GiNaC::ex;
using GiNaC::symbol;

/// F = psi' - Y N falls as load/z: what z, 1 and 1/z have in it.
void compare_decay(Comparison& comparison, const std::string& name, int order, const std::vector<ex>& slope,
                   const std::vector<ex>& factor, const std::vector<ex>& series, const ex& load) {
  for (int power = 1; power >= -1; --power) {
    comparison.equal(name + "F, z^" + std::to_string(power), field_coefficient(order, slope, factor, series, power),
                     power == -1 ? load : ex(0));
  }
}

struct Galin {
  FundamentalSolution y{EndKind::free, EndKind::free, 0};
  ContactSymbols data{y};
  ex alpha = data.alpha[0];
  symbol a{"a"};
  symbol radius{"R"};
  std::vector<ex> powers = data.powers(y);
  /// P such that a^2 = P R/(2 pi (1/4 - alpha^2)).
  ex load = 2 * data.pi * (ex(1) / 4 - alpha * alpha) * a * a / radius;
};

/// The zone and a^2 satisfy c_1 = 0 and c_2 = P/pi, and are the only pair of their width that does.
DecidedStatement zone() {
  const Galin g;
  const auto decided = [&](const std::string& words, const ex& left, const ex& right, const ex& load) {
    const std::vector<ex> sums = power_sums(g.powers, {left, right}, 2);
    const PolynomialSlope solution(1, {0, 1 / g.radius}, sums, load / g.data.pi);
    // c_1 = 0 and b - l = 2a are linear in the ends.
    const symbol l("l");
    const symbol b("b");
    const PolynomialSlope unknown(1, {0, 1 / g.radius}, power_sums(g.powers, {l, b}, 2), load / g.data.pi);
    const ex ends = GiNaC::lsolve(GiNaC::lst{unknown.conditions()[0] == 0, b - l == 2 * g.a}, GiNaC::lst{l, b});
    return Comparison(g.data.field)
        .equal("c_1", solution.conditions()[0], 0)
        .equal("c_2 - P/pi", solution.conditions()[1], 0)
        .equal("left end", ends.op(0).rhs(), left)
        .equal("right end", ends.op(1).rhs(), right)
        .as(words);
  };
  const ex l = -(1 + 2 * g.alpha) * g.a;
  const ex b = (1 - 2 * g.alpha) * g.a;
  const ex more = g.load / (ex(1) / 4 - g.alpha * g.alpha) * (ex(1) / 4 + g.alpha * g.alpha);
  return {"rh-parabola-zone",
          decided("zone [-(1+2 alpha)a, (1-2 alpha)a], a^2 = P R/(2 pi (1/4 - alpha^2))", l, b, g.load),
          {decided("the mirrored zone", -b, -l, g.load), decided("the centred zone", -g.a, g.a, g.load),
           decided("1/4 + alpha^2", l, b, more), decided("a^2 without the 2", l, b, g.load / 2),
           decided("a^2 without pi", l, b, g.load / g.data.pi),
           decided("alpha for 2 alpha", -(1 + g.alpha) * g.a, (1 - g.alpha) * g.a, g.load)}};
}

/// Both printed amplitudes, by substitution: F = x/R - Y N with N = 1/R.
DecidedStatement parabola_traction() {
  const Galin g;
  const auto& f = g.data.field.friction(0);
  const ex quarter = ex(1) / 4;
  const auto decided = [&](const std::string& words, const ex& first, const ex& second, const AngleForm& left,
                           const AngleForm& right) {
    const FundamentalSolution candidate = g.y.with_powers({left, right});
    Comparison comparison(g.data.field);
    candidate.compare(comparison, g.data.field);
    const std::vector<ex> powers = g.data.powers(candidate);
    const std::vector<ex> series = binomial_product(powers, {-(1 + 2 * g.alpha) * g.a, (1 - 2 * g.alpha) * g.a}, 2);
    const std::vector<ex> slope{0, 1 / g.radius};
    const AngleForm sigma = candidate.regions()[1].sigma;
    const ex sine = (g.data.field.phase(sigma, 1) - g.data.field.phase(sigma, -1)) / (2 * g.data.field.i());
    compare_decay(comparison, "", 1, slope, {1 / g.radius}, series, g.load / g.data.pi);
    return comparison.equal("t from F", second, -sine / g.radius)
        .equal("both forms", first, second)
        .equal("derived", second,
               g.y.sign_on(g.data.field, g.y.regions()[1]) * f.cos *
                   PolynomialSlope(1, slope, power_sum_symbols(2), g.load / g.data.pi).factor(g.data.x))
        .as(words);
  };
  const auto first = [&](const ex& denominator) -> ex {
    return -g.load * f.cos / (2 * g.data.pi * g.a * g.a * denominator);
  };
  const ex good = first(quarter - g.alpha * g.alpha);
  const ex second = -1 / (g.radius * f.r);
  const AngleForm l(1, {{0, -1}});
  const AngleForm r(1, {{0, 1}});
  return {"rh-parabola-traction",
          decided("both printed amplitudes of the parabola's traction, powers 1/2 - alpha and 1/2 + alpha", good,
                  second, l, r),
          {decided("1/4 + alpha^2", first(quarter + g.alpha * g.alpha), second, l, r),
           decided("without 1/sqrt(1+s^2)", good * f.r, second * f.r, l, r),
           decided("powers exchanged", good, second, r, l), decided("2/R", 2 * good, 2 * second, l, r),
           decided("t of the other sign", -good, -second, l, r)}};
}

// The parabola psi' = (x - v)/R with any number of jumps inside the contact, free or against edges.
//
//   both ends free    N = 1/R                              sum p r = v sum p = v,  sum p (r - v)^2 = 2 P R/pi
//   one edge          N = (x - v + sigma_1)/R              sigma_2 + sigma_1^2 - 2 v sigma_1 = 2 P R/pi
//   two edges         N = ((x - v)(x + sigma_1) + (sigma_2 + sigma_1^2)/2)/R - P/pi
//
// Each is put into F = psi' - Y N with Y by binomial series, for 0 to 4 jumps.

constexpr std::size_t parabola_jumps = 4;

struct Setting {
  Setting(EndKind left, EndKind right)
      : left(left), right(right), data(FundamentalSolution(left, right, parabola_jumps)) {}
  EndKind left;
  EndKind right;
  ContactSymbols data;
  symbol radius{"R"};
  symbol vertex{"v"};
  std::vector<ex> slope{-vertex / radius, 1 / radius};
};

struct Contact {
  std::vector<ex> powers;
  std::vector<ex> places;
  std::vector<ex> sums;    // sigma_1, sigma_2
  std::vector<ex> series;  // of Y, by binomials
};

Contact contact(const Setting& setting, std::size_t jumps, int beta) {
  const FundamentalSolution y(setting.left, setting.right, jumps);
  Contact c;
  c.powers = setting.data.powers(y);
  const auto count = static_cast<std::ptrdiff_t>(c.powers.size());
  c.places.assign(setting.data.places.begin(), setting.data.places.begin() + count);
  c.series = binomial_product(c.powers, c.places, 3);
  for (std::size_t j = 1; j + 1 < c.powers.size(); ++j) c.powers[j] *= beta;
  c.sums = power_sums(c.powers, c.places, 2);
  return c;
}

struct ParabolaVariant {
  int beta = 1;         // sign of beta in the equations
  int factor = 2;       // of P R/pi
  int n_sign = 1;       // of N's first term
  bool squared = true;  // sigma_1^2 with sigma_2; about the vertex
};

DecidedStatement free_ends() {
  const Setting setting(EndKind::free, EndKind::free);
  const ContactSymbols& data = setting.data;
  const auto decided = [&](const std::string& words, const ParabolaVariant& variant) {
    Comparison comparison(data.field);
    for (std::size_t jumps = 0; jumps <= parabola_jumps; ++jumps) {
      const Contact c = contact(setting, jumps, variant.beta);
      // The two equations, as stated; in them v is the vertex and P the load that they give.
      std::vector<ex> distances;
      for (const ex& place : c.places) distances.push_back(place - setting.vertex);
      const std::vector<ex> about = power_sums(c.powers, variant.squared ? distances : c.places, 2);
      const ex load_over_pi = about[1] / (variant.factor * setting.radius);
      const ex vertex = variant.n_sign * c.sums[0];
      std::vector<ex> slope = setting.slope;
      for (ex& coefficient : slope) coefficient = coefficient.subs(setting.vertex == vertex);
      compare_decay(comparison, std::to_string(jumps) + " jumps: ", 1, slope, {1 / setting.radius}, c.series,
                    load_over_pi.subs(setting.vertex == vertex));
    }
    // And for any number of jumps: with the power sums about the vertex as symbols.
    const std::vector<ex> sums = power_sum_symbols(2);
    const ex load = sums[1] / (variant.factor * setting.radius);
    const PolynomialSlope any(1, {0, 1 / setting.radius}, sums, load);
    return comparison.equal("any number of jumps: N", any.factor(data.x), 1 / setting.radius)
        .equal("c_1", any.conditions()[0], variant.n_sign * sums[0] / setting.radius)
        .equal("c_2 - P/pi where sigma_1 = 0", any.conditions()[1].subs(sums[0] == 0), 0)
        .as(words);
  };
  return {
      "rh-parabola-jumps",
      decided("parabola with jumps, free ends: N = 1/R if and only if sum p r = 0 and sum p r^2 = 2 P R/pi, r from the "
              "vertex",
              {}),
      {decided("beta of the other sign", {.beta = -1}), decided("sum p r^2 = P R/pi", {.factor = 1}),
       decided("sum p r of the other sign", {.n_sign = -1}), decided("r^2 not from the vertex", {.squared = false})}};
}

DecidedStatement one_edge(const std::string& id, const std::string& words, EndKind left, EndKind right) {
  const Setting setting(left, right);
  const ContactSymbols& data = setting.data;
  const auto decided = [&](const std::string& statement, const ParabolaVariant& variant) {
    Comparison comparison(data.field);
    for (std::size_t jumps = 0; jumps <= parabola_jumps; ++jumps) {
      const Contact c = contact(setting, jumps, variant.beta);
      const ex square = variant.squared ? c.sums[0] * c.sums[0] : ex(0);
      const ex load_over_pi = (c.sums[1] + square - 2 * setting.vertex * c.sums[0]) / (variant.factor * setting.radius);
      const std::vector<ex> factor{(variant.n_sign * c.sums[0] - setting.vertex) / setting.radius, 1 / setting.radius};
      compare_decay(comparison, std::to_string(jumps) + " jumps: ", 0, setting.slope, factor, c.series, load_over_pi);
      const PolynomialSlope derived(0, setting.slope, c.sums, load_over_pi);
      comparison.equal("N derived", derived.factor(data.x), factor[0] + factor[1] * data.x);
    }
    return comparison.as(statement);
  };
  return {id,
          decided(words, {}),
          {decided("beta of the other sign", {.beta = -1}), decided("P R/pi for 2 P R/pi", {.factor = 1}),
           decided("N = (x - v - sigma_1)/R", {.n_sign = -1}), decided("without sigma_1^2", {.squared = false})}};
}

DecidedStatement two_edges() {
  const Setting setting(EndKind::edge, EndKind::edge);
  const ContactSymbols& data = setting.data;
  const auto decided = [&](const std::string& statement, const ParabolaVariant& variant, int load_sign) {
    Comparison comparison(data.field);
    for (std::size_t jumps = 0; jumps <= parabola_jumps; ++jumps) {
      const Contact c = contact(setting, jumps, variant.beta);
      const ex first = variant.n_sign * c.sums[0];
      const ex half = (c.sums[1] + (variant.squared ? c.sums[0] * c.sums[0] : ex(0))) / variant.factor;
      const ex load = data.load / data.pi;
      const std::vector<ex> factor{(half - setting.vertex * first) / setting.radius + load_sign * load,
                                   (first - setting.vertex) / setting.radius, 1 / setting.radius};
      compare_decay(comparison, std::to_string(jumps) + " jumps: ", -1, setting.slope, factor, c.series, load);
    }
    return comparison.as(statement);
  };
  return {"rh-parabola-two-edges",
          decided("parabola in full contact: N = ((x - v)(x + sigma_1) + (sigma_2 + sigma_1^2)/2)/R - P/pi", {}, -1),
          {decided("beta of the other sign", {.beta = -1}, -1), decided("without the 1/2", {.factor = 1}, -1),
           decided("x - sigma_1", {.n_sign = -1}, -1), decided("without sigma_1^2", {.squared = false}, -1),
           decided("the load's other sign", {}, 1)}};
}

}  // namespace

void add_parabola(std::vector<DecidedStatement>& all) {
  all.push_back(zone());
  all.push_back(parabola_traction());
  all.push_back(free_ends());
  all.push_back(
      one_edge("rh-parabola-left-edge",
               "parabola against a left edge: N = (x - v + sigma_1)/R, sigma_2 + sigma_1^2 - 2 v sigma_1 = 2 P R/pi",
               EndKind::edge, EndKind::free));
  all.push_back(
      one_edge("rh-parabola-right-edge",
               "parabola against a right edge: N = (x - v + sigma_1)/R, sigma_2 + sigma_1^2 - 2 v sigma_1 = 2 P R/pi",
               EndKind::free, EndKind::edge));
  all.push_back(two_edges());
}

}  // namespace steadyslide::symbolic
