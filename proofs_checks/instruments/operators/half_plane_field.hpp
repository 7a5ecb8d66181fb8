#pragma once
// The field in the half-plane z > 0 of tractions that are polynomials on intervals of the surface, for the claims about
// surface displacements: the potentials have exact integrals. On [a, b], with L = log((b-zeta)/(a-zeta)),
//
//   C(zeta) = (1/pi) int_a^b t/(x'-zeta) dx' = (t(zeta) L + Q(zeta))/pi,   Q = int_a^b (t(x')-t(zeta))/(x'-zeta) dx',
//
// Q a polynomial, zeta = x + iz, the arguments of the logarithm in [0, pi]: on the surface the limit from within the
// body. Stresses as in half_plane_stress.hpp, strains by Hooke's law in plane strain.

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
/// From left to right, without gaps; zero elsewhere.
using PiecewiseTraction = std::vector<TractionPiece>;

template <class R>
PiecewiseDensity<R> density_of(const PiecewiseTraction& traction);

template <class R>
class HalfPlaneField {
 public:
  /// Tractions t_n and t_t on the surface of a body.
  HalfPlaneField(const Solid& body, const PiecewiseTraction& normal, const PiecewiseTraction& tangential);

  /// z >= 0; on the surface inside an interval or outside of all.
  numeric::StressComponents<R> stress(const R& x, const R& z) const;
  /// Derivatives of the stresses with respect to x.
  numeric::StressComponents<R> stress_rate(const R& x, const R& z) const;
  /// The radial fields of all forces t dx', added up by a Gauss rule: z > 0 not small.
  numeric::StressComponents<R> superposed_stress(const R& x, const R& z) const;

  /// u_t' = epsilon_xx on the surface, at x inside an interval.
  R tangential_slope(const R& x) const;
  /// u_n' = -d u_z/dx = int_0^oo d epsilon_zz/dx dz: the strains alone, and a rotation that vanishes deep below.
  R normal_slope(const R& x) const;

 private:
  struct Piece {
    R from;
    R to;
    std::vector<R> t;       ///< coefficients
    std::vector<R> q;       ///< of Q
    std::vector<R> places;  ///< of Gauss' rule
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
