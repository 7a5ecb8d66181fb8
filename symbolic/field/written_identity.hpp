#pragma once
// The equations of an ExactIdentity as given, without a normal form. GiNaC has only reordered terms and collected equal
// ones, which it does for every expression.

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
  std::vector<PhaseField::Radical> radicals;  ///< of the field, i first; empty in Q(symbols)
  std::vector<WrittenEquation> equations;     ///< all of them, or the one that does not hold
};

}  // namespace steadyslide::symbolic
