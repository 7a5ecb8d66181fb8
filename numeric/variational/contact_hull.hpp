#pragma once
// The operator and its approximate inverse on the cells from the contact's first to its last one, on a uniform mesh.

#include <memory>

#include "numeric/variational/discrete_problem.hpp"
#include "numeric/variational/zone_coupling.hpp"

namespace steadyslide::numeric::variational {

/// Serves one system at a time. Not to be used from two threads.
struct ContactHull {
  std::size_t first;
  GalerkinOperator influence;
  SurfaceInverse inverse;
  std::unique_ptr<ZoneCoupling> coupling;  ///< of the last contact with several zones; may be absent

  ContactHull(const DiscreteProblem& problem, std::size_t first, std::size_t count);
};

/// Around a contact that is not empty, and a little wider: where `last`, around a contact of the same problem that was
/// nearly this one, has the same cells, it is that.
std::shared_ptr<ContactHull> contact_hull(const DiscreteProblem& problem, const CellSet& contact,
                                          std::shared_ptr<ContactHull> last = nullptr);

/// What lies between the widest gaps of a contact, given by its cells, increasing: at most so many zones, gaps of one width
/// taken all or none. `most` >= 1.
std::vector<CellRange> contact_zones(const std::vector<std::size_t>& cells, std::size_t most);

}  // namespace steadyslide::numeric::variational
