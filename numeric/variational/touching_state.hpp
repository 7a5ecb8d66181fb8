#pragma once
// Pressures on cells whose gap has its minimum 0 in every cell in contact, not its mean.
//
// A state of the discrete problem has mean gap 0 on its cells in contact, so that it penetrates in each of them by what the
// gap varies within it. An error bound that asks for gap >= 0 at every place has to lift the indenter by the worst of
// these. Here each cell's profile is lowered by
//
//   delta_i = (mean of the gap over cell i) - (its least value there),
//
// and the problem on cells solved again; delta depends on the pressures, so that this is repeated as long as it gains.
// All by Galerkin's rule. The least values are taken at a few places of each cell, in double: what is proved of the state, others prove.

#include "numeric/variational/nested_solve.hpp"

namespace steadyslide::numeric::variational {

/// Gaps within cells of a uniform mesh.
class InnerGaps {
 public:
  InnerGaps(const ContactProblem& problem, const DiscreteProblem& discrete);

  struct Least {
    std::vector<double> below_mean;  ///< delta_i
    double duality_gap;              ///< int p (gap - its least value anywhere), in units of c P^2
    double within_cells;             ///< int p delta: what would be left of it if all least values were 0
  };
  Least least(const DiscreteState& state) const;

 private:
  /// The displacement by the logarithm alone at the place z of all cells.
  void displacement(std::size_t place, const std::vector<double>& p, std::vector<double>& result) const;
  /// int s from the left end of cell i, over a part of it.
  double friction(std::size_t i, double part) const;

  const DiscreteProblem& discrete_;
  CellProfile profile_;
  std::vector<double> jumps_;  ///< of s
  std::vector<double> s_;
  std::vector<double> breaks_;  ///< of the profile
  Fourier fourier_;
  std::vector<std::vector<std::complex<double>>> spectra_;
};

struct TouchingState {
  DiscreteState state;
  double duality_gap = 0;  ///< as InnerGaps has it
  int passes = 0;
};

/// From what was found on cells, which is returned where nothing better is. A pass may lose what the one before it gained.
TouchingState touching_state(const ContactProblem& problem, const MeshSolution& found, int most_passes = 16);

}  // namespace steadyslide::numeric::variational
