#pragma once
// Linear systems of a few equations, in any of the three numbers; large ones in double are for dense_lu.hpp.

#include <optional>
#include <vector>

#include "numeric/number/real.hpp"

namespace steadyslide::numeric {

/// The equations row[0] x_0 + ... + row[n-1] x_{n-1} = row[n], one a row, by elimination. Rows may be of very different
/// size: each is scaled to one. Absent where a row is zero; not finite where the rows depend on each other.
template <Real R>
std::optional<std::vector<R>> solve_linear(std::vector<std::vector<R>> rows);

}  // namespace steadyslide::numeric
