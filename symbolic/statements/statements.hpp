#pragma once
// The exact statements that claims use. Each is decided, and the same procedure refutes its wrong variants. This header
// does not include GiNaC. Not thread-safe, because GiNaC is not. [Bal16]

#include <array>

#include "symbolic/field/exact_identity.hpp"

namespace steadyslide::symbolic {

/// Statements on elasticity: gamma and the compliance in terms of Kolosov's constant, the limit of a rigid indenter,
/// exchange of the bodies, identical bodies, the range ]0, 3/4[ of gamma, its decrease with nu, and cot(pi beta) at a
/// friction jump.
std::vector<DecidedStatement> elasticity_statements();

/// Statements on the equation: the reduction to the normal traction for both directions of sliding; the effect of
/// dilation, shift, scaling, raising and mirror on the equation, the gap and the load [Bal16, (2), (3)]; the half-plane
/// under given tractions [Bal16, (1)]; one layer on a base.
std::vector<DecidedStatement> equation_statements();

/// Theorem 2 with a friction jump, with a wedge and a jump, with a wedge alone; theorem 3 at either end of contact, at
/// a step and free, with the slopes outside; theorem 9, and theorem 9 to all three orders; theorem 10 as theorem 3
/// under one friction. Each form is substituted into the local equation: both sides of an identity list its
/// coefficients.
std::vector<DecidedStatement> local_form_statements();

/// The relation between Phi+ and Phi-, the exponents, their integer sum, Y+ = G Y-, the general solution, the number of
/// unknowns; polynomial profiles; the flat punch, flat or tilted, with any number of jumps [Bal16, (4), (5)-(7), (8)];
/// the inverse of the operator [Bal16, (10)]; the parabola [Bal16, section 2] with any number of jumps, free or against
/// an edge; the quartic; the friction of a flat punch with strips.
std::vector<DecidedStatement> riemann_hilbert_statements();

/// The energy of a traction t of zero mean is its logarithmic energy plus the contributions of friction jumps; for any
/// number of jumps by induction, and for every pair of Chebyshev's indices [Bal16, section 3.1].
std::vector<DecidedStatement> energy_statements();

/// The steps of the theorems on uniqueness under friction of any trend: the number of gaps, the phase of the difference
/// of two fields along the line.
std::vector<DecidedStatement> uniqueness_statements();

/// Tractions given by Chebyshev coefficients, with symbols as indices: the logarithmic form, the sign form, norms;
/// b = b_0 (1+K) with a skew K; the steps with pairings in the proofs of section 3.
std::vector<DecidedStatement> hilbert_statements();

/// All of them.
struct StatementFamily {
  const char* name;
  std::vector<DecidedStatement> (*decide)();
};
inline constexpr std::array<StatementFamily, 7> statement_families{{{"elasticity", elasticity_statements},
                                                                    {"equation", equation_statements},
                                                                    {"local_forms", local_form_statements},
                                                                    {"riemann_hilbert", riemann_hilbert_statements},
                                                                    {"energy", energy_statements},
                                                                    {"uniqueness", uniqueness_statements},
                                                                    {"hilbert", hilbert_statements}}};

/// A place in the paper's text (taken from its open version) that differs from the local forms. The structure holds the
/// results of the decision procedure for the printed reading and for the reading that this project uses. The reading
/// notes contain both, with the same ids.
struct LocalReading {
  std::string id;
  std::string found;   ///< the result of the local equation for both, as a sentence
  bool printed_holds;  ///< the decision for the printed reading
  bool derived_holds;
};

std::vector<LocalReading> local_readings();

}  // namespace steadyslide::symbolic
