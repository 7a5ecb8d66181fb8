#pragma once
// Contact on a body other than the half-plane by the Riemann-Hilbert method. Its slopes satisfy A t = psi'/c + w in
// contact, with the half-plane's A and the smooth w of surface_correction.hpp. So the traction is that of the half-plane
// under a profile whose slope is psi' + c w, and w is a fixed point: it depends on t.

#include "numeric/solution/contact_solution.hpp"

namespace steadyslide::numeric {

/// Refuses contacts more than ten times as wide as the distance of the correction's singularities, which is twice the
/// thickness of the first layer. Starts from cells and iterates w with Anderson's acceleration. The solution is absent if the iteration does not
/// converge, and `reason` says why. The relative errors contain 10 times the last change of w. On bodies with a
/// period or given symbols the slope u_t' is not known, and its error is infinite. Periodic contact needs a gap.
Attempt<double> contact_on_body(const ContactProblem& problem);

}  // namespace steadyslide::numeric
