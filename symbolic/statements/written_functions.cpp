#include "symbolic/statements/written_functions.hpp"

#include <algorithm>
#include <limits>

#include "symbolic/field/rational_function.hpp"
#include "symbolic/local/polynomial_slope.hpp"
#include "symbolic/statements/polynomial_families.hpp"
#include "symbolic/statements/statement_lines.hpp"

namespace steadyslide::symbolic {

using GiNaC::ex;
using GiNaC::symbol;
using Arguments = std::vector<ex>;

int integer(const ex& e) {
  if (!e.info(GiNaC::info_flags::integer)) refuse("no integer", canonical_text(e));
  return GiNaC::ex_to<GiNaC::numeric>(e).to_int();
}

std::size_t count(const ex& e) {
  const int n = integer(e);
  if (n < 0) refuse("no count", canonical_text(e));
  return static_cast<std::size_t>(n);
}

Arguments entries(const ex& e) {
  if (!GiNaC::is_a<GiNaC::lst>(e)) refuse("no list", canonical_text(e));
  return {e.begin(), e.end()};
}

ex list_of(const Arguments& entries) { return GiNaC::lst(entries.begin(), entries.end()); }

FundamentalSolution contact(const ex& ends_and_jumps) {
  const auto end = [](const ex& free_ends) { return integer(free_ends) == 0 ? EndKind::edge : EndKind::free; };
  const Arguments all = entries(ends_and_jumps);
  if (all.size() % 3 != 0) refuse("a component has two ends and a number of jumps", std::to_string(all.size()));
  std::vector<Component> components;
  for (std::size_t k = 0; k < all.size(); k += 3)
    components.push_back({end(all[k]), end(all[k + 1]), count(all[k + 2]) + 1});
  return FundamentalSolution(components);
}

namespace {

GiNaC::numeric number(const ex& e) {
  if (!GiNaC::is_a<GiNaC::numeric>(e)) refuse("no number", canonical_text(e));
  return GiNaC::ex_to<GiNaC::numeric>(e);
}

const symbol& symbol_in(const ex& e) {
  if (!GiNaC::is_a<symbol>(e)) refuse("no symbol", canonical_text(e));
  return GiNaC::ex_to<symbol>(e);
}

ex polynomial(const Arguments& coefficients, const ex& x) {
  ex value = 0;
  for (std::size_t k = coefficients.size(); k-- > 0;) value = value * x + coefficients[k];
  return value;
}

PolynomialSlope polynomial_slope(const Arguments& a) { return {integer(a[0]), entries(a[1]), entries(a[2]), a[3]}; }

}  // namespace

WrittenFunctions plain_functions() {
  constexpr std::size_t any = std::numeric_limits<std::size_t>::max();
  const auto replaced = [](const Arguments& a, bool squares) {
    GiNaC::lst equations;
    for (std::size_t k = 1; k + 1 < a.size(); k += 2) equations.append((squares ? a[k] * a[k] : a[k]) == a[k + 1]);
    return equations;
  };
  WrittenFunctions all{
      {"at", {{3, any, 2}, [=](const Arguments& a) { return a[0].subs(replaced(a, false)); }}},
      {"squares",
       {{3, any, 2},
        [=](const Arguments& a) { return a[0].expand().subs(replaced(a, true), GiNaC::subs_options::algebraic); }}},
      {"diff", {2, [](const Arguments& a) { return a[0].diff(symbol_in(a[1])); }}},
      {"coeff", {3, [](const Arguments& a) { return a[0].coeff(a[1], integer(a[2])); }}},
      {"expand", {1, [](const Arguments& a) { return a[0].expand(); }}},
      {"normal", {1, [](const Arguments& a) { return a[0].normal(); }}},
      {"log", {1, [](const Arguments& a) -> ex { return GiNaC::log(a[0]); }}},
      {"integral", {4, [](const Arguments& a) { return integral(a[0], symbol_in(a[1]), a[2], a[3]); }}},
      {"chebyshev_T", {2, [](const Arguments& a) { return chebyshev_t(integer(a[0]), a[1]); }}},
      {"chebyshev_U", {2, [](const Arguments& a) { return chebyshev_u(integer(a[0]), a[1]); }}},
      {"max", {{1, any}, [](const Arguments& a) { return *std::ranges::max_element(a, {}, number); }}},
      {"size", {1, [](const Arguments& a) -> ex { return entries(a[0]).size(); }}},
      {"join",
       {{1, any},
        [](const Arguments& a) {
          Arguments all;
          for (const ex& list : a) std::ranges::copy(entries(list), std::back_inserter(all));
          return list_of(all);
        }}},
      {"panels",
       {1,
        [](const Arguments& a) {
          Arguments panels;
          const FundamentalSolution solution = contact(a[0]);
          for (std::size_t k = 0; k < solution.regions().size(); ++k) {
            if (solution.regions()[k].friction) panels.push_back(k);
          }
          return list_of(panels);
        }}},
      {"banks",
       {1,
        [](const Arguments& a) {
          Arguments names;
          const FundamentalSolution solution = contact(a[0]);
          for (const auto& region : solution.regions()) {
            names.push_back(symbol(region.friction ? "panel " + std::to_string(*region.friction)
                                                   : "off contact " + std::to_string(names.size())));
          }
          return list_of(names);
        }}},
      {"zeros",
       {2,
        [](const Arguments& a) {
          GiNaC::lst equations;
          for (const ex& f : entries(a[0])) equations.append(f == 0);
          Arguments values;
          for (const ex& solved : GiNaC::lsolve(equations, a[1])) values.push_back(solved.rhs());
          return list_of(values);
        }}},
      {"same", {2, [](const Arguments& a) -> ex { return a[0].is_equal(a[1]) ? 1 : 0; }}},
      {"sum", {1, [](const Arguments& a) { return polynomial(entries(a[0]), 1); }}},
      {"polynomial", {2, [](const Arguments& a) { return polynomial(entries(a[0]), a[1]); }}},
      {"power_sums",
       {3, [](const Arguments& a) { return list_of(power_sums(entries(a[0]), entries(a[1]), count(a[2]))); }}},
      {"binomials",
       {3, [](const Arguments& a) { return list_of(binomial_product(entries(a[0]), entries(a[1]), count(a[2]))); }}},
      {"series_of_Y",
       {1, [](const Arguments& a) { return list_of(series_at_infinity(entries(a[0]), -1, a[0].nops())); }}},
      {"series_of_reciprocal",
       {1, [](const Arguments& a) { return list_of(series_at_infinity(entries(a[0]), 1, a[0].nops())); }}},
      {"N_of", {4, [](const Arguments& a) { return list_of(polynomial_slope(a).factor()); }}},
      {"conditions", {4, [](const Arguments& a) { return list_of(polynomial_slope(a).conditions()); }}},
      {"F_of", {5, [](const Arguments& a) {
                  return field_coefficient(integer(a[0]), entries(a[1]), entries(a[2]), entries(a[3]), integer(a[4]));
                }}}};
  for (const auto& [name, kind] : {std::pair("left_edge", PointKind::left_edge),
                                   {"right_edge", PointKind::right_edge},
                                   {"left_free", PointKind::left_free},
                                   {"right_free", PointKind::right_free},
                                   {"jump", PointKind::jump}}) {
    const std::size_t angles = kind == PointKind::jump ? 2 : 1;
    all.emplace(name, WrittenFunction{angles, [kind = kind](const Arguments& a) {
                                        return expression(derived_exponent(kind), {a.front(), a.back()});
                                      }});
  }
  return all;
}

}  // namespace steadyslide::symbolic
