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

/// B = delta (x + sigma_1) - P/pi by its values at the edges a and b, which are 0 at the ends of the window.
DecidedStatement tilt_linear() {
  const PhaseField field;
  const symbol x("x"), a("a"), b("b"), sigma("sigma_1"), delta("delta"), load("P"), pi("pi");
  const auto decided = [&](const std::string& words, const ex& left, const ex& right, int sign) {
    const auto factor = [&](const ex& at) -> ex { return delta * (at + sigma) - load / pi; };
    Comparison comparison(field);
    comparison.equal("(b - a) B", (b - a) * factor(x), left * factor(a) + right * factor(b));
    for (const ex& edge : {ex(a), ex(b)}) {
      const ex limit = sign * pi * delta * (edge + sigma);
      comparison.equal("B at its limit", factor(x).subs(load == limit), delta * (x - edge));
    }
    return comparison.as(words);
  };
  return {
      "rh-tilt-linear",
      decided("(b-a) B(x) = (b-x) B(a) + (x-a) B(b), and B(x) = delta (x-a) where P = pi delta (a + sigma_1); the same "
              "at b",
              b - x, x - a, 1),
      {decided("weights exchanged", x - a, b - x, 1), decided("B(a) alone", b - a, 0, 1),
       decided("P = -pi delta (a + sigma_1)", b - x, x - a, -1), decided("the sum", b + x, x + a, 1)}};
}

/// 2 (x^2 + sigma_1 x + h_2) = x^2 + (x + sigma_1)^2 + sigma_2, and the cubic of the middle rises where |alpha| < 1/2.
DecidedStatement quartic_squares() {
  const PhaseField field;
  const symbol x("x");
  const symbol u("u");
  const symbol a("alpha");
  const symbol l("e_0");
  const symbol r("e_1");
  const std::vector<ex> s = power_sum_symbols(2);
  const ex cubic = 6 * u * u * u + 36 * a * u * u + (36 * a * a + 9) * u + 8 * a * a * a + 10 * a;
  const auto decided = [&](const std::string& words, int square, const ex& two, const ex& rest, const ex& positive) {
    const ex n = x * x + s[0] * x + (s[1] + s[0] * s[0]) / 2;
    const std::vector<ex> sums = power_sums({ex(1) / 2 - a, ex(1) / 2 + a}, {l, r}, 2);
    return Comparison(field)
        .equal("N", 2 * n, x * x + square * GiNaC::pow(x + s[0], 2) + s[1])
        .equal("derivative", cubic.diff(u), 18 * GiNaC::pow(u + two * a, 2) + rest * (1 - 4 * a * a))
        .equal("sigma_2", sums[1], positive)
        .as(words);
  };
  const ex positive = (1 - 2 * a) / 2 * l * l + (1 + 2 * a) / 2 * r * r;
  return {
      "rh-quartic-signs",
      decided("2 N/kappa = x^2 + (x + sigma_1)^2 + sigma_2, sigma_2 = (1/2 - alpha) e_0^2 + (1/2 + alpha) e_1^2; the "
              "cubic's derivative is 18 (u + 2 alpha)^2 + 9 (1 - 4 alpha^2)",
              1, 2, 9, positive),
      {decided("- (x + sigma_1)^2", -1, 2, 9, positive), decided("(u + alpha)^2", 1, 1, 9, positive),
       decided("18 (1 - 4 alpha^2)", 1, 2, 18, positive),
       decided("sigma_2 with its powers exchanged", 1, 2, 9, positive.subs(a == -a))}};
}

/// (d log|t|/dx) x (1 - x^2) under the punch of figure 4, and under that of figure 3 times 1 - x^2.
DecidedStatement punch_extremes() {
  const PhaseField field;
  const symbol x("x");
  const symbol l("alpha_l");
  const symbol r("alpha_r");
  const ex half = ex(1) / 2;
  const auto decided = [&](const std::string& words, const ex& quadratic, const ex& single) {
    const ex two = -(half + l) * x * (1 - x) + (l - r) * (1 - x * x) + (half - r) * x * (1 + x);
    const ex one = -(half + l) * (1 - x) + (half - l) * (1 + x);
    return Comparison(field)
        .equal("one jump", two, quadratic)
        .equal("no jump", one, x - single)
        .equal("at -1", quadratic.subs(x == -1), 1 + 2 * l)
        .equal("at 1", quadratic.subs(x == 1), 1 - 2 * r)
        .as(words);
  };
  const ex right = x * x - (l + r) * x + l - r;
  return {
      "rh-punch-extremes",
      decided(
          "|t| is extreme where x^2 - (alpha_l + alpha_r) x + beta = 0, without a jump at x = 2 alpha; the quadratic "
          "is 1 + 2 alpha_l at -1 and 1 - 2 alpha_r at 1",
          right, 2 * l),
      {decided("beta of the other sign", x * x - (l + r) * x - l + r, 2 * l),
       decided("the sum's other sign", x * x + (l + r) * x + l - r, 2 * l), decided("alpha", right, l),
       decided("-2 alpha", right, -2 * l)}};
}

/// With w = (1+x)/(1-x) the rear half of [-1, 1] is [0, 1], and (1+x)^(-(1/2+alpha)) (1-x)^(-(1/2-alpha)) dx is
/// w^(-(1/2+alpha))/(1+w) dw. Powers of w, of 1+w and of 2 are counted.
DecidedStatement rear_share() {
  const PhaseField field;
  const symbol w("w");
  const symbol alpha("alpha");
  const ex half = ex(1) / 2;
  const auto decided = [&](const std::string& words, const ex& x, const ex& rear, const ex& front) {
    return Comparison(field)
        .equal("1 + x", 1 + x, 2 * w / (1 + w))
        .equal("1 - x", 1 - x, 2 / (1 + w))
        .equal("dx/dw", x.diff(w), 2 / (1 + w) / (1 + w))
        .equal("power of w", rear, -half - alpha)
        .equal("power of 2/(1+w), with that of dx", rear + front + 2, 1)
        .equal("t(-x)/t(x), power of (1+x)/(1-x)", front - rear, 2 * alpha)
        .as(words);
  };
  const ex x = (w - 1) / (w + 1);
  return {"rh-rear-share",
          decided("with w = (1+x)/(1-x) the rear half's load is that of w^(-(1/2+alpha))/(1+w) on [0, 1]; t(-x)/t(x) = "
                  "((1+x)/(1-x))^(2 alpha)",
                  x, -half - alpha, -half + alpha),
          {decided("front and rear exchanged", x, -half + alpha, -half - alpha),
           decided("w = (1-x)/(1+x)", -x, -half - alpha, -half + alpha), decided("without alpha", x, -half, -half),
           decided("alpha of one sign in both powers", x, -half - alpha, -half - alpha)}};
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

/// (1+x') (1+x')^b = (1+x) (1+x')^b + (x'-x) (1+x')^b, over x' - x; m = (1+x')^b eta.
DecidedStatement splitting() {
  const PhaseField field;
  const symbol x("x");
  const symbol y("y");
  const symbol m("m");
  const auto decided = [&](const std::string& words, const ex& factor, const ex& rest) {
    return Comparison(field).equal("integrand", (1 + y) * m, factor * m + rest * m * (y - x)).as(words);
  };
  return {"rh-splitting",
          decided("(1+x')^(1+b)/(x'-x) = (1+x) (1+x')^b/(x'-x) + (1+x')^b", 1 + x, 1),
          {decided("1 - x", 1 - x, 1), decided("the rest subtracted", 1 + x, -1), decided("without the rest", 1 + x, 0),
           decided("1 + x'", 1 + y, 1)}};
}

}  // namespace

void add_shapes(std::vector<DecidedStatement>& all) {
  all.push_back(tilt_window());
  all.push_back(tilt_linear());
  all.push_back(quartic_squares());
  all.push_back(punch_extremes());
  all.push_back(rear_share());
  all.push_back(outside_signs());
  all.push_back(linear_profile());
  all.push_back(splitting());
}

}  // namespace steadyslide::symbolic
