// The flat punch tilted by delta: psi' = delta, t = cos(pi alpha) |Y| (delta (x + sigma_1) - P/pi) as long as both
// edges carry. The right edge lifts at delta = P/(pi (b + sigma_1)), the left one at delta = P/(pi (a + sigma_1)).

#include "symbolic/riemann_hilbert/contact_symbols.hpp"

namespace steadyslide::symbolic {
namespace {

using GiNaC::ex;

constexpr std::size_t most_jumps = 4;

/// Putting N into F = delta - Y N, with Y by binomial series.
DecidedStatement traction() {
  struct Variant {
    int order_sign = 1;  // of sigma_1
    int load_sign = -1;
    int beta = 1;
    bool pi = true;
    bool exchanged = false;
  };
  const auto decided = [&](const std::string& words, const Variant& variant) {
    const ContactSymbols data(one_contact(EndKind::edge, EndKind::edge, most_jumps));
    const GiNaC::symbol delta("delta");
    Comparison comparison(data.field);
    for (std::size_t jumps = 0; jumps <= most_jumps; ++jumps) {
      const FundamentalSolution y = one_contact(EndKind::edge, EndKind::edge, jumps);
      const std::vector<ex> powers = data.powers(y);
      const std::vector<ex> series = binomial_product(
          powers, {data.places.begin(), data.places.begin() + static_cast<std::ptrdiff_t>(powers.size())}, 2);
      ex sum = 0;  // sigma_1, as the statement writes it
      for (std::size_t j = 0; j < powers.size(); ++j) {
        const bool is_jump = y.points()[j].kind == PointKind::jump;
        sum += (is_jump ? variant.beta : 1) * powers[variant.exchanged ? powers.size() - 1 - j : j] * data.places[j];
      }
      const std::vector<ex> factor{
          delta * variant.order_sign * sum + variant.load_sign * data.load / (variant.pi ? ex(data.pi) : ex(1)), delta};
      const std::string name = std::to_string(jumps) + " jumps, z^";
      comparison.equal(name + "0", field_coefficient(-1, {delta}, factor, series, 0), 0);
      comparison.equal(name + "-1", field_coefficient(-1, {delta}, factor, series, -1), data.load / data.pi);
      const PolynomialSlope derived(-1, {delta}, data.sums(y, 2), data.load / data.pi);
      comparison.equal(std::to_string(jumps) + " jumps: N", derived.factor(data.x), factor[0] + factor[1] * data.x);
    }
    return comparison.as(words);
  };
  return {"rh-tilted-punch",
          decided("psi' = delta in full contact: N = delta (x + sigma_1) - P/pi, with 0 to 4 jumps", {}),
          {decided("N = delta (x - sigma_1) - P/pi", {.order_sign = -1}),
           decided("the load's other sign", {.load_sign = 1}), decided("beta of the other sign", {.beta = -1}),
           decided("without 1/pi", {.pi = false}), decided("edges exchanged", {.exchanged = true})}};
}

/// At the tilt at which an edge lifts, t is the solution with a free end there.
DecidedStatement lifting(const std::string& id, bool right) {
  const std::string side = right ? "right" : "left";
  struct Variant {
    int sign = 1;
    bool other_end = false;
    bool pi = true;
    ex factor = 1;
    bool no_sum = false;
  };
  const auto decided = [&](const std::string& words, const Variant& variant) {
    const ContactSymbols data(one_contact(EndKind::edge, EndKind::edge, most_jumps));
    Comparison comparison(data.field);
    for (std::size_t jumps = 0; jumps <= most_jumps; ++jumps) {
      const FundamentalSolution edges = one_contact(EndKind::edge, EndKind::edge, jumps);
      const FundamentalSolution lifted =
          one_contact(right ? EndKind::edge : EndKind::free, right ? EndKind::free : EndKind::edge, jumps);
      const std::size_t j = right ? jumps + 1 : 0;
      const ex sum = data.sums(edges, 1)[0];
      const ex end = data.places[variant.other_end ? jumps + 1 - j : j];
      const ex delta = variant.sign * variant.factor * data.load /
                       ((variant.pi ? ex(data.pi) : ex(1)) * (end + (variant.no_sum ? ex(0) : sum)));
      const std::string name = std::to_string(jumps) + " jumps: ";
      const PolynomialSlope contact(-1, {delta}, data.sums(edges, 2), data.load / data.pi);
      comparison.equal(name + "N", contact.factor(data.x), delta * (data.x - data.places[j]));
      const PolynomialSlope free(0, {delta}, data.sums(lifted, 1), data.load / data.pi);
      comparison.equal(name + "free end's condition", free.conditions()[0], 0);
      comparison.equal(name + "power", expression(lifted.points()[j].power, data.alpha),
                       expression(edges.points()[j].power, data.alpha) + 1);
      comparison.equal(name + "same t", contact.factor(data.x), free.factor(data.x) * (data.x - data.places[j]));
    }
    return comparison.as(words);
  };
  const std::string end = right ? "b" : "a";
  return {id,
          decided("the " + side + " edge lifts at delta = P/(pi (" + end +
                      " + sigma_1)): t is then the traction of a free end there",
                  {}),
          {decided("the other sign", {.sign = -1}), decided("the other end", {.other_end = true}),
           decided("without pi", {.pi = false}), decided("half of it", {.factor = ex(1) / 2}),
           decided("without sigma_1", {.no_sum = true})}};
}

/// [-1, 1], no jump: P/(pi (1 + 2 alpha)) and -P/(pi (1 - 2 alpha)).
DecidedStatement lifting_on_unit() {
  const FundamentalSolution y = one_contact(EndKind::edge, EndKind::edge, 0);
  const ContactSymbols data(y);
  const ex alpha = data.alpha[0];
  const auto decided = [&](const std::string& words, const ex& at_right, const ex& at_left) {
    const std::vector<ex> sums = power_sums(data.powers(y), {-1, 1}, 2);
    const ex load = data.load / data.pi;
    return Comparison(data.field)
        .equal("right", PolynomialSlope(-1, {at_right}, sums, load).factor(1), 0)
        .equal("left", PolynomialSlope(-1, {at_left}, sums, load).factor(-1), 0)
        .as(words);
  };
  const ex p = data.load / data.pi;
  return {"rh-tilted-punch-unit",
          decided("on [-1, 1] the edges lift at delta = P/(pi (1+2 alpha)) and -P/(pi (1-2 alpha))",
                  p / (1 + 2 * alpha), -p / (1 - 2 * alpha)),
          {decided("exchanged", p / (1 - 2 * alpha), -p / (1 + 2 * alpha)),
           decided("alpha for 2 alpha", p / (1 + alpha), -p / (1 - alpha)), decided("P/pi and -P/pi", p, -p),
           decided("both positive", p / (1 + 2 * alpha), p / (1 - 2 * alpha))}};
}

}  // namespace

void add_tilted_punch(std::vector<DecidedStatement>& all) {
  all.push_back(traction());
  all.push_back(lifting("rh-lifting-right", true));
  all.push_back(lifting("rh-lifting-left", false));
  all.push_back(lifting_on_unit());
}

}  // namespace steadyslide::symbolic
