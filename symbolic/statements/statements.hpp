#pragma once
// The exact statements that claims rest on, each decided, and each with wrong variants that the same decision refutes.
// Without GiNaC in this header. Not thread-safe, as GiNaC is not. [Bal16]

#include <array>

#include "symbolic/field/exact_identity.hpp"

namespace steadyslide::symbolic {

/// gamma and the compliance by Kolosov's constant, the limit of a rigid indenter, exchange of the bodies, identical
/// bodies, the range ]0, 3/4[ of gamma and that it decreases in nu, cot(pi beta) at a friction jump.
std::vector<DecidedStatement> elasticity_statements();

/// The reduction to the normal traction for either direction of sliding; dilations and shifts, scaling, raising, the mirror:
/// what they make of the equation, the gap and the load [Bal16, (2), (3)]. The half-plane under given tractions [Bal16, (1)].
std::vector<DecidedStatement> equation_statements();

/// Theorem 2 with a friction jump, with a wedge and a jump, with a wedge alone; theorem 3 at either end of contact, at
/// a step and free, with the slopes outside; theorem 9, and to all three orders; theorem 10 as theorem 3 under one
/// friction. Each form is put into the local equation: both sides of an identity list its coefficients.
std::vector<DecidedStatement> local_form_statements();

/// The relation between Phi+ and Phi-, the exponents, Y+ = G Y-, the integer they sum to, the general solution, the
/// count of unknowns; polynomial profiles; the flat punch, flat or tilted, with any number of jumps [Bal16, (4),
/// (5)-(7), (8)]; the inverse of the operator [Bal16, (10)]; the parabola [Bal16, section 2] with any number of jumps,
/// free or against an edge; the quartic; the friction of a flat punch with strips.
std::vector<DecidedStatement> riemann_hilbert_statements();

/// The energy of a traction t of zero mean is its logarithmic energy and what friction jumps add, any number of them
/// by induction, and for every pair of Chebyshev's indices [Bal16, section 3.1].
std::vector<DecidedStatement> energy_statements();

/// Tractions by Chebyshev's coefficients, with the indices as symbols: the logarithmic form, the sign form, norms;
/// b = b_0 (1+K) with a skew K; what the proofs of section 3 do with pairings.
std::vector<DecidedStatement> hilbert_statements();

/// All of them.
struct StatementFamily {
  const char* name;
  std::vector<DecidedStatement> (*decide)();
};
inline constexpr std::array<StatementFamily, 6> statement_families{{{"elasticity", elasticity_statements},
                                                                    {"equation", equation_statements},
                                                                    {"local_forms", local_form_statements},
                                                                    {"riemann_hilbert", riemann_hilbert_statements},
                                                                    {"energy", energy_statements},
                                                                    {"hilbert", hilbert_statements}}};

/// A place of the paper's text, as extracted from its open version, where the local forms say something else, or ask
/// for a condition that the words leave out: what the decision procedure makes of the printed reading and of the one
/// that this project uses. Both stand in the reading notes, by the same ids.
struct LocalReading {
  std::string id;
  std::string found;   ///< what the local equation makes of either, in a sentence; empty if the signs alone decide
  bool printed_holds;  ///< decided, for the printed reading taken without any further condition
  bool derived_holds;
};

std::vector<LocalReading> local_readings();

}  // namespace steadyslide::symbolic
