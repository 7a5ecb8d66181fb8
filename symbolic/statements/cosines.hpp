#pragma once
// Functions of theta, x = cos(theta), built from C = cos(j theta), S = sin(j theta) and the same of k, where j and k are
// symbols: what is decided of them holds for every pair of indices. Derivatives follow from d C_j = -j S_j, d S_j =
// j C_j; at theta = 0 the sines vanish and the cosines are 1, at theta = pi they are (-1)^j and (-1)^k, of which all
// four pairs are looked at.

#include <array>
#include <utility>

#include "symbolic/field/comparison.hpp"
#include "symbolic/statements/statements.hpp"

namespace steadyslide::symbolic {

struct Cosines {
  GiNaC::symbol j{"j"}, k{"k"}, theta{"theta"}, pi{"pi"};
  GiNaC::symbol cj{"C_j"}, sj{"S_j"}, ck{"C_k"}, sk{"S_k"};
  PhaseField field;

  /// Squares of sines are written in cosines.
  GiNaC::ex derivative(const GiNaC::ex& f) const;
  GiNaC::ex without_squares(const GiNaC::ex& f) const;
  GiNaC::ex at_zero(const GiNaC::ex& f) const;
  GiNaC::ex at_pi(const GiNaC::ex& f, int sign_j, int sign_k) const;
  /// Both sides times j^2 k^2 (j^2-k^2), which is not 0 for j != k >= 1: no divisor is left.
  void equal(Comparison& comparison, const std::string& what, const GiNaC::ex& lhs, const GiNaC::ex& rhs) const;
};

/// (-1)^j and (-1)^k.
inline constexpr std::array<std::pair<int, int>, 4> parities{{{1, 1}, {1, -1}, {-1, 1}, {-1, -1}}};

// The parts of hilbert_statements(), and a part of energy_statements().
void add_chebyshev_forms(std::vector<DecidedStatement>& all);
void add_chebyshev_norms(std::vector<DecidedStatement>& all);
void add_skew_operators(std::vector<DecidedStatement>& all);
void add_inequalities(std::vector<DecidedStatement>& all);
void add_friction_jumps(std::vector<DecidedStatement>& all);

}  // namespace steadyslide::symbolic
