#pragma once
// What the two signs make of a local form, and its words: the second half of local_form.cpp, for it alone.

#include "symbolic/local/local_form.hpp"

namespace steadyslide::symbolic {

/// Does t = -theta d^lambda, theta > 0, push the surface into the indenter that goes on beyond the end? The gap there
/// is [psi_bar'] d + (+-) coefficient d^{lambda+1}/(lambda+1), + beyond a left end, u_bar' ~ coefficient d^lambda.
bool penetrates(LocalForm& form, const LocalFrame& frame, const AngleForm& lambda);

/// The slope of the surface beyond the end.
void add_outside(LocalForm& form, const LocalFrame& frame);
/// The conditions of the ordered terms.
void add_conditions(LocalForm& form, const LocalFrame& frame);

/// Title and assumptions.
void describe(LocalForm& form, const LocalFrame& frame);
Formula term_text(const LocalForm& form, const LocalFrame& frame, const LocalFormTerm& term);
Formula form_text(const LocalForm& form);
std::string legend(const LocalForm& form);

}  // namespace steadyslide::symbolic
