// The parabola psi' = (x - v)/R with any number of jumps inside the contact, free or against edges.
//
//   both ends free    N = 1/R                              sum p r = v sum p = v,  sum p (r - v)^2 = 2 P R/pi
//   one edge          N = (x - v + sigma_1)/R              sigma_2 + sigma_1^2 - 2 v sigma_1 = 2 P R/pi
//   two edges         N = ((x - v)(x + sigma_1) + (sigma_2 + sigma_1^2)/2)/R - P/pi
//
// Each is put into F = psi' - Y N with Y by binomial series, for 0 to 4 jumps.

#include "symbolic/riemann_hilbert/contact_symbols.hpp"

namespace steadyslide::symbolic {
namespace {

using GiNaC::ex;
using GiNaC::symbol;

constexpr std::size_t most_jumps = 4;

struct Setting {
  Setting(EndKind left, EndKind right) : left(left), right(right), data(one_contact(left, right, most_jumps)) {}
  EndKind left;
  EndKind right;
  ContactSymbols data;
  symbol radius{"R"};
  symbol vertex{"v"};
};

struct Contact {
  std::vector<ex> powers;
  std::vector<ex> places;
  std::vector<ex> sums;    // sigma_1, sigma_2
  std::vector<ex> series;  // of Y, by binomials
};

Contact contact(const Setting& setting, std::size_t jumps, int beta) {
  const FundamentalSolution y = one_contact(setting.left, setting.right, jumps);
  Contact c;
  c.powers = setting.data.powers(y);
  const auto count = static_cast<std::ptrdiff_t>(c.powers.size());
  c.places.assign(setting.data.places.begin(), setting.data.places.begin() + count);
  c.series = binomial_product(c.powers, c.places, 3);
  for (std::size_t j = 1; j + 1 < c.powers.size(); ++j) c.powers[j] *= beta;
  c.sums = power_sums(c.powers, c.places, 2);
  return c;
}

struct Variant {
  int beta = 1;         // sign of beta in the equations
  int factor = 2;       // of P R/pi
  int n_sign = 1;       // of N's first term
  bool squared = true;  // sigma_1^2 with sigma_2; about the vertex
};

DecidedStatement free_ends() {
  const Setting setting(EndKind::free, EndKind::free);
  const ContactSymbols& data = setting.data;
  const auto decided = [&](const std::string& words, const Variant& variant) {
    Comparison comparison(data.field);
    for (std::size_t jumps = 0; jumps <= most_jumps; ++jumps) {
      const Contact c = contact(setting, jumps, variant.beta);
      // The two equations, as stated; in them v is the vertex and P the load that they give.
      std::vector<ex> distances;
      for (const ex& place : c.places) distances.push_back(place - setting.vertex);
      const std::vector<ex> about = power_sums(c.powers, variant.squared ? distances : c.places, 2);
      const ex load_over_pi = about[1] / (variant.factor * setting.radius);
      const ex vertex = variant.n_sign * c.sums[0];
      const std::vector<ex> slope{-setting.vertex / setting.radius, 1 / setting.radius};
      const auto field_at = [&](int power) {
        return field_coefficient(1, slope, {1 / setting.radius}, c.series, power).subs(setting.vertex == vertex);
      };
      const std::string name = std::to_string(jumps) + " jumps: F, z^";
      comparison.equal(name + "1", field_at(1), 0);
      comparison.equal(name + "0", field_at(0), 0);
      comparison.equal(name + "-1", field_at(-1), load_over_pi.subs(setting.vertex == vertex));
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
      decided("parabola with jumps, free ends: N = 1/R if and only if sum p r = 0 and sum p r^2 = 2 P R/pi, r from "
              "the vertex",
              {}),
      {decided("beta of the other sign", {.beta = -1}), decided("sum p r^2 = P R/pi", {.factor = 1}),
       decided("sum p r of the other sign", {.n_sign = -1}), decided("r^2 not from the vertex", {.squared = false})}};
}

DecidedStatement one_edge(const std::string& id, const std::string& words, EndKind left, EndKind right) {
  const Setting setting(left, right);
  const ContactSymbols& data = setting.data;
  const auto decided = [&](const std::string& statement, const Variant& variant) {
    Comparison comparison(data.field);
    for (std::size_t jumps = 0; jumps <= most_jumps; ++jumps) {
      const Contact c = contact(setting, jumps, variant.beta);
      const ex square = variant.squared ? c.sums[0] * c.sums[0] : ex(0);
      const ex load_over_pi = (c.sums[1] + square - 2 * setting.vertex * c.sums[0]) / (variant.factor * setting.radius);
      const std::vector<ex> factor{(variant.n_sign * c.sums[0] - setting.vertex) / setting.radius, 1 / setting.radius};
      const std::vector<ex> slope{-setting.vertex / setting.radius, 1 / setting.radius};
      const std::string name = std::to_string(jumps) + " jumps: F, z^";
      for (int power = 1; power >= -1; --power) {
        comparison.equal(name + std::to_string(power), field_coefficient(0, slope, factor, c.series, power),
                         power == -1 ? load_over_pi : ex(0));
      }
      const PolynomialSlope derived(0, slope, c.sums, load_over_pi);
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
  const auto decided = [&](const std::string& statement, const Variant& variant, int load_sign) {
    Comparison comparison(data.field);
    for (std::size_t jumps = 0; jumps <= most_jumps; ++jumps) {
      const Contact c = contact(setting, jumps, variant.beta);
      const ex first = variant.n_sign * c.sums[0];
      const ex half = (c.sums[1] + (variant.squared ? c.sums[0] * c.sums[0] : ex(0))) / variant.factor;
      const ex load = data.load / data.pi;
      const std::vector<ex> factor{(half - setting.vertex * first) / setting.radius + load_sign * load,
                                   (first - setting.vertex) / setting.radius, 1 / setting.radius};
      const std::vector<ex> slope{-setting.vertex / setting.radius, 1 / setting.radius};
      const std::string name = std::to_string(jumps) + " jumps: F, z^";
      for (int power = 1; power >= -1; --power) {
        comparison.equal(name + std::to_string(power), field_coefficient(-1, slope, factor, c.series, power),
                         power == -1 ? load : ex(0));
      }
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

void add_jump_parabola(std::vector<DecidedStatement>& all) {
  all.push_back(free_ends());
  all.push_back(
      one_edge("rh-parabola-left-edge",
               "parabola against a left edge: N = (x - v + sigma_1)/R, sigma_2 + sigma_1^2 - 2 v sigma_1 = 2 P "
               "R/pi",
               EndKind::edge, EndKind::free));
  all.push_back(
      one_edge("rh-parabola-right-edge",
               "parabola against a right edge: N = (x - v + sigma_1)/R, sigma_2 + sigma_1^2 - 2 v sigma_1 = 2 P "
               "R/pi",
               EndKind::free, EndKind::edge));
  all.push_back(two_edges());
}

}  // namespace steadyslide::symbolic
