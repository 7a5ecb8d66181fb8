#pragma once
// A solution on cells in the user's units and x: what variational_inequality() returns.

#include "numeric/number/once.hpp"
#include "numeric/solution/contact_solution.hpp"
#include "numeric/variational/local_fit.hpp"
#include "numeric/variational/nested_solve.hpp"

namespace steadyslide::numeric {

class VariationalSolution : public ContactSolution<double> {
 public:
  VariationalSolution(ContactProblem problem, variational::NestedResult found);

  const variational::NestedResult& found() const { return found_; }
  /// Runs of cells in contact, left to right: from the first cell to the one after the last.
  struct Run {
    std::size_t begin;
    std::size_t end;
  };
  const std::vector<Run>& runs() const { return runs_; }
  /// Does the contact reach an end of the support?
  bool reaches_edge() const;
  /// Of a cell, in the user's unit of length.
  double cell_length() const { return unit_ * mesh().length(0); }
  /// Places and means of t, in the user's units, x less the middle of the support: what local fits look at.
  variational::Cells cells() const { return {edges_, traction_}; }
  /// The same on half as many cells.
  variational::Cells coarse_cells() const { return {coarse_edges_, coarse_traction_}; }

  /// -t on the cells, in the user's unit, of a state that touches in every cell in contact: what an error bound is asked
  /// for. Some seconds on 2^16 cells.
  std::vector<double> touching_pressures() const;

  std::string method() const override { return "variational"; }
  std::string failed_condition() const override;
  std::vector<ContactComponent<double>> contact() const override;
  std::vector<SolvedSingularPoint<double>> singular_points() const override;
  Resultants<double> resultants() const override;
  /// Infinite where the data say so of a place inside the contact: at edges, at friction jumps by their power, at convex
  /// wedges by a logarithm whose intensity is exact. Else the largest mean over a cell.
  LargestPressure<double> largest_pressure() const override;
  std::optional<Estimate<double>> tilt() const override;
  EstimatedError<double> estimated_error() const override;
  /// From the certificate. Equation: the largest mean gap of a cell in contact, in units of c P.
  Residuals<double> residuals() const override;
  Sample<double> at(const Rational& x) const override;
  PiecewiseTraction<double> piecewise_traction() const override;
  std::vector<Sample<double>> samples(int count) const override;
  DetailedSample<double> details_at(const Rational& x) const override;
  std::vector<DetailedSample<double>> detailed_samples(int count) const override;

  /// A place where the traction is singular or changes its polynomial, as the cells see it.
  struct Place {
    double x;  ///< less the middle of the support
    SingularKind kind;
    std::optional<Exponent> exponent;      ///< absent: logarithm, or nothing singular
    variational::LocalPlace surroundings;  ///< for local fits; x as above
    Side contact;                          ///< of an end
    std::size_t friction_left;             ///< pieces
    std::size_t friction_right;
    int wedge_degree;  ///< of the jump of the slope, a polynomial; -1: none
    bool exact;        ///< x is known exactly: not a free end
    double error = 0;  ///< of x, beyond rounding; a free end's
    double moved = 0;  ///< a cell, and by how much more x differs on the coarser mesh; a free end's
    bool is_end() const { return local_terms(kind).is_end; }
  };
  /// All of them, left to right.
  const std::vector<Place>& places() const { return places_; }

 private:
  const variational::DiscreteProblem& discrete() const { return *found_.fine.problem; }
  const variational::CellMesh& mesh() const { return discrete().mesh(); }
  const variational::SurfaceKernel& kernel() const { return discrete().galerkin_operator().kernel(); }
  const variational::DiscreteState& state() const { return found_.fine.found.state; }

  /// Forces on one of the nested meshes.
  struct MeshLoads {
    std::vector<double> before;  ///< the part of P left of each cell, and of all
    double centre;               ///< of pressure, xi
    double tilt;
    explicit MeshLoads(const variational::DiscreteState& state);
    double before_place(double xi) const;
    /// The load between two places.
    double between(double a, double b) const;
  };
  /// The error of a number that each mesh has, `on_mesh(MeshLoads) -> double`.
  template <class OnMesh>
  double open_error(OnMesh on_mesh) const;
  /// The part of P by which the load of a run may be wrong because it has few cells.
  double load_in_doubt(const Run& run) const;
  /// The part of P that may lie on the other side of a friction jump at xi, next to which contact ends.
  double load_beyond_end(double xi) const;

  void find_runs();
  /// Of the load shares, and of the centre of pressure in parts of the contact.
  double resultant_error() const;
  /// By how much the coarser mesh has it otherwise: the most of a load share, or of the centre in parts of the contact.
  double moved_load() const;
  void find_places();
  /// What a free end may be off by: a cell, what the end has moved since the coarser mesh, and, for the load that lies
  /// elsewhere moves it along, the part of the contact by which the resultants differ. The ends of a gap that is short, that
  /// the coarser mesh does not have, or that has moved by much of its length, are off by all of it, and the gap is in doubt.
  void find_end_errors();
  Place end_place(const Run& run, End end) const;
  variational::FittedIntensity fitted(const Place& place, const variational::Cells& cells) const;
  SolvedSingularPoint<double> solved_point(const Place& place) const;
  /// The convex wedge with the strongest logarithm among those in the contact under one friction.
  std::optional<SolvedSingularPoint<double>> sharpest_wedge() const;
  /// t of the coarser mesh where cell i has its middle.
  double coarse_traction(std::size_t i) const;
  Estimate<double> traction(std::size_t cell) const;
  double displacement(double xi) const;
  /// A slope off the support, on both sides of its place, as well known as the traction.
  TwoSided<double> slope_beyond(double slope) const;
  Sample<double> outside(const Rational& x) const;
  std::vector<Rational> sampled_places(int count) const;
  /// psi + tilt x - gap, which is u + C; in the support.
  Estimate<double> height(const Rational& x) const;
  /// u at a place off the support less that at its end there.
  Estimate<double> rise_beyond(double xi) const;
  Estimate<double> load_before(double xi) const;
  /// (1/pi) int t_t/(x'-x) dx' at the middles of equal cells, from t on them.
  std::vector<double> shear_transform(const std::vector<double>& traction) const;
  TwoSided<double> shear_slope(double xi, const TwoSided<double>& traction) const;

  ContactProblem problem_;
  variational::NestedResult found_;
  double origin_;
  double unit_;
  double stress_;  ///< P/unit
  double height_;  ///< c P
  std::vector<double> edges_;
  std::vector<double> traction_;
  std::vector<double> coarse_edges_;
  std::vector<double> coarse_traction_;
  std::vector<double> displacement_;  ///< B p of each cell
  std::vector<Run> runs_;
  std::vector<Place> places_;
  std::vector<std::size_t> ends_;  ///< which of places_, two of each run
  /// Of the cells and of the coarser ones.
  Once<std::pair<std::vector<double>, std::vector<double>>> shear_transforms_;
  std::vector<MeshLoads> meshes_;  ///< the finest first
  Once<Estimate<double>> height_at_origin_;
};

}  // namespace steadyslide::numeric
