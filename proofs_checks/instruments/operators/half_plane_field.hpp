#pragma once
// The stress field in the half-plane z > 0 under tractions that are polynomials on intervals of the surface, for the
// claims about surface displacements. The integrals of the potentials are exact. On [a, b], with
// L = log((b-zeta)/(a-zeta)),
//
//   C(zeta) = (1/pi) int_a^b t/(x'-zeta) dx' = (t(zeta) L + Q(zeta))/pi,   Q = int_a^b (t(x')-t(zeta))/(x'-zeta) dx',
//
// where Q is a polynomial and zeta = x + iz. The arguments of the logarithm are in [0, pi]; at the surface this is the
// limit from inside the body. Stresses are those of half_plane_stress.hpp, strains follow from Hooke's law in plane
// strain.

#include <vector>

#include "model/elasticity.hpp"
#include "model/polynomial.hpp"
#include "numeric/interior/half_plane_stress.hpp"
#include "proofs_checks/instruments/operators/complex_jet.hpp"
#include "proofs_checks/kit/numbers.hpp"

namespace steadyslide::proofs_checks {

/// A polynomial on an interval.
struct TractionPiece {
  Rational from;
  Rational to;
  Polynomial t;
};
/// Pieces from left to right, without gaps between them. The traction is zero elsewhere.
using PiecewiseTraction = std::vector<TractionPiece>;

template <class R>
PiecewiseDensity<R> density_of(const PiecewiseTraction& traction);

template <class R>
class HalfPlaneField {
 public:
  /// Takes the tractions t_n and t_t on the surface of a body.
  HalfPlaneField(const Solid& body, const PiecewiseTraction& normal, const PiecewiseTraction& tangential);

  /// Returns the stresses for z >= 0. On the surface, x must lie inside an interval or outside all of them.
  numeric::StressComponents<R> stress(const R& x, const R& z) const;
  /// Returns the derivatives of the stresses with respect to x.
  numeric::StressComponents<R> stress_rate(const R& x, const R& z) const;
  /// Returns the sum of the radial fields of all forces t dx', by a Gauss rule. z > 0 must not be small.
  numeric::StressComponents<R> superposed_stress(const R& x, const R& z) const;

  /// Returns u_t' = epsilon_xx on the surface, at x inside an interval.
  R tangential_slope(const R& x) const;
  /// Returns u_n' = -d u_z/dx = int_0^oo d epsilon_zz/dx dz. This uses only the strains, and a rotation that vanishes
  /// at great depth.
  R normal_slope(const R& x) const;

 private:
  struct Piece {
    R from;
    R to;
    std::vector<R> t;       ///< coefficients of the traction
    std::vector<R> q;       ///< coefficients of Q
    std::vector<R> places;  ///< nodes of Gauss' rule
    std::vector<R> forces;
  };
  static std::vector<Piece> pieces_of(const PiecewiseTraction& traction);
  static Jet<R> jet(const std::vector<Piece>& pieces, const numeric::Complex<R>& zeta);
  R strain_xx(const numeric::StressComponents<R>& stress) const;

  Solid body_;
  std::vector<Piece> normal_;
  std::vector<Piece> tangential_;
};

}  // namespace steadyslide::proofs_checks
