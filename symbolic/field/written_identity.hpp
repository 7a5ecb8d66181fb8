#pragma once
// The equations of an ExactIdentity as they were put in: no normal form has touched them, other than the order and the
// collecting of equal terms that GiNaC does to every expression it makes.

#include <ginac/ginac.h>

#include <string>
#include <vector>

#include "symbolic/field/phase_field.hpp"

namespace steadyslide::symbolic {

struct WrittenEquation {
  std::string what;
  GiNaC::ex lhs;
  GiNaC::ex rhs;
};

struct WrittenIdentity {
  std::vector<PhaseField::Radical> radicals;  ///< the field's, i first; none in Q(symbols)
  std::vector<WrittenEquation> equations;     ///< all of them, or the one that does not hold
};

}  // namespace steadyslide::symbolic
