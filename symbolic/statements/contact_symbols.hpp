#pragma once
// Names for the data of a contact: s_0.. and alpha_0.. by panel, e_0.. for the ends and jumps; P/pi, x.

#include "symbolic/field/expression.hpp"
#include "symbolic/local/polynomial_slope.hpp"
#include "symbolic/riemann_hilbert/riemann_hilbert.hpp"
#include "symbolic/statements/statements.hpp"

namespace steadyslide::symbolic {

struct ContactSymbols {
  explicit ContactSymbols(const FundamentalSolution& solution);

  std::vector<GiNaC::ex> s;
  std::vector<GiNaC::ex> alpha;
  std::vector<GiNaC::ex> places;
  PhaseField field;
  GiNaC::symbol x{"x"};
  GiNaC::symbol load{"P"};
  GiNaC::symbol pi{"pi"};

  std::vector<GiNaC::ex> powers(const FundamentalSolution& solution) const;
  std::vector<GiNaC::ex> sums(const FundamentalSolution& solution, std::size_t count) const;
};

// The parts of riemann_hilbert_statements().
void add_fundamental_solution(std::vector<DecidedStatement>& all);
void add_structure(std::vector<DecidedStatement>& all);
void add_powers(std::vector<DecidedStatement>& all);
void add_local_action(std::vector<DecidedStatement>& all);
void add_polynomial_slope(std::vector<DecidedStatement>& all);
void add_flat_punch(std::vector<DecidedStatement>& all);
void add_inversion(std::vector<DecidedStatement>& all);
void add_parabola(std::vector<DecidedStatement>& all);
void add_quartic(std::vector<DecidedStatement>& all);
void add_shapes(std::vector<DecidedStatement>& all);
void add_loads(std::vector<DecidedStatement>& all);

}  // namespace steadyslide::symbolic
