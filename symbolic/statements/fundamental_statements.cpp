// From the operator to Y(z): the relation of Phi+ and Phi-, the exponents at the five kinds of point, Y+ = G Y-, the
// integer that the exponents sum to.

#include "symbolic/statements/contact_symbols.hpp"

namespace steadyslide::symbolic {
namespace {

using GiNaC::ex;
using GiNaC::symbol;

DecidedStatement exponent_at(const std::string& id, PointKind kind, const std::string& words, const AngleForm& stated,
                             const std::vector<std::pair<std::string, AngleForm>>& wrong) {
  const PhaseField field({symbol("s_l"), symbol("s_r")});
  const std::vector<ex> alphas{symbol("alpha_l"), symbol("alpha_r")};
  const auto decided = [&](const std::string& statement, const AngleForm& form) {
    Comparison comparison(field);
    compare_crossing(comparison, field, kind, form);
    comparison.equal("is of its kind", is_admissible(kind, form) ? 1 : 0, 1);
    comparison.equal("derived", expression(derived_exponent(kind), alphas), expression(form, alphas));
    return comparison.as(statement);
  };
  DecidedStatement result{id, decided(words, stated), {}};
  for (const auto& [statement, form] : wrong) result.controls.push_back(decided(statement, form));
  return result;
}

void add_exponents(std::vector<DecidedStatement>& all) {
  const auto form = [](int halves, int left, int right) { return AngleForm(halves, {{0, left}, {1, right}}); };
  all.push_back(exponent_at("rh-exponent-left-edge", PointKind::left_edge, "a left edge has p = -(1/2 + alpha)",
                            form(-1, 0, -1),
                            {{"-(1/2 - alpha)", form(-1, 0, 1)},
                             {"1/2 - alpha", form(1, 0, -1)},
                             {"-1/2", form(-1, 0, 0)},
                             {"with the friction off the contact", form(-1, -1, 0)}}));
  all.push_back(exponent_at("rh-exponent-right-edge", PointKind::right_edge, "a right edge has p = -(1/2 - alpha)",
                            form(-1, 1, 0),
                            {{"-(1/2 + alpha)", form(-1, -1, 0)},
                             {"1/2 + alpha", form(1, 1, 0)},
                             {"-1/2", form(-1, 0, 0)},
                             {"with the friction off the contact", form(-1, 0, 1)}}));
  all.push_back(exponent_at("rh-exponent-left-free", PointKind::left_free, "a free left end has p = 1/2 - alpha",
                            form(1, 0, -1),
                            {{"1/2 + alpha", form(1, 0, 1)},
                             {"-(1/2 + alpha)", form(-1, 0, -1)},
                             {"3/2 - alpha", form(3, 0, -1)},
                             {"1/2", form(1, 0, 0)}}));
  all.push_back(exponent_at("rh-exponent-right-free", PointKind::right_free, "a free right end has p = 1/2 + alpha",
                            form(1, 1, 0),
                            {{"1/2 - alpha", form(1, -1, 0)},
                             {"-(1/2 - alpha)", form(-1, 1, 0)},
                             {"3/2 + alpha", form(3, 1, 0)},
                             {"1/2", form(1, 0, 0)}}));
  all.push_back(exponent_at("rh-exponent-jump", PointKind::jump, "a friction jump has p = alpha(c-) - alpha(c+)",
                            form(0, 1, -1),
                            {{"alpha(c+) - alpha(c-)", form(0, -1, 1)},
                             {"alpha(c-) + alpha(c+)", form(0, 1, 1)},
                             {"1/2 + alpha(c-) - alpha(c+)", form(1, 1, -1)},
                             {"1 + alpha(c-) - alpha(c+)", form(2, 1, -1)},
                             {"0", form(0, 0, 0)}}));
}

using Powers = std::vector<AngleForm>;

Powers powers_of(const FundamentalSolution& solution) {
  Powers powers;
  for (const auto& point : solution.points()) powers.push_back(point.power);
  return powers;
}

/// Wrong powers, by name; every layout below has a jump.
std::vector<std::pair<std::string, Powers>> wrong_powers(const FundamentalSolution& solution) {
  const Powers right = powers_of(solution);
  Powers other_jumps = right;
  Powers no_jumps = right;
  Powers other_angles = right;
  for (std::size_t j = 0; j < right.size(); ++j) {
    if (solution.points()[j].kind == PointKind::jump) {
      other_jumps[j] = -right[j];
      no_jumps[j] = AngleForm();
    }
    other_angles[j] = right[j].mirrored();
  }
  return {{"beta of the other sign", other_jumps},
          {"without the jumps", no_jumps},
          {"every alpha of the other sign", other_angles},
          {"exponents from right to left", Powers(right.rbegin(), right.rend())}};
}

DecidedStatement fundamental(const std::string& id, const std::string& words, const FundamentalSolution& solution,
                             const std::vector<ex>& frictions) {
  const PhaseField field(frictions);
  const auto decided = [&](const std::string& statement, const FundamentalSolution& candidate) {
    Comparison comparison(field);
    candidate.compare(comparison, field);
    return comparison.as(statement);
  };
  DecidedStatement result{id, decided(words, solution), {}};
  for (const auto& [name, powers] : wrong_powers(solution)) {
    result.controls.push_back(decided(name, solution.with_powers(powers)));
  }
  return result;
}

void add_layouts(std::vector<DecidedStatement>& all) {
  constexpr EndKind edge = EndKind::edge;
  constexpr EndKind free = EndKind::free;
  const auto add = [&](const std::string& id, const std::string& words, const std::vector<Component>& components) {
    const FundamentalSolution solution(components);
    all.push_back(fundamental(id, "Y+ = G Y- on the contact, Y+ = Y- off it: " + words, solution,
                              symbols("s", solution.panels())));
  };
  add("rh-Y-edges-1", "two edges, one jump", {{edge, edge, 2}});
  add("rh-Y-edges-4", "two edges, four jumps", {{edge, edge, 5}});
  add("rh-Y-free-2", "two free ends, two jumps", {{free, free, 3}});
  add("rh-Y-edge-free", "edge and free end, one jump", {{edge, free, 2}});
  add("rh-Y-two", "two components, three jumps", {{edge, free, 2}, {free, edge, 3}});
  add("rh-Y-three", "three components, three jumps", {{edge, free, 2}, {free, free, 3}, {edge, edge, 1}});
  all.push_back(fundamental("rh-Y-rational", "Y+ = G Y- for s = 1, 7, 3/4, -2/3: two components",
                            FundamentalSolution({{edge, free, 2}, {free, edge, 2}}),
                            {1, 7, GiNaC::numeric(3, 4), GiNaC::numeric(-2, 3)}));
}

DecidedStatement exponent_sum() {
  constexpr EndKind edge = EndKind::edge;
  constexpr EndKind free = EndKind::free;
  const std::vector<std::vector<Component>> layouts{{{edge, edge, 1}},
                                                    {{edge, free, 2}},
                                                    {{free, edge, 3}},
                                                    {{free, free, 5}},
                                                    {{edge, free, 2}, {free, edge, 3}},
                                                    {{free, free, 2}, {free, free, 2}, {free, edge, 1}}};
  const auto decided = [&](const std::string& statement, int ends, int components, const AngleForm& jump) {
    const std::vector<ex> alpha = symbols("alpha", 6);
    const PhaseField field;
    Comparison comparison(field);
    // One more jump next to the right end: beta + p(right) of the new friction is p(right) of the old one. Any number
    // of jumps follows, and with no jump a component gives (its free ends) - 1.
    for (const PointKind kind : {PointKind::right_edge, PointKind::right_free}) {
      const AngleForm end = derived_exponent(kind);
      comparison.equal("one more jump", expression(jump + end.renamed({1, 1}), alpha),
                       expression(end.renamed({0, 0}), alpha));
    }
    for (const auto& layout : layouts) {
      const FundamentalSolution solution(layout);
      comparison.equal("sum of exponents", expression(solution.power_sum(), alpha),
                       ends * solution.free_ends() - components * static_cast<int>(layout.size()));
    }
    return comparison.as(statement);
  };
  const AngleForm beta = derived_exponent(PointKind::jump);
  return {"rh-exponent-sum",
          decided("the exponents sum to S = (free ends) - (components), for any number of jumps", 1, 1, beta),
          {decided("(components) - (free ends)", -1, -1, beta), decided("(free ends)", 1, 0, beta),
           decided("(free ends) + (components)", 1, -1, beta), decided("2 (free ends) - (components)", 2, 1, beta),
           decided("with beta of the other sign", 1, 1, -beta)}};
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

// The general solution: (s+i) Y+ is real, h = epsilon cos(pi alpha) psi'/|Y|, and as many conditions as unknowns.

/// Phi = Y X with X+ - X- = h: the sum X+ + X- is free.
DecidedStatement general_solution() {
  const FundamentalSolution y({{EndKind::edge, EndKind::free, 2}, {EndKind::free, EndKind::edge, 2}});
  const ContactSymbols data(y);
  const PhaseField& field = data.field;
  const symbol modulus("Y");
  const symbol slope("psi'");
  const symbol mean("X");
  const ex i = field.i();
  enum class Variant { right, no_cos, other_sign, doubled, times_modulus, sin };
  const auto decided = [&](const std::string& words, Variant variant) {
    Comparison comparison(field);
    for (const auto& region : y.regions()) {
      if (!region.friction) continue;
      const auto& f = field.friction(*region.friction);
      const int epsilon = y.sign_on(field, region);
      ex h = epsilon * f.cos * slope / modulus;
      if (variant == Variant::no_cos) h = epsilon * slope / modulus;
      if (variant == Variant::other_sign) h = -h;
      if (variant == Variant::doubled) h = 2 * h;
      if (variant == Variant::times_modulus) h = h * modulus * modulus;
      if (variant == Variant::sin) h = epsilon * f.sin * slope / modulus;
      const ex plus = modulus * field.phase(region.sigma, 1) * (mean + h / 2);
      const ex minus = modulus * field.phase(region.sigma, -1) * (mean - h / 2);
      const std::string panel = "panel " + std::to_string(*region.friction) + ": ";
      const JumpRelation relation = jump_relation(f.s, i);
      comparison.equal(panel + "Phi+ - G Phi-", plus - relation.ratio * minus, slope * relation.source)
          .equal(panel + "A t", i * (plus + minus) + f.s * (plus - minus), slope);
    }
    return comparison.as(words);
  };
  return {"rh-general-solution",
          decided("Phi = Y X with X+ - X- = epsilon cos(pi alpha) psi'/|Y| solves A t = psi' on every panel",
                  Variant::right),
          {decided("h without cos", Variant::no_cos), decided("h of the other sign", Variant::other_sign),
           decided("h doubled", Variant::doubled), decided("h = epsilon cos psi' |Y|", Variant::times_modulus),
           decided("sin for cos", Variant::sin)}};
}

}  // namespace

void add_fundamental_solution(std::vector<DecidedStatement>& all) {
  add_exponents(all);
  add_layouts(all);
  all.push_back(exponent_sum());
  all.push_back(height_zero());
  all.push_back(general_solution());
}

}  // namespace steadyslide::symbolic
