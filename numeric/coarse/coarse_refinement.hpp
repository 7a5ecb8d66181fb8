#pragma once
// Where the cells of a coarse solution are too long.

#include <vector>

#include "numeric/coarse/coarse_equilibrium.hpp"

namespace steadyslide::numeric::coarse {

/// Cells [first, last[ in contact, cut at steps of the profile: a face that stands back is not in contact at the step.
/// Gaps that the mesh does not resolve are left in: a long last cell beside short free ones can make one.
struct Run {
  std::size_t first;
  std::size_t last;
};

std::vector<Run> runs(const Mesh& mesh, const std::vector<char>& active);

/// Into how many parts each cell should be cut: all 1 where the mesh is good enough.
std::vector<int> wanted_pieces(const Influence& influence, const Equilibrium& state);

}  // namespace steadyslide::numeric::coarse
