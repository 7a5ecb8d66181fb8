#pragma once
// Parabolas psi = A (x - v)^2 for the claims about them, in the user's units: R = c/(2A), where c is the compliance.

#include "proofs_checks/instruments/tractions/punch.hpp"

namespace steadyslide::proofs_checks {

/// Returns the problem. Friction jumps are measured from the vertex v. The support extends far beyond every contact.
ContactProblem parabola(const Rational& nu, const std::vector<Rational>& friction,
                        const std::vector<Rational>& jumps_from_vertex, const Rational& radius, const Rational& load,
                        const Rational& vertex = 0, Sliding sliding = Sliding::plus_x);

Rational radius_of(const ContactProblem& problem);
Rational vertex_of(const ContactProblem& problem);

/// A formula's traction of a contact with two free ends; x is measured from the vertex.
struct ParabolaTraction : PowerProduct {
  std::size_t first_piece = 0;  ///< the friction piece at the left end
};

/// Checks sum p_j r_j = 0 and sum p_j r_j^2 = 2 P R/pi, the equation, the load, and the gap beyond both ends.
template <Real R>
void check_parabola(Findings& findings, const ParabolaTraction& t, const ContactProblem& problem,
                    const Context& context);

/// Compares ends and tractions with the derived contact in CLN.
template <Real R>
void check_parabola_by_cln(Findings& findings, const ParabolaTraction& t, const ContactProblem& problem);

/// Compares ends and tractions with the numeric layer's closed form. This shows nothing if the traction itself comes
/// from that form.
template <Real R>
void check_parabola_by_numeric(Findings& findings, const ParabolaTraction& t, const ContactProblem& problem);

}  // namespace steadyslide::proofs_checks
