#pragma once
// The equations of one contact set:
//
//   B p - approach + tilt xi = rhs on its cells, p = 0 on all others, sum p h = loads[0], and with load_at
//   sum p h xi = loads[1]   (without it tilt = 0).

#include <array>
#include <memory>
#include <span>

#include "numeric/variational/discrete_problem.hpp"
#include "numeric/variational/surface_inverse.hpp"

namespace steadyslide::numeric::variational {

struct SystemSolution {
  DiscreteState state;
  double residual = 0;  ///< the largest |B p - approach + tilt xi - rhs| on the contact set
  int products = 0;     ///< number of operator products; 0 for a factorisation
};

class BorderedSystem {
 public:
  virtual ~BorderedSystem() = default;
  /// Solves the system. rhs has an entry for each cell of the mesh; entries outside the contact set are ignored.
  virtual SystemSolution solve(std::span<const double> rhs, std::array<double, 2> loads) = 0;
  /// Returns the last solution with a smaller tolerance. `products` counts the additional products.
  virtual SystemSolution refined(double tolerance) = 0;
};

/// Returns a system solved by LU of the whole matrix. Its cost is the cube of the number of cells in contact, once.
std::unique_ptr<BorderedSystem> dense_system(const DiscreteProblem& problem, const CellSet& contact);

/// The operator and its approximate inverse on the cells from the contact's first to its last one, on a uniform mesh.
/// Only one system at a time may use it. Not thread-safe.
struct ContactHull {
  std::size_t first;
  GalerkinOperator influence;
  SurfaceInverse inverse;
  std::unique_ptr<ZoneCoupling> coupling;  ///< for the last contact with several zones; may be null

  ContactHull(const DiscreteProblem& problem, std::size_t first, std::size_t count);
};

/// Returns a hull slightly wider than a contact that is not empty. Returns `last`, the hull of a similar contact of the
/// same problem, if it has the same cells.
std::shared_ptr<ContactHull> contact_hull(const DiscreteProblem& problem, const CellSet& contact,
                                          std::shared_ptr<ContactHull> last = nullptr);

/// Divides a contact, given by its cells in increasing order, at its widest gaps into at most `most` >= 1 zones. Of
/// gaps with equal width either all or none are used.
std::vector<CellRange> contact_zones(const std::vector<std::size_t>& cells, std::size_t most);

/// Returns a system solved by a Krylov method with products by FFT, on a uniform mesh. It starts from `guess` and stops
/// if the residual is below `tolerance` or no longer decreases. `hull` is that of the contact; if null, it is made.
std::unique_ptr<BorderedSystem> krylov_system(const DiscreteProblem& problem, const CellSet& contact,
                                              const DiscreteState& guess, double tolerance,
                                              std::shared_ptr<ContactHull> hull = nullptr);

/// Solves for rhs = -psi and the loads of the problem.
SystemSolution solve(BorderedSystem& system, const DiscreteProblem& problem);

}  // namespace steadyslide::numeric::variational
