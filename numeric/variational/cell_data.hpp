#pragma once
// The cells of the variational solver, and the data of a problem on them, by exact integration, also with jumps and
// breaks inside a cell.

#include <vector>

#include "model/reduced_problem.hpp"
#include "numeric/number/real.hpp"
#include "numeric/variational/friction_rule.hpp"

namespace steadyslide::numeric::variational {

/// Returns the frame in which an interval of x is xi from -1/2 to 1/2.
Frame frame_between(const Rational& left, const Rational& right);
/// Returns the same for the support.
Frame support_frame(const ContactProblem& problem);

/// The cells on which the variational solver's traction is constant. Lengths are reduced, xi = (x - origin)/unit, with
/// the length of all cells as unit, so that -log|xi - xi'| >= 0 everywhere on them.
class CellMesh {
 public:
  /// Makes `cells` >= 1 equal cells, xi from -1/2 to 1/2, for any jumps and breaks.
  CellMesh(Frame frame, std::size_t cells);
  /// Makes equal cells on the support.
  CellMesh(const ContactProblem& problem, std::size_t cells) : CellMesh(support_frame(problem), cells) {}
  /// Makes cells of any lengths, which may be refined towards the place `origin`. `edges` are xi of their ends,
  /// increasing; the first and the last one are the ends of the support.
  CellMesh(const ContactProblem& problem, const Rational& origin, std::vector<double> edges);

  const Frame& frame() const { return frame_; }
  bool is_uniform() const { return uniform_; }
  std::size_t size() const { return edges_.size() - 1; }
  /// Returns the left end of cell i, in xi.
  double left(std::size_t i) const { return edges_[i]; }
  double right(std::size_t i) const { return edges_[i + 1]; }
  double length(std::size_t i) const { return uniform_ ? length_ : edges_[i + 1] - edges_[i]; }
  double centre(std::size_t i) const { return (edges_[i] + edges_[i + 1]) / 2; }
  const std::vector<double>& edges() const { return edges_; }
  /// Returns the cell that contains xi; between two cells, the right one; outside all cells, the nearest one.
  std::size_t cell_at(double xi) const;
  /// Returns xi of a place of the problem, rounded once.
  double place(const Rational& x) const { return to_real<double>((x - frame_.origin) / frame_.unit); }

 private:
  Frame frame_;
  std::vector<double> edges_;
  bool uniform_;
  double length_ = 0;
};

/// Returns the edges of a mesh that is refined towards xi = 0 on both sides. The cells next to 0 have the length
/// `smallest`; each following one is `ratio` > 1 times as long as the one before it, up to `largest`.
std::vector<double> graded_edges(double left, double right, double smallest, double ratio, double largest);

/// Integrals of s over each cell.
struct CellFriction {
  std::vector<double> whole;  ///< int s
  /// The mean over x in the cell of int s from its left end to x, or from x to its right end if s is negative. It is
  /// the contribution of a traction on the cell to the cell's own mean displacement. It is the whole int |s| if the
  /// equation applies at the end of the cell.
  std::vector<double> own;
  /// +1: s >= 0, and the displacement is measured from the left end of the support. -1: s <= 0 somewhere, and the
  /// displacement is measured from the right end. So friction never lowers the surface; the difference is part of the
  /// indenter's approach.
  int sign = 1;
  /// The cells whose equation applies at their right end (with sign < 0 at their left end); empty: none.
  std::vector<char> at_end = {};
  /// The part of s that is no friction, the same everywhere. `whole` and `own` contain it.
  double shift = 0;
  /// The mean of f, f > 0 sliding towards +x, otherwise f < 0; empty for the half-plane, where only s counts.
  std::vector<double> signed_friction = {};

  bool is_at_end(std::size_t i) const { return !at_end.empty() && at_end[i]; }
};
/// `shift` is added to s everywhere.
CellFriction cell_friction(const ContactProblem& problem, const CellMesh& mesh,
                           FrictionRule rule = FrictionRule::galerkin, double shift = 0);
/// Returns the mean over each cell of a function with one value for each friction value.
std::vector<double> means_of_pieces(const ContactProblem& problem, const CellMesh& mesh,
                                    const std::vector<double>& values);

/// Returns psi(x) minus its value at the middle of the support. Only differences matter, and these are small near the
/// contact.
Rational profile_above_middle(const ContactProblem& problem, const Rational& x);
/// Returns the sum of the profile's harmonics at x, and its slope; 0 without them.
struct HarmonicSum {
  double height;
  double slope;
};
HarmonicSum harmonic_sum(const ContactProblem& problem, const Rational& x);

/// (profile_above_middle + harmonics)/(c P) in xi of uniform meshes, prepared for means over cells.
class CellProfile {
 public:
  CellProfile(const ContactProblem& problem, const Frame& frame);
  /// Returns the mean over each cell of a mesh with the given frame.
  std::vector<double> means(const CellMesh& mesh) const;
  /// Returns the value at a place; where two pieces meet, on that side.
  double operator()(double xi, Side side) const;
  /// Returns the places where two pieces meet.
  const std::vector<double>& breaks() const { return ends_; }

 private:
  /// A piece expanded about its own point, so that nothing cancels far from the origin of x.
  struct LocalPiece {
    double origin;
    std::vector<double> coefficients;

    double operator()(double xi) const;
    double integral(double left, double right) const;
  };
  static LocalPiece local_piece(const Polynomial& profile, const Rational& middle, const Frame& frame,
                                const Rational& height, const Rational& scale);

  /// amplitude cos(wave_number (xi - crest))
  struct Wave {
    double wave_number;
    double crest;
    double amplitude;
  };
  double waves_at(double xi) const;

  std::vector<LocalPiece> pieces_;
  std::vector<Wave> waves_;
  std::vector<double> ends_;  ///< right ends of all pieces except the last
};

}  // namespace steadyslide::numeric::variational
