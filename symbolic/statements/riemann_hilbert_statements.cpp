#include "symbolic/statements/riemann_hilbert_statements.hpp"

#include "symbolic/riemann_hilbert/contact_symbols.hpp"

namespace steadyslide::symbolic {

using GiNaC::ex;

std::vector<ex> symbols(const std::string& name, std::size_t count) {
  std::vector<ex> result;
  for (std::size_t k = 0; k < count; ++k) result.push_back(GiNaC::symbol(name + "_" + std::to_string(k)));
  return result;
}

ContactSymbols::ContactSymbols(const FundamentalSolution& solution)
    : s(symbols("s", solution.panels())),
      alpha(symbols("alpha", solution.panels())),
      places(symbols("e", solution.points().size())),
      field(s) {}

std::vector<ex> ContactSymbols::powers(const FundamentalSolution& solution) const {
  std::vector<ex> result;
  for (const FundamentalSolution::Point& point : solution.points()) result.push_back(expression(point.power, alpha));
  return result;
}

std::vector<ex> ContactSymbols::sums(const FundamentalSolution& solution, std::size_t count) const {
  return power_sums(powers(solution), places, count);
}

FundamentalSolution one_contact(EndKind left, EndKind right, std::size_t jumps) {
  return FundamentalSolution({{left, right, jumps + 1}});
}

std::vector<DecidedStatement> riemann_hilbert_statements() {
  std::vector<DecidedStatement> all;
  add_fundamental_solution(all);
  add_polynomial_slope(all);
  add_flat_punch(all);
  add_inversion(all);
  add_parabola(all);
  add_quartic(all);
  return all;
}

}  // namespace steadyslide::symbolic
