#pragma once
// The conditions that the two signs impose on a local form, and its description. Only local_form.cpp uses this header.

#include "symbolic/local/local_form.hpp"

namespace steadyslide::symbolic {

/// True if t = -theta d^lambda, theta > 0, makes the surface penetrate the indenter that continues beyond the end. The
/// gap there is [psi_bar'] d + (+-) coefficient d^{lambda+1}/(lambda+1), + beyond a left end, u_bar' ~ coefficient
/// d^lambda.
bool penetrates(LocalForm& form, const LocalFrame& frame, const AngleForm& lambda);

/// Adds the slope of the surface beyond the end.
void add_outside(LocalForm& form, const LocalFrame& frame);
/// Adds the conditions of the ordered terms.
void add_conditions(LocalForm& form, const LocalFrame& frame);

/// Adds the title and the assumptions.
void describe(LocalForm& form, const LocalFrame& frame);
Formula term_text(const LocalForm& form, const LocalFrame& frame, const LocalFormTerm& term);
Formula form_text(const LocalForm& form);
std::string legend(const LocalForm& form);

}  // namespace steadyslide::symbolic
