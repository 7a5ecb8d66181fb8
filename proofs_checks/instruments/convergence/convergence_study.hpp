#pragma once
// A problem solved on many meshes, and once by its singular functions. Rates of convergence are measured on these
// solutions.

#include <optional>

#include "enclosure/cells/cell_bound.hpp"
#include "proofs_checks/instruments/convergence/convergence_cases.hpp"
#include "proofs_checks/kit/rate.hpp"

namespace steadyslide::proofs_checks {

/// The smallest number of cells on which intensities are fitted. With fewer cells there may be too few between two
/// singular points.
inline constexpr std::size_t first_with_intensities = std::size_t{1} << 11;

/// The quantities of a solution that are compared with those of another.
struct SolvedQuantities {
  struct End {
    double x;
    bool exact;  ///< true for an edge or a step
  };
  std::vector<End> ends;
  std::vector<double> resultants;
  std::vector<double> intensities;  ///< and constants; empty if they were not fitted
};

/// Returns the names of the resultants that are not given by the problem: load shares and effective friction if the
/// friction jumps, and the centre of pressure, or the tilt if the indenter may tilt.
std::vector<std::string> resultant_names(const ContactProblem& problem);

struct SolvedReference {
  SolvedQuantities solved;
  std::vector<std::string> intensity_names;  ///< "theta at -1.0000", "constant at 0.1429", left to right
};

/// Returns the Riemann-Hilbert solution. Throws std::runtime_error if it does not solve the problem.
SolvedReference reference(const ContactProblem& problem);

struct OnMesh {
  std::size_t cells;
  double cell_length;
  SolvedQuantities solved;
};

/// Meshes with about the same number of cells. The numbers are consecutive, so that ends and friction jumps lie at
/// different places within a cell.
struct MeshLevel {
  std::size_t cells;  ///< number of cells of the first mesh
  std::vector<OnMesh> meshes;
  /// The proved bounds on the first mesh; they do not use the solution. Nothing if the energy does not bound the error.
  std::optional<enclosure::CellBound> bound;
};

/// Returns the proved interval of resultant k of resultant_names(), or null if k is neither a load share nor the
/// friction.
const enclosure::Ball* proved_resultant(const enclosure::CellBound& bound, std::size_t k);

/// The exponent fitted to the cells on one side of a singular point, and the exponent that the theory gives.
struct ReadExponent {
  double x;
  Side side;
  Estimate<double> found;
  Exponent derived;
  Exponent reversed;  ///< for friction with the opposite sign
};

struct ConvergenceStudy {
  double rate;  ///< expected rate
  std::vector<MeshLevel> levels;
  OnMesh fine;  ///< one mesh, for the fit of exponents
  std::vector<ReadExponent> exponents;
};

/// The meshes of a study. Each level has seven meshes. If the expected rate is 2, it has 21: then the error is that of
/// the position of a free end within its cell, which scatters.
struct StudyPlan {
  std::size_t last;  ///< cells of the last level; the first has 64
  std::size_t fine;  ///< cells of the mesh to which exponents are fitted
  enum class Exponents { none, one_of_a_kind, all } exponents;

  static StudyPlan full() { return {std::size_t{1} << 14, std::size_t{1} << 14, Exponents::all}; }
  /// Fits one edge, one free end and one side of one friction jump, because fits take most of the time.
  static StudyPlan quick() { return {std::size_t{1} << 9, std::size_t{1} << 12, Exponents::one_of_a_kind}; }
};

/// Returns the study. Throws std::runtime_error if the problem is not solved on a mesh.
ConvergenceStudy study(const ContactProblem& problem, const StudyPlan& plan);

/// Return the root mean square over the meshes of a level of the error of resultant k, and of the relative error of
/// intensity k. The result is NaN if an intensity was not fitted on all of them.
double resultant_error(const MeshLevel& level, const SolvedQuantities& exact, std::size_t k);
double intensity_error(const MeshLevel& level, const SolvedQuantities& exact, std::size_t k);

}  // namespace steadyslide::proofs_checks
