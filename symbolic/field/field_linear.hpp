#pragma once
// Linear systems over the exact field of phase_field.hpp: whether a pivot is zero is decided there, never guessed. For
// the few unknowns of a local form. For sources of this layer and tests only.

#include <ginac/ginac.h>

#include <set>
#include <string>
#include <vector>

#include "symbolic/field/phase_field.hpp"

namespace steadyslide::symbolic {

using FieldRow = std::vector<GiNaC::ex>;

struct LinearSolution {
  bool solvable;
  FieldRow particular;                 ///< with zero for every unknown that is free
  std::vector<FieldRow> kernel;        ///< one vector for each free unknown, in which that one is 1
  std::vector<std::size_t> free;       ///< their indices; a later unknown is free before an earlier one
  std::set<std::string> nonvanishing;  ///< pivots that depend on symbols: where one vanishes, nothing is said
};

/// rows * x = rhs for that many unknowns x; `known` are elements without zeros, preferred as divisors. Throws
/// std::domain_error where an entry is not of the field.
LinearSolution solve(const PhaseField& field, std::size_t unknowns, std::vector<FieldRow> rows, FieldRow rhs,
                     const FieldRow& known = {});

/// The factors of the numerator that can vanish, up to sign: what a division by the element asks for.
std::set<std::string> nonvanishing_of(const PhaseField& field, const GiNaC::ex& divisor);

/// The determinant of a square matrix of at most a few rows, in canonical form.
GiNaC::ex determinant(const PhaseField& field, const std::vector<FieldRow>& rows);

}  // namespace steadyslide::symbolic
