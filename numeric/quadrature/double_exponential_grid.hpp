#pragma once
// Samples of a traction for any number of integrals in high precision. On each panel, with y = from_left/length,
//
//   y = 1/(1 + e^{-2u}), 1 - y = 1/(1 + e^{2u}), u = (pi/2) sinh tau, dy = pi cosh(tau) y (1-y) dtau [TM74],
//
// and the trapezoidal rule in tau. It has a tenth of the nodes of trapezoidal.hpp, whose tau does not use the sinh. An
// integer number of steps doubles e^tau and thereby squares e^u. So powers at a panel's ends are exponentials over one
// octave, and squares and roots elsewhere. If the rest of t is constant, a node needs nothing else. If the pole lies
// half a step between two nodes, the rule gives the principal value. 1/(y' - y) on the pole's own panel depends only on
// the step and the place, and is computed once for both. Sums on that panel are exact: they are sums of integers with
// the digits of the largest sample.
//
// Error. A singular point at |Im tau| = b causes the error e^{-2 pi b/h} for a step h. sinh tau is known there up to
// 2i:
//
//   a real point d lengths beyond an end:  sinh tau = s + i,   s = log(1 + 1/d)/pi,    sin b = 1/c, c - 1/c = s
//   the pole at y, next image:          sinh tau = s + 2i,  s = log(y/(1 - y))/pi,  sin b = 2/c,
//                                                              (c^2 - 1)(c^2 - 4) = s^2 c^2
//
// and h follows from the nearest one. For adjacent panels, a point at which a principal value is taken on one of them
// lies beyond the end of the other. The parts cut off at the ends are below e^-28 of the accuracy and 10^-4 of the last
// returned digit. (Heuristic: it assumes branch points on the real axis and no other singular points.)

#include "numeric/number/estimate.hpp"
#include "numeric/quadrature/density.hpp"

namespace steadyslide::numeric::double_exponential {

/// The smallest distance from an end at which principal values are taken, as a fraction of the panel: for an end that
/// touches another panel, and for one that does not.
inline constexpr double nearest_beside_a_panel = 0.25;
inline constexpr double nearest_place = 0.1875;

template <Real R>
class Grid {
 public:
  /// False if a panel is millions of times as long as its neighbour, or if an end power is close to -1. Then the steps
  /// become so small that trapezoidal.hpp is cheaper.
  static bool suits(const PiecewiseDensity<R>& density);
  explicit Grid(PiecewiseDensity<R> density);

  /// Returns int t over panel k. Its error is the rounding error.
  const Estimate<R>& panel_integral(std::size_t k) const { return panels_[k].integral; }
  /// Returns int t.
  R integral() const;
  /// Returns the largest t at the nodes that are at least 1e-6 of the panel's length away from both ends.
  R highest() const;

  /// True if another panel touches panel k on that side, without a gap.
  bool touches(std::size_t k, Side side) const;
  /// A point halfway (in tau) between two samples of a panel.
  struct Midpoint : PanelPoint<R> {
    int cell;  ///< between samples `cell` and `cell` + 1, number 0 at tau = 0
  };
  /// Returns the midpoint of panel k next to the given fraction of its length.
  Midpoint midpoint_near(std::size_t k, double fraction) const;
  /// Returns H t = (1/pi) PV int t(x')/(x'-x) dx' at such a point.
  R hilbert(const Midpoint& midpoint) const;
  /// Returns displacement() of trapezoidal::Grid in double, with an estimate of its error. This is enough to see that a
  /// gap is open.
  Estimate<double> rough_displacement(std::size_t k, Side end, double distance) const;

 private:
  struct Distances {
    R from_left;
    R from_right;
  };
  struct RoughSample {
    double from_left;
    double from_right;
    double weighted;
  };
  struct PanelSamples {
    int per_octave;  ///< log(2)/h
    int first;       ///< the first sample lies at tau = first h
    R factor;
    std::vector<R> weighted;        ///< samples times the factor: t(x) dx/dtau h
    int shift;                      ///< of the integers
    std::vector<Integer> integers;  ///< 2^shift times `weighted`, with all digits of the largest
    std::vector<Distances> nodes;   ///< for points of other panels; empty if there are none
    std::vector<RoughSample> rough;
    Estimate<R> integral;
    R highest;
  };

  static PanelSamples sampled(const PanelDensity<R>& density, int per_octave, bool alone);

  PiecewiseDensity<R> density_;
  std::vector<PanelSamples> panels_;
};

}  // namespace steadyslide::numeric::double_exponential
