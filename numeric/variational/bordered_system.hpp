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
  int products = 0;     ///< operator products taken; 0 for a factorisation
};

class BorderedSystem {
 public:
  virtual ~BorderedSystem() = default;
  /// rhs has an entry for each cell of the mesh; those outside the contact set are not looked at.
  virtual SystemSolution solve(std::span<const double> rhs, std::array<double, 2> loads) = 0;
  /// The last solution to a smaller tolerance; the products are those taken in addition.
  virtual SystemSolution refined(double tolerance) = 0;
};

/// LU of the whole matrix: the cube of the number of cells in contact, once.
std::unique_ptr<BorderedSystem> dense_system(const DiscreteProblem& problem, const CellSet& contact);

/// The operator and its approximate inverse on the cells from the contact's first to its last one, on a uniform mesh.
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

/// Krylov's method with products by FFT, on a uniform mesh. Starts from `guess`; stops at `tolerance` of the residual,
/// or where it no longer falls. `hull`: the contact's, made where it is not there.
std::unique_ptr<BorderedSystem> krylov_system(const DiscreteProblem& problem, const CellSet& contact,
                                              const DiscreteState& guess, double tolerance,
                                              std::shared_ptr<ContactHull> hull = nullptr);

/// rhs = -psi, loads those of the problem.
SystemSolution solve(BorderedSystem& system, const DiscreteProblem& problem);

}  // namespace steadyslide::numeric::variational
