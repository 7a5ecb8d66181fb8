#include "symbolic/statements/contact_symbols.hpp"
#include "symbolic/statements/written_statements.hpp"

namespace steadyslide::symbolic {

namespace embedded {
extern const std::string_view riemann_hilbert_txt;
}

using GiNaC::ex;

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

std::vector<DecidedStatement> riemann_hilbert_statements() {
  std::vector<DecidedStatement> all;
  add_fundamental_solution(all);
  add_structure(all);
  add_powers(all);
  add_local_action(all);
  add_polynomial_slope(all);
  add_flat_punch(all);
  add_inversion(all);
  add_parabola(all);
  add_quartic(all);
  add_shapes(all);
  add_loads(all);
  return written_statements(embedded::riemann_hilbert_txt, all);
}

}  // namespace steadyslide::symbolic
