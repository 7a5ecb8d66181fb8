#pragma once
// Linear systems over the exact field of phase_field.hpp. The field decides exactly if a pivot is zero. Meant for the
// few unknowns of a local form. For sources of this layer and tests only.

#include <ginac/ginac.h>

#include <set>
#include <string>
#include <vector>

#include "symbolic/field/phase_field.hpp"

namespace steadyslide::symbolic {

using FieldRow = std::vector<GiNaC::ex>;

struct LinearSolution {
  bool solvable;
  FieldRow particular;                 ///< the solution in which every free unknown is zero
  std::vector<FieldRow> kernel;        ///< one vector for each free unknown; this unknown is 1 in it
  std::vector<std::size_t> free;       ///< their indices; of two unknowns that could be free, the later one is
  std::set<std::string> nonvanishing;  ///< pivots with symbols; the result is invalid where one vanishes
};

/// Solves rows * x = rhs for `unknowns` unknowns x. `known` are elements without zeros, which are preferred as
/// divisors. Throws std::domain_error if an entry is not in the field.
LinearSolution solve(const PhaseField& field, std::size_t unknowns, std::vector<FieldRow> rows, FieldRow rhs,
                     const FieldRow& known = {});

/// Returns the factors of the numerator that can vanish, up to sign. A division by the element requires that none does.
std::set<std::string> nonvanishing_of(const PhaseField& field, const GiNaC::ex& divisor);

/// Returns the determinant of a square matrix with few rows, in canonical form.
GiNaC::ex determinant(const PhaseField& field, const std::vector<FieldRow>& rows);

}  // namespace steadyslide::symbolic
