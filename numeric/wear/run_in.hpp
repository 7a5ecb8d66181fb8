#pragma once
// The pressure with which a contact has run in: it no longer changes while the indenter wears.
//
//   k p = A on the support if the attitude is given,   k p = max(A + B x, 0) if the indenter may tilt.
//
// If k = 0 on some cells, these carry the whole load in the end, and nothing wears any more.

#include <optional>
#include <vector>

#include "numeric/variational/discrete_problem.hpp"

namespace steadyslide::numeric::wear {

/// Returns the pressures on the cells, in P/unit. `k` are the coefficients of the cells, >= 0, in any unit; one is
/// positive. Absent if the cells that do not wear cannot carry the load at its place, or are not solved.
std::optional<std::vector<double>> run_in_pressure(const variational::DiscreteProblem& problem,
                                                   const std::vector<double>& k);

}  // namespace steadyslide::numeric::wear
