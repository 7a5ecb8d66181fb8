#pragma once
// The operator and its approximate inverse on the cells from the contact's first to its last one, on a uniform mesh.

#include <memory>

#include "numeric/variational/discrete_problem.hpp"
#include "numeric/variational/surface_inverse.hpp"

namespace steadyslide::numeric::variational {

/// Not to be used from two threads.
struct ContactHull {
  std::size_t first;
  GalerkinOperator influence;
  SurfaceInverse inverse;

  ContactHull(const DiscreteProblem& problem, std::size_t first, std::size_t count);
};

/// Around a contact that is not empty, and a little wider: where `last`, around a contact of the same problem that was
/// nearly this one, has the same cells, it is that.
std::shared_ptr<ContactHull> contact_hull(const DiscreteProblem& problem, const CellSet& contact,
                                          std::shared_ptr<ContactHull> last = nullptr);

}  // namespace steadyslide::numeric::variational
