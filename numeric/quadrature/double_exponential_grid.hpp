#pragma once
// A traction sampled for any number of integrals in high precision: on each panel, with y = from_left/length,
//
//   y = 1/(1 + e^{-2u}), 1 - y = 1/(1 + e^{2u}), u = (pi/2) sinh tau, dy = pi cosh(tau) y (1-y) dtau [TM74],
//
// and the trapezoidal rule in tau: a tenth of the nodes of trapezoidal.hpp, whose tau goes without the sinh. A whole number
// of steps doubles e^tau, so that e^u is squared, and powers at a panel's ends are exponentials over one octave and else
// squares and roots; where the rest of t is constant they are all there is to a node. With the nodes staggered half a step
// off the pole the rule gives the principal value; 1/(y' - y) on the pole's own panel depends on the step and the place
// alone, and is made once for both. Sums on that panel are exact, of integers with the digits of the largest sample.
//
// Error. A singular point at |Im tau| = b leaves e^{-2 pi b/h} of a step h; sinh tau is known there up to 2i:
//
//   a real point d lengths beyond an end:  sinh tau = s + i,   s = log(1 + 1/d)/pi,    sin b = 1/c, c - 1/c = s
//   the pole at y, the next time:          sinh tau = s + 2i,  s = log(y/(1 - y))/pi,  sin b = 2/c,
//                                                              (c^2 - 1)(c^2 - 4) = s^2 c^2
//
// and h follows from the nearest one. Between panels that touch, a point at which a principal value is taken on one of
// them lies beyond the end of the other. The parts cut off at the ends are under e^-28 of the accuracy, 10^-4 of the
// last digit that is served. (Heuristic: branch points on the real axis and nothing else.)

#include "numeric/cauchy/density.hpp"
#include "numeric/number/estimate.hpp"

namespace steadyslide::numeric::double_exponential {

/// Principal values are taken no nearer to an end than this part of a panel: to one that touches another panel, and to
/// one that does not.
inline constexpr double nearest_beside_a_panel = 0.25;
inline constexpr double nearest_place = 0.1875;

template <Real R>
class Grid {
 public:
  /// Not where a panel is millions of times as long as its neighbour, or an end power next to -1: steps become so small
  /// there that trapezoidal.hpp is cheaper.
  static bool suits(const PiecewiseDensity<R>& density);
  explicit Grid(PiecewiseDensity<R> density);

  /// Its error is that of rounding.
  const Estimate<R>& panel_integral(std::size_t k) const { return panels_[k].integral; }
  /// int t.
  R integral() const;
  /// The largest t at a node, from 1e-6 of a panel's length from one end to 1e-6 from the other.
  R highest() const;

  /// Does a panel lie beside panel k, without a gap, on that side?
  bool touches(std::size_t k, Side side) const;
  /// Halfway (in tau) between two samples of a panel.
  struct Midpoint : PanelPoint<R> {
    int cell;  ///< between samples `cell` and `cell` + 1, number 0 at tau = 0
  };
  /// That of panel k next to the given fraction of its length.
  Midpoint midpoint_near(std::size_t k, double fraction) const;
  /// H t = (1/pi) PV int t(x')/(x'-x) dx' at such a point.
  R hilbert(const Midpoint& midpoint) const;
  /// trapezoidal::Grid's displacement() in double, with an estimate of its error: enough to see that a gap is open.
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
    std::vector<R> weighted;        ///< times the factor: t(x) dx/dtau h
    int shift;                      ///< of the integers
    std::vector<Integer> integers;  ///< 2^shift times `weighted`, all digits of the largest
    std::vector<Distances> nodes;   ///< for points of other panels; empty where there are none
    std::vector<RoughSample> rough;
    Estimate<R> integral;
    R highest;
  };

  static PanelSamples sampled(const PanelDensity<R>& density, int per_octave, bool alone);

  PiecewiseDensity<R> density_;
  std::vector<PanelSamples> panels_;
};

}  // namespace steadyslide::numeric::double_exponential
