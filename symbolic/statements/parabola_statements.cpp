// Galin's parabola psi = x^2/(2R) [Bal16, section 2]: with free ends and constant friction, as it is printed.

#include "symbolic/riemann_hilbert/contact_symbols.hpp"

namespace steadyslide::symbolic {
namespace {

using GiNaC::ex;
using GiNaC::symbol;

struct Galin {
  FundamentalSolution y = one_contact(EndKind::free, EndKind::free, 0);
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

DecidedStatement peak() {
  const Galin g;
  const auto decided = [&](const std::string& words, const ex& x) {
    const ex l = -(1 + 2 * g.alpha) * g.a;
    const ex b = (1 - 2 * g.alpha) * g.a;
    return Comparison(g.data.field).equal("d log(-t)/dx", g.powers[0] / (x - l) + g.powers[1] / (x - b), 0).as(words);
  };
  return {"rh-parabola-peak",
          decided("the pressure peaks at x = -4 alpha a", -4 * g.alpha * g.a),
          {decided("4 alpha a", 4 * g.alpha * g.a), decided("-2 alpha a, the middle", -2 * g.alpha * g.a),
           decided("0", 0), decided("-alpha a", -g.alpha * g.a)}};
}

/// Both printed amplitudes, by substitution: F = x/R - Y N with N = 1/R.
DecidedStatement traction() {
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
    const ex sine = (phase(g.data.field, sigma, 1) - phase(g.data.field, sigma, -1)) / (2 * g.data.field.i());
    for (int power = 1; power >= -1; --power) {
      comparison.equal("F, z^" + std::to_string(power), field_coefficient(1, slope, {1 / g.radius}, series, power),
                       power == -1 ? g.load / g.data.pi : ex(0));
    }
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

}  // namespace

void add_parabola(std::vector<DecidedStatement>& all) {
  all.push_back(zone());
  all.push_back(peak());
  all.push_back(traction());
}

}  // namespace steadyslide::symbolic
