#pragma once
// The solution that variational_inequality() returns: a solution on cells in the user's units and x. The cells may cover
// a part of the support; outside them there is no contact.

#include <functional>

#include "numeric/layers/layer_field.hpp"
#include "numeric/number/once.hpp"
#include "numeric/solution/contact_solution.hpp"
#include "numeric/variational/local_fit.hpp"
#include "numeric/variational/nested_solve.hpp"

namespace steadyslide::numeric {

class VariationalSolution : public ContactSolution<double> {
 public:
  VariationalSolution(ContactProblem problem, variational::NestedResult found);

  const variational::NestedResult& found() const { return found_; }
  /// A run of cells in contact: from the first cell to the one after the last.
  struct Run {
    std::size_t begin;
    std::size_t end;
  };
  /// Returns the ends of the runs, without errors.
  std::vector<std::pair<double, double>> zones() const {
    std::vector<std::pair<double, double>> result;
    for (const Run& run : runs_) result.emplace_back(origin_ + edges_[run.begin], origin_ + edges_[run.end]);
    return result;
  }
  /// True if the contact reaches an end of the support.
  bool reaches_edge() const;
  /// An interval in xi of the support's frame.
  struct Part {
    double left;
    double right;
  };
  /// Returns the shortest part of the support that contains the contact; empty without contact.
  std::optional<Part> contact_part() const;
  /// Returns the shortest part of the support that contains all places outside the cells where the indenter penetrates.
  /// The places are the middles of cells of a mesh on the support, and the breaks of the profile in its frame.
  std::optional<Part> penetrated_part(const variational::DiscreteProblem& support,
                                      const variational::CellProfile& profile) const;
  /// Returns the length of a cell in the user's unit.
  double cell_length() const { return unit_ * mesh().length(0); }
  /// Returns the places and means of t for local fits, in the user's units; x is measured from the middle of all cells.
  variational::Cells cells() const { return {edges_, traction_}; }
  /// Returns the same on half as many cells.
  variational::Cells coarse_cells() const { return {coarse_edges_, coarse_traction_}; }

  /// Returns -t on the cells, in the user's unit, for a state that touches in every cell in contact. Error bounds use
  /// this state. Empty if the cells do not cover the support. It takes some seconds on 2^16 cells.
  std::vector<double> touching_pressures() const;

  std::string method() const override { return "variational"; }
  std::string failed_condition() const override;
  std::optional<EqualCells> equal_cells() const override {
    const auto& [origin, unit] = mesh().frame();
    return EqualCells{mesh().size(), origin - unit / 2, origin + unit / 2};
  }
  std::vector<ContactComponent<double>> contact() const override;
  std::vector<SolvedSingularPoint<double>> singular_points() const override;
  Resultants<double> resultants() const override;
  /// Returns infinity if the data imply it for a place inside the contact: at edges, at friction jumps (by their
  /// power), at convex wedges (by a logarithm whose intensity is exact). Otherwise it returns the largest mean over a
  /// cell.
  LargestPressure<double> largest_pressure() const override;
  AveragePressure<double> largest_average_pressure(const double& length) const override;
  std::optional<Estimate<double>> tilt() const override;
  EstimatedError<double> estimated_error() const override {
    return estimated_error_([this] { return errors(); });
  }
  /// Returns the residuals of the certificate. `equation` is the largest mean gap of a cell in contact, in units of c
  /// P.
  Residuals<double> residuals() const override;
  Sample<double> at(const Rational& x) const override;
  PiecewiseTraction<double> piecewise_traction() const override;
  std::vector<Sample<double>> samples(int count) const override;
  DetailedSample<double> details_at(const Rational& x) const override;
  std::vector<DetailedSample<double>> detailed_samples(int count) const override;

  /// A place where the traction is singular or the profile changes its polynomial, as located on the cells.
  struct SingularPlace {
    double x;  ///< measured from the middle of all cells
    SingularKind kind;
    std::optional<Exponent> exponent;      ///< absent: logarithm, or not singular
    variational::LocalPlace surroundings;  ///< for local fits; x as above
    Side contact;                          ///< for an end
    std::size_t friction_left;             ///< friction pieces
    std::size_t friction_right;
    int wedge_degree;  ///< degree of the slope's jump, which is a polynomial; -1: none
    bool exact;        ///< true if x is exact, which means not a free end
    double error = 0;  ///< for a free end: error of x, beyond rounding
    double moved = 0;  ///< for a free end: one cell, plus the further difference of x on the coarser mesh
    bool is_end() const { return local_terms(kind).is_end; }
  };
  /// Returns all places from left to right.
  const std::vector<SingularPlace>& places() const { return places_; }

 private:
  const variational::DiscreteProblem& discrete() const { return *found_.fine.problem; }
  const variational::CellMesh& mesh() const { return discrete().mesh(); }
  const variational::SurfaceKernel& kernel() const { return discrete().galerkin_operator().kernel(); }
  const variational::DiscreteState& state() const { return found_.fine.found.state; }

  /// The forces on one of the nested meshes.
  struct MeshLoads {
    std::vector<double> before;  ///< the load share left of each cell; the last entry is for all cells
    double centre = 0;           ///< centre of pressure, xi
    double tilt;
    double approach;
    explicit MeshLoads(const variational::DiscreteState& state);
    double before_place(double xi) const;
    /// Returns the load between two places.
    double between(double a, double b) const;
    /// Returns the largest mean of the load share over windows of this length inside the contact, and the middle of the
    /// window.
    std::pair<double, double> largest_average(double length) const;
  };
  /// Returns the traction on one of the nested meshes.
  PiecewiseTraction<double> traction_on(const MeshLoads& loads) const;
  /// Returns the error of a quantity that each mesh gives.
  double open_error(const std::function<double(const MeshLoads&)>& on_mesh) const;
  /// Returns the error of a run's load due to its few cells, as a fraction of P.
  double load_in_doubt(const Run& run) const;
  /// Returns the fraction of P that may lie on the other side of a friction jump at xi, next to which contact ends.
  double load_beyond_end(double xi) const;

  void find_runs();
  EstimatedError<double> errors() const;
  /// Returns the error of the load shares, and of the centre of pressure as a fraction of the contact.
  double resultant_error() const;
  /// Returns the largest difference from the coarser mesh: of a load share, or of the centre as a fraction of the
  /// contact.
  double moved_load() const;
  void find_places();
  /// Computes the error of the free ends: one cell, plus the change of the end since the coarser mesh, plus the
  /// fraction of the contact by which the resultants differ (displaced load moves the ends). If a gap is short, or the
  /// coarser mesh does not have it, or it has moved by much of its length, the error of its ends is the whole gap, and
  /// the gap is in doubt.
  void find_end_errors();
  SingularPlace end_place(const Run& run, End end) const;
  /// Returns the jumps of the profile where one period meets the next one, at the left end of the cells.
  Indenter::Break break_between_periods() const;
  variational::FittedIntensity fitted(const SingularPlace& place, const variational::Cells& cells) const;
  SolvedSingularPoint<double> solved_point(const SingularPlace& place) const;
  /// Returns the convex wedge with the strongest logarithm, among the wedges in the contact without a friction jump.
  std::optional<SolvedSingularPoint<double>> sharpest_wedge() const;
  /// Returns t of the coarser mesh at the middle of cell i.
  double coarse_traction(std::size_t i) const;
  Estimate<double> traction(std::size_t cell) const;
  /// Returns the mean of f over cell i, as in CellFriction; 0 on the half-plane.
  double signed_friction(std::size_t i) const {
    const std::vector<double>& f = discrete().galerkin_operator().friction().signed_friction;
    return f.empty() ? 0 : f[i];
  }
  double displacement(double xi) const;
  /// Returns B p of a mesh at a place outside the cells.
  double displacement_beyond(const variational::MeshSolution& solution, double xi) const;
  /// Returns the profile at a place of the support, in units of c P.
  double height_in_units(const Rational& x) const;
  bool is_on_support(const Rational& x) const;
  /// Returns the gap from B p on this mesh and on the coarser one; `rounding` is the error of the first.
  Estimate<double> gap(const Rational& x, double fine, double coarse, double rounding) const;
  /// Returns a slope outside the cells, on both sides of its place, with the relative error of the traction.
  TwoSided<double> slope_beyond(double slope) const;
  Sample<double> outside(const Rational& x) const;
  std::vector<Rational> sampled_places(int count) const;
  /// Returns psi + tilt x - gap, which is u + C; x is on the support.
  Estimate<double> height(const Rational& x) const;
  /// Returns u at a place outside the support minus u at the nearest end of the support.
  Estimate<double> rise_beyond(double xi) const;
  Estimate<double> load_before(double xi) const;
  /// Returns (1/pi) int t_t/(x'-x) dx' at the middles of equal cells, from t on the cells.
  std::vector<double> shear_transform(const std::vector<double>& traction) const;
  /// Returns u_t' of the half-plane under this traction, and what layers add to it; not known on other bodies.
  TwoSided<double> shear_slope(double xi, const TwoSided<double>& traction) const;
  Estimate<double> further_shear_slope(double x) const;

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
  std::vector<double> displacement_;  ///< B p for each cell
  std::vector<Run> runs_;
  std::vector<SingularPlace> places_;
  std::vector<std::size_t> ends_;  ///< indices into places_, two for each run
  /// For the cells and for the coarser cells.
  Once<std::pair<std::vector<double>, std::vector<double>>> shear_transforms_;
  Once<PiecewiseTraction<double>> surface_traction_;
  Once<LayerField> layers_;
  std::vector<MeshLoads> meshes_;  ///< the finest first
  /// Errors of integrals on N cells are 1/N^rate. Exponents of this problem and of that with reversed friction add to -1 at
  /// edges and jumps, to 0 at free ends; the rate is this sum plus 2. Runs of few
  /// cells and steep free ends have the rate 1.
  double mesh_rate_ = 2;
  Once<Estimate<double>> height_at_origin_;
  Once<EstimatedError<double>> estimated_error_;
  bool fills_period_ = false;  ///< contact without a gap, which has no ends
};

}  // namespace steadyslide::numeric
