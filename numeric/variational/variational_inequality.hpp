#pragma once
// The contact problem as a variational inequality on cells: piecewise constant traction, Galerkin with exact
// logarithmic integrals, active sets, products by FFT. It knows no exponents: the witness beside the Riemann-Hilbert
// solver, and the method for measured profiles. [Bal16, section 3.1]

#include <cstdint>
#include <functional>

#include "numeric/solution/contact_solution.hpp"
#include "numeric/variational/friction_rule.hpp"

namespace steadyslide::numeric {

inline constexpr std::size_t fewest_cells = 16;
inline constexpr std::size_t most_cells = std::size_t{1} << 22;

struct VariationalOptions {
  std::size_t cells = 4096;  ///< equal cells on the support, fewest_cells to most_cells
  int most_steps = 100;      ///< of the active sets, on each of the nested meshes
  variational::FrictionRule friction_rule = variational::FrictionRule::damped;
  /// Called now and then: how much of the work is done, of how much. May throw to end the solve.
  std::function<void(std::size_t done, std::size_t total)> progress = {};
};

/// Any profile. In double whatever else is asked for: the error is that of the cells. What the certificate of the
/// result does not accept says so by failed_condition(). `reason`: an elastic indenter whose contact reaches an edge.
///
/// Ends are those of the cells in contact. Their error is a cell where the coarser mesh agrees; ends that move when the
/// cells are halved, as beside a strong fall of s, are off by more, and an error that reaches across a gap says that
/// cells cannot tell whether there is one. Intensities are fitted where there are cells enough for it, and have an
/// infinite error where not; singular points closer to each other than the cells can show are left out.
Attempt<double> variational_inequality(const ContactProblem& problem, const VariationalOptions& options = {});

/// One of the solutions that a search has met.
struct FoundSolution {
  std::shared_ptr<const ContactSolution<double>> variational;
  std::shared_ptr<const ContactSolution<double>> refined;  ///< by Riemann-Hilbert, of the same contact; may be absent
  int times = 0;                                           ///< how many starts led to it
};

struct SolutionSearch {
  int starts = 0;
  int unsolved = 0;                      ///< starts that led to no solution
  std::vector<FoundSolution> solutions;  ///< those met most often first
  /// How many different ones the refinements are: few cells under a strong fall of s can have several solutions where
  /// finer ones have one.
  int refinements = 0;
  std::string reason;
};

/// Starts from `starts` >= 1 different contact sets: the whole support, then random ones (of a fixed seed) between
/// single spots and almost everything. Two solutions are one if their tractions differ by less than
/// a hundredth of the load, int |t - t'| < P/100, or by less than what doubling the cells changes. Always by Galerkin's
/// rule: how many solutions it has is what theorems speak of.
SolutionSearch search_solutions(const ContactProblem& problem, int starts, const VariationalOptions& options = {},
                                std::uint64_t seed = 2016);

}  // namespace steadyslide::numeric
