#pragma once
// The cells of the variational solver, and what they see of a problem, by exact integration, also of jumps and breaks inside a
// cell.

#include <vector>

#include "model/reduced_problem.hpp"
#include "numeric/number/real.hpp"
#include "numeric/variational/friction_rule.hpp"

namespace steadyslide::numeric::variational {

/// The cells on which the variational solver's traction is constant. Lengths are reduced, xi = (x - origin)/unit, with
/// the support's length as unit: then -log|xi - xi'| >= 0 all over the support.
class CellMesh {
 public:
  /// `cells` >= 1 equal cells on the support, xi from -1/2 to 1/2, whatever lies inside.
  CellMesh(const ContactProblem& problem, std::size_t cells);
  /// Cells of any lengths, to be refined towards the place `origin`: xi of their ends, increasing, the first and the
  /// last one are the support's.
  CellMesh(const ContactProblem& problem, const Rational& origin, std::vector<double> edges);

  const Frame& frame() const { return frame_; }
  bool is_uniform() const { return uniform_; }
  std::size_t size() const { return edges_.size() - 1; }
  /// In xi.
  double left(std::size_t i) const { return edges_[i]; }
  double right(std::size_t i) const { return edges_[i + 1]; }
  double length(std::size_t i) const { return uniform_ ? length_ : edges_[i + 1] - edges_[i]; }
  double centre(std::size_t i) const { return (edges_[i] + edges_[i + 1]) / 2; }
  const std::vector<double>& edges() const { return edges_; }
  /// The cell that contains xi: the right one of two that meet there, the nearest one outside the support.
  std::size_t cell_at(double xi) const;
  /// xi of a place of the problem, rounded once.
  double place(const Rational& x) const { return to_real<double>((x - frame_.origin) / frame_.unit); }

 private:
  Frame frame_;
  std::vector<double> edges_;
  bool uniform_;
  double length_ = 0;
};

/// Edges for a mesh refined towards xi = 0, in proportion to the distance from it: the cells next to 0 have the length
/// `smallest`, each further one is `ratio` > 1 times as long as the one before it until `largest`. To both sides.
std::vector<double> graded_edges(double left, double right, double smallest, double ratio, double largest);

/// Integrals of s over each cell.
struct CellFriction {
  std::vector<double> whole;  ///< int s
  /// Mean over x in the cell of int s from its left end to x, or from x to its right end where s is negative: what a
  /// traction on the cell adds to its own mean displacement. All of int |s| where the equation is asked at the end.
  std::vector<double> own;
  /// +1: s >= 0, and the displacement counts from the left end of the support. -1: s <= 0 somewhere, and it counts from
  /// the right end: no friction then lowers the surface, and the indenter's approach takes up the difference.
  int sign = 1;
  /// Cells whose equation is asked at their right end, with sign < 0 at their left one; empty: none.
  std::vector<char> at_end = {};

  bool is_at_end(std::size_t i) const { return !at_end.empty() && at_end[i]; }
};
CellFriction cell_friction(const ContactProblem& problem, const CellMesh& mesh,
                           FrictionRule rule = FrictionRule::galerkin);

/// psi(x) less its value at the middle of the support: only differences matter, and these are small near the contact.
Rational profile_above_middle(const ContactProblem& problem, const Rational& x);

/// profile_above_middle/(c P) in xi of uniform meshes, ready for means over cells.
class CellProfile {
 public:
  CellProfile(const ContactProblem& problem, const Frame& frame);
  /// Means over each cell of a mesh with the frame given.
  std::vector<double> means(const CellMesh& mesh) const;
  /// At a place; where two pieces meet, on that side.
  double operator()(double xi, Side side) const;
  /// Where two pieces meet.
  const std::vector<double>& breaks() const { return ends_; }

 private:
  /// A piece about a point of its own: nothing cancels far from the origin of x.
  struct LocalPiece {
    double origin;
    std::vector<double> coefficients;

    double operator()(double xi) const;
    double integral(double left, double right) const;
  };
  static LocalPiece local_piece(const Polynomial& profile, const Rational& middle, const Frame& frame,
                                const Rational& height, const Rational& scale);

  std::vector<LocalPiece> pieces_;
  std::vector<double> ends_;  ///< of all but the last piece
};

}  // namespace steadyslide::numeric::variational
