// Of one friction value: what the powers at both ends differ by, a friction jump of height zero, the punch with s = 1 and its
// Cauchy integral in front of the contact.

#include "symbolic/statements/contact_symbols.hpp"

namespace steadyslide::symbolic {
namespace {

using GiNaC::ex;
using GiNaC::symbol;

DecidedStatement front_rear() {
  const std::vector<ex> alpha{symbol("alpha")};
  const PhaseField field;
  const auto power = [&](PointKind kind) { return expression(derived_exponent(kind).renamed({0, 0}), alpha); };
  const auto decided = [&](const std::string& words, const ex& edges, const ex& free_ends) {
    return Comparison(field)
        .equal("edges", power(PointKind::right_edge) - power(PointKind::left_edge), edges)
        .equal("free ends", power(PointKind::right_free) - power(PointKind::left_free), free_ends)
        .as(words);
  };
  const ex twice = 2 * alpha[0];
  return {
      "rh-front-rear",
      decided("the power at a right end less that at a left one is 2 alpha, at edges and at free ends", twice, twice),
      {decided("alpha", alpha[0], alpha[0]), decided("-2 alpha", -twice, -twice),
       decided("-2 alpha at free ends", twice, -twice), decided("0", 0, 0)}};
}

/// s = gamma f on both sides of a jump.
DecidedStatement friction_step() {
  const symbol gamma("gamma"), left("f_l"), right("f_r");
  const PhaseField field;
  const auto decided = [&](const std::string& words, const ex& stated) {
    return Comparison(field).equal("s_l - s_r", gamma * left - gamma * right, stated).as(words);
  };
  return {"rh-friction-step",
          decided("s_l - s_r = gamma (f_l - f_r)", gamma * (left - right)),
          {decided("gamma (f_r - f_l)", gamma * (right - left)), decided("f_l - f_r", left - right),
           decided("gamma (f_l + f_r)", gamma * (left + right)), decided("gamma f_l - f_r", gamma * left - right)}};
}

/// With one friction on both sides of a jump, Y and the relation of its banks are those without the jump.
DecidedStatement height_zero() {
  struct Layout {
    Component with;
    std::size_t jump;                 // of height zero
    std::vector<std::size_t> values;  // of the panels
  };
  const std::vector<Layout> layouts{{{EndKind::edge, EndKind::edge, 2}, 1, {0, 0}},
                                    {{EndKind::free, EndKind::edge, 3}, 2, {0, 1, 1}},
                                    {{EndKind::free, EndKind::free, 3}, 1, {0, 0, 1}}};
  const auto decided = [&](const std::string& words, bool same, const ex& added) {
    const std::vector<ex> alpha = symbols("alpha", 3);
    const PhaseField field(symbols("s", 3));
    Comparison comparison(field);
    for (const auto& [component, jump, values] : layouts) {
      const FundamentalSolution with({component});
      const FundamentalSolution without({{component.left, component.right, component.panels - 1}});
      std::vector<ex> powers, others, places = symbols("e", with.points().size());
      for (const auto& point : with.points()) {
        powers.push_back(expression(same ? point.power.renamed(values) : point.power, alpha));
      }
      powers[jump] += added;
      for (const auto& point : without.points()) others.push_back(expression(point.power, alpha));
      comparison.equal("power", powers[jump], 0);
      const std::vector<ex> series = binomial_product(powers, places, 3);
      places.erase(places.begin() + static_cast<std::ptrdiff_t>(jump));
      const std::vector<ex> expected = binomial_product(others, places, 3);
      for (std::size_t k = 0; k < series.size(); ++k) comparison.equal("Y far away", series[k], expected[k]);
      comparison.equal("epsilon", with.sign_on(field, with.regions()[jump + 1]),
                       without.sign_on(field, without.regions()[jump]));
    }
    return comparison.as(words);
  };
  return {"rh-height-zero",
          decided("one friction on both sides of a jump: its power is 0, Y and epsilon are those without it", true, 0),
          {decided("two frictions", false, 0), decided("the power 1 for 0", true, 1),
           decided("the power -1 for 0", true, -1), decided("a power of its own", true, symbol("p"))}};
}

/// F = (P/pi) Y at x = 2 for t = -(P cos/pi) |Y| on [-1, 1]: I = int |Y|/(x-2) dx, w = |Y(2)|.
DecidedStatement galin_at_two() {
  const PhaseField field({1});
  const ex r = field.friction(0).r;
  const ex i = field.i();
  const symbol load("P"), pi("pi"), w("w");
  const auto decided = [&](const std::string& words, const ex& integral, const ex& alpha, const ex& fourth) {
    const auto power = [&](PointKind kind) { return expression(derived_exponent(kind).renamed({0, 0}), {alpha}); };
    return Comparison(field)
        .equal("exp(2 pi i/4) = exp(2 pi i alpha) = -G", i, -jump_relation(1, i).ratio)
        .equal("power at the rear", power(PointKind::left_edge), ex(-3) / 4)
        .equal("power in front", power(PointKind::right_edge), ex(-1) / 4)
        .equal("w^4, at the distances 3 and 1", GiNaC::pow(ex(3), 4 * power(PointKind::left_edge)), fourth)
        .equal("F(2)", -load * field.friction(0).cos / pi * integral / pi, load / pi * w)
        .equal("r^2", r * r, 2)
        .as(words);
  };
  const ex quarter = ex(1) / 4;
  return {
      "rh-galin-at-2",
      decided("for s = 1: alpha = 1/4, |Y(2)| = 3^(-3/4), int |Y|/(x-2) dx = -pi sqrt(2) |Y(2)|", -pi * r * w, quarter,
              ex(1) / 27),
      {decided("the other sign", pi * r * w, quarter, ex(1) / 27),
       decided("without sqrt(2)", -pi * w, quarter, ex(1) / 27), decided("3^{1/4}", -pi * r * w, quarter, ex(1) / 3),
       decided("alpha = -1/4", -pi * r * w, -quarter, ex(1) / 27),
       decided("2 for sqrt(2)", -pi * 2 * w, quarter, ex(1) / 27)}};
}

/// d = t_n + P t_0 - L(phi) - L(psi-phi) - L(u-psi): its mean, and b(d, t^) for t^ of mean 0, where b(t_0, t^) = K <t^, 1>.
DecidedStatement four_terms() {
  const symbol u("u"), psi("psi"), phi("phi"), load("P"), constant("K");
  const PhaseField field;
  const auto decided = [&](const std::string& words, int with_load, const ex& first, int third) {
    const ex mean_of_test = 0;
    const ex pairing = u + with_load * load * constant * mean_of_test - first - (psi - phi) - third * (u - psi);
    return Comparison(field).equal("b(d, t^)", pairing, 0).equal("mean", -load + with_load * load, 0).as(words);
  };
  return {"rh-four-terms",
          decided("t_n + P t_0 - L(phi) - L(psi-phi) - L(u-psi) has the mean 0 and b(d, t^) = 0", 1, phi, 1),
          {decided("without P t_0", 0, phi, 1), decided("-P t_0", -1, phi, 1), decided("without L(u-psi)", 1, phi, 0),
           decided("2 L(phi)", 1, 2 * phi, 1)}};
}

/// psi' - phi', phi' constant on both sides of c = 0 with the values of psi' there: polynomials of degree 3.
DecidedStatement level_slopes() {
  const symbol x("x");
  const std::vector<ex> left = symbols("l", 4);
  const std::vector<ex> right = symbols("r", 4);
  const PhaseField field;
  const auto decided = [&](const std::string& words, const ex& phi_left, const ex& phi_right) {
    ex slope_left = -phi_left;
    ex slope_right = -phi_right;
    for (int k = 0; k < 4; ++k) {
      slope_left += left[static_cast<std::size_t>(k)] * GiNaC::pow(x, k);
      slope_right += right[static_cast<std::size_t>(k)] * GiNaC::pow(x, k);
    }
    return Comparison(field)
        .equal("D of psi - phi at c", (slope_right - slope_left).subs(x == 0), 0)
        .equal("D of phi", phi_right - phi_left, right[0] - left[0])
        .as(words);
  };
  return {"rh-level-slopes",
          decided("psi' - phi' does not jump at c, phi' does as psi'", left[0], right[0]),
          {decided("phi' = 0", 0, 0), decided("the sides exchanged", right[0], left[0]),
           decided("phi' on the left alone", left[0], 0), decided("phi' by the next coefficients", left[1], right[1])}};
}

}  // namespace

void add_remarks(std::vector<DecidedStatement>& all) {
  for (const auto& statement : {front_rear, friction_step, height_zero, galin_at_two, four_terms, level_slopes})
    all.push_back(statement());
}

}  // namespace steadyslide::symbolic
