#pragma once
// Contact on a fixed mesh: q >= 0, gap >= 0, q gap = 0 cell by cell, sum q = P, and with a load line sum q x = P x0.

#include <optional>
#include <vector>

#include "numeric/coarse/coarse_influence.hpp"

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
Equilibrium with_contact_on(Influence& influence, const Load& load, const std::vector<char>& active);

/// The primal-dual active-set method from a first guess; where its sets cycle, load_path(). The guess may be empty.
Equilibrium equilibrium(Influence& influence, const Load& load, std::vector<char> guess);

/// The contact set that is reached when the load grows from zero: at most one cell touches or leaves at a time. Where
/// friction makes the way turn, the load decreases again for a while: the pivots of Lemke. Forces of a given sum are a
/// bounded set, so that the way cannot end before any given load, whatever the matrix. Empty if rounding stops it.
std::vector<char> load_path(Influence& influence, const Load& load);

}  // namespace steadyslide::numeric::coarse
