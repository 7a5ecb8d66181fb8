#pragma once
// Second quadrature route, independent of the first: the trapezoidal rule in tau, x = tanh(tau/2) on each panel.
//
//   from_left = length/(1+e^-tau), from_right = length/(1+e^tau), dx = from_left from_right/length dtau
//
// A density becomes a function that decays exponentially at both ends and is analytic for |Im tau| < pi, so the error
// decreases like e^{-2 pi^2/h}. Beyond the cut-off the terms form a geometric series, which is summed exactly, so an
// end power close to -1 has no extra cost. If the pole lies half a step between two nodes, the rule gives the principal
// value. In double the samples of many panels are summed by cells (numeric/hierarchical/), with rounding errors only.
// (Heuristic: the cut-off and the step assume branch points on the real axis and no other singular points.)

#include <memory>

#include "model/direction.hpp"
#include "numeric/number/estimate.hpp"
#include "numeric/quadrature/density.hpp"

namespace steadyslide::numeric::trapezoidal {

/// Samples of a density, taken once and used for any number of integrals.
template <Real R>
class Grid {
 public:
  explicit Grid(PiecewiseDensity<R> density);

  const PiecewiseDensity<R>& density() const { return density_; }

  R panel_integral(std::size_t k) const;
  /// Returns int t.
  R integral() const;
  /// Returns int (x - origin) t.
  R moment(const R& origin) const;

  /// Returns the point halfway (in tau) between two samples of panel k that is nearest to the given fraction of its
  /// length. Principal values there need no new samples.
  PanelPoint<R> midpoint_near(std::size_t k, const R& fraction) const;

  /// Returns H t = (1/pi) PV int t(x')/(x'-x) dx' at a point inside a panel.
  R hilbert(const PanelPoint<R>& at) const;
  /// Returns the same integral at a distance d > 0 to the left of the first panel (Side::left) or to the right of the
  /// last one.
  R cauchy(Side side, const R& distance) const;

  /// Returns -(1/pi) int t(x') log(|x - x'|/|e - x'|) dx', the rise of the surface from the end e of panel k (where
  /// contact ends on that side) to the point x at the distance d > 0 beyond it, within the gap there.
  R displacement(std::size_t k, Side end, const R& distance) const;

 private:
  struct Sample {
    Node<R> node;
    R weighted;  ///< t(x) dx/dtau h
  };
  /// Samples at tau = offset + k h, and the sums of the geometric tails beyond the first and the last one.
  struct Samples {
    std::vector<Sample> inner;
    R left_tail;
    R right_tail;
  };

  /// All samples of adjacent panels, and the gaps between them.
  struct Line;

  Samples sample(std::size_t panel_index, const R& offset) const;
  std::shared_ptr<const Line> line() const;
  /// Returns the contribution of the other panels to hilbert().
  R hilbert_of_others(const PanelPoint<R>& at) const;
  R hilbert_of(std::size_t j, bool to_the_right, const R& between) const;
  /// Returns the contribution of panel j to displacement(). `between` is the distance of its nearer end from e.
  R displacement_of(std::size_t j, bool same_side, Side end, const R& between, const R& distance) const;
  template <class Kernel>
  R sum(const Panel<R>& panel, const Samples& samples, const Kernel& kernel) const;

  PiecewiseDensity<R> density_;
  R step_;
  R shortest_;  ///< length of the shortest panel
  std::vector<Samples> samples_;
  std::shared_ptr<const Line> line_;  ///< null if there are too few panels
};

}  // namespace steadyslide::numeric::trapezoidal
