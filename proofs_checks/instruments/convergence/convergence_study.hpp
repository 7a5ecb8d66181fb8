#pragma once
// A problem solved on many meshes, and once by its singular functions: what convergence is read from.

#include <optional>

#include "enclosure/cells/cell_bound.hpp"
#include "proofs_checks/instruments/convergence/convergence_cases.hpp"
#include "proofs_checks/kit/rate.hpp"

namespace steadyslide::proofs_checks {

/// With fewer cells there are not always enough of them between two singular points for an intensity to be read.
inline constexpr std::size_t first_with_intensities = std::size_t{1} << 11;

/// What a solution says that others can be compared with.
struct SolvedQuantities {
  struct End {
    double x;
    bool exact;  ///< an edge or a step
  };
  std::vector<End> ends;
  std::vector<double> resultants;
  std::vector<double> intensities;  ///< and constants; empty if they were not read
};

/// Names of the resultants that the problem leaves open: load shares and effective friction where friction jumps, the
/// centre of pressure, or the tilt where the indenter may tilt.
std::vector<std::string> resultant_names(const ContactProblem& problem);

struct SolvedReference {
  SolvedQuantities solved;
  std::vector<std::string> intensity_names;  ///< "theta at -1.0000", "constant at 0.1429", left to right
};

/// By Riemann-Hilbert. Throws std::runtime_error where it does not solve the problem.
SolvedReference reference(const ContactProblem& problem);

struct OnMesh {
  std::size_t cells;
  double cell_length;
  SolvedQuantities solved;
};

/// Meshes of about the same number of cells: consecutive numbers, so that ends and jumps fall everywhere in a cell.
struct MeshLevel {
  std::size_t cells;  ///< the first
  std::vector<OnMesh> meshes;
  /// What is proved of the first mesh, without knowing the solution; nothing where no energy bounds the error.
  std::optional<enclosure::CellBound> bound;
};

/// The proved interval of resultant k of resultant_names(); null if k is none of the load shares and friction.
const enclosure::Ball* proved_resultant(const enclosure::CellBound& bound, std::size_t k);

/// The exponent read off the cells on one side of a singular point, and what the theory has there.
struct ReadExponent {
  double x;
  Side side;
  Estimate<double> found;
  Exponent derived;
  Exponent reversed;  ///< of the friction sliding the other way
};

struct ConvergenceStudy {
  double rate;  ///< expected
  std::vector<MeshLevel> levels;
  OnMesh fine;  ///< one mesh, from which exponents are read
  std::vector<ReadExponent> exponents;
};

/// What is solved. Seven meshes on each level; where the expected rate is 2 as many as 21, for there the error is that
/// of a free end within its cell, and scatters.
struct StudyPlan {
  std::size_t last;  ///< level; the first has 64 cells
  std::size_t fine;  ///< cells of the one mesh from which exponents are read
  enum class Exponents { none, one_of_a_kind, all } exponents;

  static StudyPlan full() { return {std::size_t{1} << 14, std::size_t{1} << 14, Exponents::all}; }
  /// One edge, one free end and one side of one friction jump: fits take most of the time.
  static StudyPlan quick() { return {std::size_t{1} << 9, std::size_t{1} << 12, Exponents::one_of_a_kind}; }
};

/// Throws std::runtime_error where a mesh is not solved.
ConvergenceStudy study(const ContactProblem& problem, const StudyPlan& plan);

/// Root mean squares over the meshes of a level: of resultant k, and of intensity k relative to the exact one; not a
/// number where it was not read on all of them.
double resultant_error(const MeshLevel& level, const SolvedQuantities& exact, std::size_t k);
double intensity_error(const MeshLevel& level, const SolvedQuantities& exact, std::size_t k);

}  // namespace steadyslide::proofs_checks
