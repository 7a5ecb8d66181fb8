#pragma once
// The picture of a run of wear: worn depth and pressure along x after some sliding distances, and the run-in pressure.

#include "app/gnuplot/figure.hpp"
#include "app/wear/wear_record.hpp"
#include "library/problem_file/problem_file.hpp"

namespace steadyslide::app {

/// `edges` as profile_edges() gives them; `run_in` are means over the same parts, empty if they are not known.
Figure wear_figure(const Problem& problem, const WearRecord& record, const std::vector<double>& edges,
                   const std::vector<double>& run_in);

}  // namespace steadyslide::app
