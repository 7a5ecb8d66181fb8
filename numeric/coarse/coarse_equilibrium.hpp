#pragma once
// Contact on a fixed mesh: q >= 0, gap >= 0, q gap = 0 cell by cell, sum q = P, and with a load line sum q x = P x0.

#include <optional>
#include <vector>

#include "numeric/coarse/coarse_mesh.hpp"

namespace steadyslide::numeric::coarse {

struct Load {
  double force;
  std::optional<double> at;  ///< from the origin; present if the indenter may tilt
};

struct Equilibrium {
  std::vector<char> active;
  std::vector<double> force;  ///< q
  std::vector<double> gap;
  double tilt = 0;
  double violation = 0;  ///< the largest force or gap of the wrong sign, divided by P
  bool converged = false;
};

/// Forces and gaps with the contact set given, whatever their signs. Not finite where the equations are singular.
Equilibrium with_contact_on(const Mesh& mesh, const Load& load, const std::vector<char>& active);

/// The primal-dual active-set method from a first guess; where its sets cycle, load_path(). The guess may be empty.
Equilibrium equilibrium(const Mesh& mesh, const Load& load, std::vector<char> guess);

/// The contact set that is reached when the load grows from zero: at most one cell touches or leaves at a time. Where
/// friction makes the way turn, the load decreases again for a while: the pivots of Lemke. Forces of a given sum are a
/// bounded set, so that the way cannot end before any given load, whatever the matrix. Empty if rounding stops it.
std::vector<char> load_path(const Mesh& mesh, const Load& load);

/// Cells [first, last[ in contact, cut at steps of the profile: a face that stands back is not in contact at the step.
/// Gaps that the mesh does not resolve are left in: a long last cell beside short free ones can make one.
struct Run {
  std::size_t first;
  std::size_t last;
};

std::vector<Run> runs(const Mesh& mesh, const std::vector<char>& active);

/// Into how many parts each cell should be cut: all 1 where the mesh is good enough.
std::vector<int> wanted_pieces(const Mesh& mesh, const Equilibrium& state);

}  // namespace steadyslide::numeric::coarse
