#pragma once

#include <string>
#include <variant>

#include "library/problem_file/problem_file.hpp"
#include "numeric/solution/contact_solution.hpp"

namespace steadyslide {

/// Returns the picture of the command line's --plot as the bytes of a file; `kind` is svg, pdf or png. Throws InvalidData
/// for another kind, and std::runtime_error "gnuplot: ..." if gnuplot is absent or fails.
std::string picture(
    library::Problem problem,
    const std::variant<const numeric::ContactSolution<double>*, const numeric::ContactSolution<numeric::Real50>*,
                       const numeric::ContactSolution<numeric::Real100>*>& solution,
    int digits, const std::string& failed_condition, const std::string& kind);

}  // namespace steadyslide
