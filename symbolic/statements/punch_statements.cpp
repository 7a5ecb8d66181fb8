// The flat punch in full contact. The formulas are put into A t = 0 as they are printed: exponents and amplitudes are
// data here, and what they must satisfy is Y+ = G Y- and the load. [Bal16, (4), (5)-(7), (8)]

#include <algorithm>

#include "symbolic/statements/contact_symbols.hpp"

namespace steadyslide::symbolic {
namespace {

using GiNaC::ex;
using GiNaC::symbol;

/// t = amplitude_k prod |x - e_j|^{power_j} on panel k.
struct Printed {
  std::vector<AngleForm> powers;
  std::vector<ex> amplitudes;
};

/// A t = 0 and int t = total; and the derived solution is the same.
ExactIdentity decided(const std::string& words, const ContactSymbols& data, const FundamentalSolution& y,
                      const Printed& printed, const ex& total) {
  const PhaseField& field = data.field;
  const FundamentalSolution candidate = y.with_powers(printed.powers);
  Comparison comparison(field);
  candidate.compare(comparison, field);
  comparison.equal("order at infinity", expression(candidate.power_sum(), data.alpha), -1);
  // F = C Y with C/z at infinity: C = -(int t)/pi, and t = (F+ - F-)/(2i).
  const ex constant = -total / data.pi;
  const ex factor = PolynomialSlope(-1, {}, {}, -total / data.pi).factor(data.x);
  for (std::size_t j = 0; j < y.regions().size(); ++j) {
    const auto& region = candidate.regions()[j];
    if (!region.friction) continue;
    const std::size_t k = *region.friction;
    const std::string panel = "panel " + std::to_string(k) + ": ";
    const ex sine = (field.phase(region.sigma, 1) - field.phase(region.sigma, -1)) / (2 * field.i());
    comparison.equal(panel + "t from F", printed.amplitudes[k], constant * sine);
    comparison.equal(panel + "t derived", printed.amplitudes[k],
                     y.sign_on(field, y.regions()[j]) * field.friction(k).cos * factor);
  }
  for (std::size_t j = 0; j < y.points().size(); ++j) {
    comparison.equal("power " + std::to_string(j), expression(printed.powers[j], data.alpha),
                     expression(y.points()[j].power, data.alpha));
  }
  return comparison.as(words);
}

/// -P cos(pi alpha)/pi times the powers -(1/2+alpha_0), alpha_(k-1) - alpha_k, ..., -(1/2-alpha_m).
Printed punch(const ContactSymbols& data, std::size_t jumps, const ex& total) {
  Printed printed;
  printed.powers.emplace_back(-1, std::map<std::size_t, int>{{0, -1}});
  for (std::size_t k = 1; k <= jumps; ++k) printed.powers.push_back(AngleForm(0, {{k - 1, 1}, {k, -1}}));
  printed.powers.emplace_back(-1, std::map<std::size_t, int>{{jumps, 1}});
  for (std::size_t k = 0; k <= jumps; ++k) {
    printed.amplitudes.push_back(total / (data.pi * data.field.friction(k).r));
  }
  return printed;
}

DecidedStatement flat_punch(const std::string& id, const std::string& words, std::size_t jumps, bool unit) {
  const FundamentalSolution y(EndKind::edge, EndKind::edge, jumps);
  const ContactSymbols data(y);
  const ex total = unit ? ex(1) : ex(-data.load);
  const Printed right = punch(data, jumps, total);
  DecidedStatement result{id, decided(words, data, y, right, total), {}};
  const auto control = [&](const std::string& statement, const auto& spoil) {
    Printed wrong = right;
    spoil(wrong);
    result.controls.push_back(decided(statement, data, y, wrong, total));
  };
  const auto scale = [&](Printed& wrong, const auto& by) {
    for (std::size_t k = 0; k <= jumps; ++k) wrong.amplitudes[k] *= by(k);
  };
  control("edges exchanged", [](Printed& wrong) { std::swap(wrong.powers.front(), wrong.powers.back()); });
  control("every alpha of the other sign", [](Printed& wrong) {
    for (AngleForm& power : wrong.powers) power = power.mirrored();
  });
  control("1/2 for 1/2 + alpha at the left edge", [](Printed& wrong) { wrong.powers.front() = AngleForm(-1); });
  control("without 1/sqrt(1+s^2)",
          [&](Printed& wrong) { scale(wrong, [&](std::size_t k) { return data.field.friction(k).r; }); });
  control("without 1/pi", [&](Printed& wrong) { scale(wrong, [&](std::size_t) { return ex(data.pi); }); });
  control("t of the other sign", [&](Printed& wrong) { scale(wrong, [](std::size_t) { return ex(-1); }); });
  if (jumps > 0) {
    control("beta of the other sign", [](Printed& wrong) { wrong.powers[1] = -wrong.powers[1]; });
    control("cos(pi alpha) of one side on both", [](Printed& wrong) { wrong.amplitudes[0] = wrong.amplitudes[1]; });
  }
  return result;
}

// The flat punch tilted by delta: psi' = delta, t = cos(pi alpha) |Y| (delta (x + sigma_1) - P/pi) as long as both
// edges carry. The right edge lifts at delta = P/(pi (b + sigma_1)), the left one at delta = P/(pi (a + sigma_1)).

constexpr std::size_t punch_jumps = 4;

/// Putting N into F = delta - Y N, with Y by binomial series.
DecidedStatement punch_traction() {
  struct Variant {
    int order_sign = 1;  // of sigma_1
    int load_sign = -1;
    int beta = 1;
    bool pi = true;
    bool exchanged = false;
  };
  const auto decided = [&](const std::string& words, const Variant& variant) {
    const ContactSymbols data(FundamentalSolution(EndKind::edge, EndKind::edge, punch_jumps));
    const GiNaC::symbol delta("delta");
    Comparison comparison(data.field);
    for (std::size_t jumps = 0; jumps <= punch_jumps; ++jumps) {
      const FundamentalSolution y(EndKind::edge, EndKind::edge, jumps);
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
    const ContactSymbols data(FundamentalSolution(EndKind::edge, EndKind::edge, punch_jumps));
    Comparison comparison(data.field);
    for (std::size_t jumps = 0; jumps <= punch_jumps; ++jumps) {
      const FundamentalSolution edges(EndKind::edge, EndKind::edge, jumps);
      const FundamentalSolution lifted =
          FundamentalSolution(right ? EndKind::edge : EndKind::free, right ? EndKind::free : EndKind::edge, jumps);
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
  const FundamentalSolution y(EndKind::edge, EndKind::edge, 0);
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

void add_flat_punch(std::vector<DecidedStatement>& all) {
  all.push_back(
      flat_punch("rh-flat-punch-0", "[Bal16, (4)] solves A t = 0, int t = -P, and is what is derived", 0, false));
  all.push_back(
      flat_punch("rh-flat-punch-1", "[Bal16, (5)-(7)] solves A t = 0, int t = -P, and is what is derived", 1, false));
  all.push_back(flat_punch("rh-kernel", "t0 of [Bal16, (8)] has A t0 = 0 and int t0 = 1", 0, true));
  for (std::size_t jumps = 2; jumps <= 4; ++jumps) {
    const std::string count = std::to_string(jumps);
    all.push_back(flat_punch("rh-flat-punch-" + count,
                             "the flat punch with " + count + " jumps solves A t = 0, int t = -P", jumps, false));
  }
  all.push_back(punch_traction());
  all.push_back(lifting("rh-lifting-right", true));
  all.push_back(lifting("rh-lifting-left", false));
  all.push_back(lifting_on_unit());
}

}  // namespace steadyslide::symbolic
