#pragma once
// The contact problem on cells: pressures p_i >= 0 and mean gaps g_i >= 0 with p_i g_i = 0,
//
//   g = psi + tilt xi + B p - approach,   sum p_i h_i = 1,   and with load_at   sum p_i h_i xi_i = xi_load,
//
// p in units of P/unit, heights in units of c P. With the damped rule some g_i are gaps at an end of their cell, and
// xi_i is that place (friction_rule.hpp). No exponents and no singular functions are used. [Bal16, section 3.1]

#include <optional>
#include <vector>

#include "numeric/variational/galerkin_operator.hpp"

namespace steadyslide::numeric::variational {

/// Returns the kernel of the problem's body, in the frame's unit.
SurfaceKernel surface_kernel(const ContactProblem& problem, const Frame& frame);

class DiscreteProblem {
 public:
  /// The damped rule requires a uniform mesh. `shift` is added to s everywhere.
  DiscreteProblem(const ContactProblem& problem, const CellMesh& mesh, FrictionRule rule = FrictionRule::galerkin,
                  const SurfaceKernel& kernel = {}, double shift = 0);
  /// Takes an existing profile in the mesh's frame, so that meshes can share it.
  DiscreteProblem(const ContactProblem& problem, CellMesh mesh, const CellProfile& profile, FrictionRule rule,
                  const SurfaceKernel& kernel = {}, double shift = 0);
  /// Takes another problem, lowers the profile of cell i by lowered[i], and adds diagonal[i] p_i to its displacement;
  /// an empty diagonal adds nothing.
  DiscreteProblem(const DiscreteProblem& other, const std::vector<double>& lowered,
                  const std::vector<double>& diagonal = {});

  const CellMesh& mesh() const { return mesh_; }
  const GalerkinOperator& galerkin_operator() const { return galerkin_operator_; }
  const std::vector<double>& profile() const { return profile_; }
  /// Returns xi of load_at.
  const std::optional<double>& load_at() const { return load_at_; }
  std::size_t size() const { return mesh_.size(); }
  /// Returns xi of the gap of cell i, which is also the factor of the tilt: the cell's middle, or its end.
  double place(std::size_t i) const;
  /// True if all equations are means over cells, also under strong friction.
  bool is_galerkin() const { return galerkin_operator_.friction().at_end.empty(); }

 private:
  CellMesh mesh_;
  GalerkinOperator galerkin_operator_;
  std::vector<double> profile_;
  std::optional<double> load_at_;
};

/// 1: contact, 0: gap, cell by cell.
using CellSet = std::vector<char>;
/// Returns the cells in contact, in increasing order.
std::vector<std::size_t> cells_of(const CellSet& contact);

struct DiscreteState {
  std::vector<double> pressure;
  double approach = 0;
  double tilt = 0;  ///< 0 without load_at
};

/// Returns the height of the profile over some cells, at least 1. The rounding of gaps is relative to it.
double height_over(const DiscreteProblem& problem, const std::vector<std::size_t>& cells);

/// Returns g of a state.
std::vector<double> gaps(const DiscreteProblem& problem, const DiscreteState& state);

}  // namespace steadyslide::numeric::variational
