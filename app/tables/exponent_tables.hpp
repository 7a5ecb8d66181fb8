#pragma once
// The powers of the distance in the normal traction, tabulated: by Poisson's ratio under a rigid indenter, and by pairs
// of materials. Evaluated from the model's exact exponents.
//
//   rigid indenter: gamma = (1-2nu)/(2(1-nu));   elastic indenter: gamma = Dundurs' beta;   alpha = arctan(gamma f)/pi
//   left end of contact: edge -1/2 - alpha, free 1/2 - alpha; right end: edge -1/2 + alpha, free 1/2 + alpha
//   friction jump inside the contact: alpha(c-) - alpha(c+)   [Bal16, (4), (7), section 3]; sliding back: alpha ->
//   -alpha

#include <vector>

#include "app/tables/text_table.hpp"
#include "model/elasticity.hpp"

namespace steadyslide::app {

/// All tables, in the order of the document.
std::vector<TextTable> exponent_tables();

struct TableDocument {
  std::string file;
  std::string text;
};

/// Returns the tables as exponents.md, exponents.tex and exponents.csv.
std::vector<TableDocument> exponent_documents();

/// Dundurs' alpha of a half-plane (body 1) and an indenter, 1 if it is rigid: the mismatch of compliances, positive
/// where the half-plane is the more compliant body, ((kappa_1+1)/mu_1 - (kappa_2+1)/mu_2) / ((kappa_1+1)/mu_1 +
/// (kappa_2+1)/mu_2). [Dun69]
Rational dundurs_alpha(const Elasticity& elasticity);

}  // namespace steadyslide::app
