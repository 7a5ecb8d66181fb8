#pragma once
// What a solution makes of the body and of a mesh of its surface, as texts: stresses and displacement gradients at points,
// the largest von Mises stress, consistent nodal forces.

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "enclosure/contact/enclosed_solution.hpp"
#include "library/problem_file/surface_files.hpp"
#include "library/text/number_format.hpp"
#include "numeric/solution/contact_solution.hpp"

namespace steadyslide::app {

using namespace library;

/// All of these are empty, or null, where not asked for.
struct FieldWanted {
  std::vector<DepthPoint> points;
  std::shared_ptr<const MeshFile> mesh;
  bool largest_stress = false;
  std::optional<Rational> depth;  ///< of the largest stress at least; absent: numeric::default_depth

  bool any() const { return !points.empty() || mesh || largest_stress; }
};

/// Empty texts where the problem has no materials.
struct StressText {
  std::string x, z;
  NumberText xx, zz, xz, yy, von_mises, largest_shear;
  std::array<NumberText, 4> gradient;  ///< d u_x/dx, d u_x/dz, d u_z/dx, d u_z/dz
};

struct NodalForceText {
  std::string x;
  NumberText normal, tangential;
};

struct LargestStressText {
  std::vector<NumberText> unbounded_at;  ///< places of the surface
  std::string depth;                     ///< the least one looked at
  NumberText von_mises, x, z;
  bool proved = false;  ///< that the stress at this place is von_mises: the largest one is not below that
};

struct FieldText {
  std::vector<StressText> stresses;
  std::vector<NodalForceText> nodal_forces;
  std::optional<LargestStressText> largest_stress;
  bool in_range = true;  ///< false: some value is no number
};

/// Throws InvalidFile where contact lies outside the mesh.
template <numeric::Real R>
FieldText field_text(const numeric::ContactSolution<R>& solution, const FieldWanted& wanted, int digits);

/// Enclosed: no largest stress.
FieldText field_text(const ContactProblem& problem, const enclosure::EnclosedSolution& solution,
                     const FieldWanted& wanted, int digits);

/// Encloses the stress at the place where a solver found the largest one: a lower bound. Where that is at the surface,
/// the stress at a depth of 1e-15 of the indenter's width.
LargestStressText lower_bound(const ContactProblem& problem, const enclosure::EnclosedSolution& solution,
                              LargestStressText found, int digits);

}  // namespace steadyslide::app
