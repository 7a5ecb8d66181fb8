#pragma once
// The displacement (u_x, u_z) of the half-plane at (x, z), z >= 0 the depth, u_z into the body, under the traction t of
// a solution and t_t = r t. A force per unit of thickness (N, T) at the origin, N along the outward normal, T along +x,
// gives, if the stresses of half_plane_stress.hpp are integrated with Hooke's law, phi = atan(x/z), d^2 = x^2 + z^2,
//
//   2 pi mu u_x = N (-x z/d^2 + (kappa-1)/2 phi) - T ((kappa+1)/2 log d + z^2/d^2),
//   2 pi mu u_z = N ((kappa+1)/2 log d - z^2/d^2) + T (x z/d^2 + (kappa-1)/2 phi).
//
// A half-plane has no far end to measure from: two constants are free. They are fixed at a point of the surface, the
// origin of the displacement u of contact problems (contact_solution.hpp), where u_x = u_z = 0. So u_z = -u on the
// surface if the indenter is rigid.
//
// The sums over the contact and their errors are those of body_sums.hpp; at the surface panels are graded down to epsilon^2
// of their length. On cells the errors are those that coarser meshes show.

#include "numeric/interior/body_sums.hpp"
#include "numeric/number/estimate.hpp"

namespace steadyslide::numeric {

template <Real R>
struct Displacement {
  Estimate<R> x;
  Estimate<R> z;
};

template <Real R>
class InteriorDisplacement {
 public:
  /// `origin`: the point of the surface where the displacement is 0. Throws std::invalid_argument for reduced data,
  /// which have no elastic constants.
  InteriorDisplacement(PiecewiseTraction<R> traction, const Rational& origin);

  /// Throws std::invalid_argument unless z >= 0.
  Displacement<R> at(const Rational& x, const Rational& z) const;

 private:
  /// Returns u_x and u_z for each mesh, times 2 pi mu.
  std::vector<std::array<Estimate<R>, 2>> unscaled(const Rational& x, const Rational& z) const;

  std::vector<BodySums<R, PotentialKernel<R>>> meshes_;  ///< the finest first
  R half_sum_;                                           ///< (kappa+1)/2
  R half_difference_;                                    ///< (kappa-1)/2
  R scale_;                                              ///< 1/(2 pi mu)
  std::vector<std::array<Estimate<R>, 2>> at_origin_;
};

}  // namespace steadyslide::numeric
