#pragma once
// The contact problem as a variational inequality on cells: piecewise constant traction, Galerkin with exact
// logarithmic integrals, active sets, products by FFT. It uses no exponents. So it checks the Riemann-Hilbert solver
// independently, and is the method for measured profiles. [Bal16, section 3.1]

#include <cstddef>
#include <functional>

#include "numeric/solution/contact_solution.hpp"
#include "numeric/variational/friction_rule.hpp"

namespace steadyslide::numeric {

inline constexpr std::size_t fewest_cells = 16;
inline constexpr std::size_t most_cells = std::size_t{1} << 22;

struct VariationalOptions {
  std::size_t cells = 4096;  ///< equal cells on the support, fewest_cells to most_cells
  /// The wanted relative error of ends and resultants; 0 for none. If there is one, the solution on the support's cells
  /// only locates the contact. As long as the estimated error is larger, the problem is solved on more cells, up to
  /// most_cells, on the part of the support around the contact. The part grows to any place outside it where the
  /// indenter penetrates.
  double accuracy = 0;
  int most_steps = 100;  ///< largest number of active-set steps on each of the nested meshes
  variational::FrictionRule friction_rule = variational::FrictionRule::damped;
  /// Called repeatedly with the work done and the total work. It may throw to stop the solve.
  std::function<void(std::size_t done, std::size_t total)> progress = {};
};

/// Solves a problem with any profile. It always works in double, because the error is that of the cells. If the
/// certificate does not accept the result, failed_condition() returns why. `reason` is set for an elastic indenter
/// whose contact reaches an edge.
///
/// Ends of contact are ends of cells. Their error is one cell if the coarser mesh agrees. Ends that move when the cells
/// are halved, as beside a strong decrease of s, have a larger error. If the error covers a whole gap, the cells cannot
/// decide if the gap exists. Intensities are fitted if there are enough cells; otherwise their error is infinite.
/// Singular points that the cells cannot separate are left out. Periodic contact is solved from a gap on
/// (repeated_contact.hpp); without a gap it has no ends but those of the period.
Attempt<double> variational_inequality(const ContactProblem& problem, const VariationalOptions& options = {});

}  // namespace steadyslide::numeric
