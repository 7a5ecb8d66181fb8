// Signs and places of the closed forms: where edges lift, that the quartic's pressure has one sign, where |t| is extreme
// under a flat punch, on which side the surface is beyond the contact; the two small computations of theorem 10's proof.

#include "symbolic/statements/contact_symbols.hpp"

namespace steadyslide::symbolic {
namespace {

using GiNaC::ex;
using GiNaC::symbol;

constexpr std::size_t window_jumps = 4;

/// b + sigma_1 = sum (1/2 + alpha_k)(e_(k+1) - e_k) > 0 > a + sigma_1 = -sum (1/2 - alpha_k)(e_(k+1) - e_k).
DecidedStatement tilt_window() {
  const ContactSymbols data(FundamentalSolution(EndKind::edge, EndKind::edge, window_jumps + 1));
  const ex half = ex(1) / 2;
  const auto decided = [&](const std::string& words, int angle, const ex& weight, int beta) {
    Comparison comparison(data.field);
    const auto sums = [&](std::size_t jumps, const std::vector<ex>& places) {
      const FundamentalSolution y(EndKind::edge, EndKind::edge, jumps);
      ex first = 0;
      ex right = 0;
      ex left = 0;
      const std::vector<ex> powers = data.powers(y);
      for (std::size_t j = 0; j < powers.size(); ++j) {
        first += (j == 0 || j == jumps + 1 ? 1 : beta) * powers[j] * places[j];
        if (j == 0) continue;
        right += (weight + angle * data.alpha[j - 1]) * (places[j] - places[j - 1]);
        left -= (weight - angle * data.alpha[j - 1]) * (places[j] - places[j - 1]);
      }
      return std::vector<ex>{places[jumps + 1] + first - right, places[0] + first - left};
    };
    for (std::size_t jumps = 0; jumps <= window_jumps; ++jumps) {
      const std::vector<ex> both = sums(jumps, data.places);
      const std::string name = std::to_string(jumps) + " jumps: ";
      comparison.equal(name + "b + sigma_1", both[0], 0).equal(name + "a + sigma_1", both[1], 0);
    }
    // One more jump, at c before the right edge b: what changes is next to b, whatever is on its left.
    const ex& before = data.alpha[0];
    const ex& after = data.alpha[1];
    const ex& c = data.places[0];
    const ex& b = data.places[1];
    const ex change = beta * (before - after) * c + (after - before) * b;
    return comparison.equal("one more jump, b + sigma_1", change, angle * (after - before) * (b - c))
        .equal("one more jump, a + sigma_1", change, angle * (after - before) * (b - c))
        .as(words);
  };
  return {"rh-tilt-window",
          decided("edges at a and b: b + sigma_1 = sum (1/2 + alpha_k)(e_(k+1) - e_k), a + sigma_1 = -sum (1/2 - "
                  "alpha_k)(e_(k+1) - e_k), for any number of jumps",
                  1, half, 1),
          {decided("alpha of the other sign", -1, half, 1), decided("without alpha", 0, half, 1),
           decided("1 + alpha", 1, 1, 1), decided("beta of the other sign", 1, half, -1)}};
}

/// Off one component Y is positive on its right and (-1)^S |Y| on its left, S = 1 for two free ends, -1 for two edges.
DecidedStatement outside_signs() {
  const auto decided = [&](const std::string& words, int free_left, int edge_left, int order, int beta) {
    const PhaseField field(symbols("s", 3));
    Comparison comparison(field);
    for (const std::size_t jumps : {0U, 1U, 2U}) {
      for (const EndKind end : {EndKind::free, EndKind::edge}) {
        FundamentalSolution y(end, end, jumps);
        if (beta < 0 && jumps == 1) y = y.with_powers({y.points()[0].power, -y.points()[1].power, y.points()[2].power});
        const std::string name =
            std::to_string(jumps) + (end == EndKind::free ? " jumps, free ends: " : " jumps, edges: ");
        comparison.equal(name + "right", field.phase(y.regions().back().sigma, 1), 1)
            .equal(name + "left", field.phase(y.regions().front().sigma, 1),
                   end == EndKind::free ? free_left : edge_left)
            .equal(name + "order", expression(y.power_sum(), symbols("alpha", 3)),
                   end == EndKind::free ? order : -order);
      }
    }
    return comparison.as(words);
  };
  return {
      "rh-outside-signs",
      decided(
          "off one component with two free ends or two edges Y is |Y| on the right and -|Y| on the left, of order 1 "
          "and -1, with 0 to 2 jumps",
          -1, -1, 1, 1),
      {decided("positive on both sides of free ends", 1, -1, 1, 1),
       decided("positive on both sides of edges", -1, 1, 1, 1), decided("order 2", -1, -1, 2, 1),
       decided("beta of the other sign", -1, -1, 1, -1)}};
}

/// The slope k in full contact on [-1, 1] [Bal16, proof of theorem 10]; t0 = cos(pi alpha) |Y|/pi.
DecidedStatement linear_profile() {
  const FundamentalSolution y(EndKind::edge, EndKind::edge, 0);
  const ContactSymbols data(y);
  const symbol k("k");
  const ex& alpha = data.alpha[0];
  const auto decided = [&](const std::string& words, const ex& a, const ex& b) {
    const PolynomialSlope solution(-1, {k}, power_sums(data.powers(y), {-1, 1}, 2), 0);
    return Comparison(data.field)
        .equal("t over cos |Y|", solution.factor(data.x) * y.sign_on(data.field, y.regions()[1]),
               (a + b * (1 + data.x)) / data.pi)
        .as(words);
  };
  const ex a = -data.pi * k * (1 - 2 * alpha);
  const ex b = data.pi * k;
  return {"rh-linear-profile",
          decided("psi' = k without load: t = (a + b (1+x)) t0, a = -pi k (1 - 2 alpha), b = pi k", a, b),
          {decided("1 + 2 alpha", -data.pi * k * (1 + 2 * alpha), b), decided("a of the other sign", -a, b),
           decided("without pi", a / data.pi, b / data.pi), decided("without a", 0, b)}};
}

}  // namespace

void add_shapes(std::vector<DecidedStatement>& all) {
  all.push_back(tilt_window());
  all.push_back(outside_signs());
  all.push_back(linear_profile());
}

}  // namespace steadyslide::symbolic
