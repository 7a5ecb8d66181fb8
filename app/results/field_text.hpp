#pragma once
// Stresses, displacements and their gradients at points of the body, the largest von Mises stress, and consistent nodal
// forces on a mesh of the surface, as texts.

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/results/rows.hpp"
#include "enclosure/contact/enclosed_solution.hpp"
#include "library/problem_file/surface_files.hpp"
#include "library/text/number_format.hpp"
#include "numeric/solution/contact_solution.hpp"

namespace steadyslide::app {

using namespace library;

/// Every member is empty, or null, if the user did not request it.
struct FieldWanted {
  std::vector<DepthPoint> points;     ///< of stresses
  std::vector<DepthPoint> displaced;  ///< of displacements
  std::shared_ptr<const MeshFile> mesh;
  bool interfaces = false;
  bool largest_stress = false;
  std::optional<Rational> depth;  ///< the smallest depth for the largest stress; absent for numeric::default_depth

  /// True if something below the surface is wanted.
  bool is_inside() const { return has_stress() || !displaced.empty(); }
  bool has_stress() const { return !points.empty() || interfaces || largest_stress; }
  bool any() const { return is_inside() || mesh; }
};

/// Results at points, at interfaces or at nodes: a row for each.
struct FieldTable {
  std::string key;      ///< in JSON
  std::string heading;  ///< in text
  std::vector<Column> columns;
  std::vector<std::vector<Cell>> rows{};
};

struct LargestStressText {
  std::vector<NumberText> unbounded_at;  ///< places of the surface with unbounded stress
  std::string depth;                     ///< the smallest depth that was searched
  NumberText von_mises, x, z;
  bool proved = false;  ///< true: proved that the largest stress is at least von_mises
  /// The largest von Mises stress of the stresses averaged along x.
  struct Average {
    std::string over;  ///< the length of the window
    NumberText von_mises, x, z;
  };
  std::optional<Average> average;
};

struct FieldText {
  std::vector<FieldTable> tables;  ///< stresses, displacements, interfaces, nodal_forces; none is empty
  std::vector<std::array<NumberText, 4>> gradients{};  ///< of the stresses: d u_x/dx, d u_x/dz, d u_z/dx, d u_z/dz
  std::optional<LargestStressText> largest_stress{};
  bool in_range = true;  ///< false: some value is NaN or infinite

  bool any() const { return !tables.empty() || largest_stress; }
};

/// Throws InvalidFile if contact lies outside the mesh. With a window `over`, the largest stress has an average.
template <numeric::Real R>
FieldText field_text(const ContactProblem& problem, const numeric::ContactSolution<R>& solution,
                     const FieldWanted& wanted, const std::optional<Rational>& over, int digits);

/// The same with enclosed numbers; it has no largest stress, no displacements, and no point at the surface.
FieldText field_text(const ContactProblem& problem, const enclosure::EnclosedSolution& solution,
                     const FieldWanted& wanted, int digits);

/// Encloses the stress at the place where a solver found the largest one. This is a lower bound of the largest stress.
/// If the place is at the surface, it takes the stress at a depth of 1e-15 of the indenter's width.
LargestStressText lower_bound(const ContactProblem& problem, const enclosure::EnclosedSolution& solution,
                              LargestStressText found, int digits);

}  // namespace steadyslide::app
