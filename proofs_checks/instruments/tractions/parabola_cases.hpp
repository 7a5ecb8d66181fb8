#pragma once
// Parabolas psi = A (x - v)^2 for the claims about them, in the user's units: R = c/(2A), c the compliance.

#include "proofs_checks/instruments/tractions/punch.hpp"

namespace steadyslide::proofs_checks {

/// Jumps are measured from the vertex v. The support reaches far beyond every contact.
ContactProblem parabola(const Rational& nu, const std::vector<Rational>& friction,
                        const std::vector<Rational>& jumps_from_vertex, const Rational& radius, const Rational& load,
                        const Rational& vertex = 0, Sliding sliding = Sliding::plus_x);

Rational radius_of(const ContactProblem& problem);
Rational vertex_of(const ContactProblem& problem);

/// The traction of a contact with two free ends, as a formula says it, x measured from the vertex.
struct ParabolaTraction : PowerProduct {
  std::size_t first_piece = 0;  ///< the friction piece at the left end
};

/// sum p_j r_j = 0 and sum p_j r_j^2 = 2 P R/pi, equation, load, and the gap beyond both ends.
template <Real R>
void check_parabola(Findings& findings, const ParabolaTraction& t, const ContactProblem& problem,
                    const Context& context);

/// Ends and tractions against CLN's Newton solution.
template <Real R>
void check_parabola_by_cln(Findings& findings, const ParabolaTraction& t, const ContactProblem& problem);

/// Ends and tractions against the numeric layer's closed form. Says nothing where that is the form's own source.
template <Real R>
void check_parabola_by_numeric(Findings& findings, const ParabolaTraction& t, const ContactProblem& problem);

}  // namespace steadyslide::proofs_checks
