#pragma once
// The stresses that distant periods add to those of one contact. With the potentials C and C_t of half_plane_stress.hpp,
// made of (pi/L) cot(pi (x'-zeta)/L) in place of 1/(x'-zeta), stresses repeat with the period L. The terms of the period
// of zeta and of its two neighbours, 1/(x'-zeta) and 1/(x'-zeta+-L), are left out here. The rest is smooth: its nearest
// pole is two periods away.
//
// u_x and u_z repeat, too. So sigma_xx contains the constant 2 gamma P/L, which makes the mean of d u_x/dx 0, and the
// rotation contains the mean of the friction term, as the surface does [docs/theory.md].

#include <array>
#include <vector>

#include "model/contact_problem.hpp"
#include "numeric/layers/surface_forces.hpp"
#include "numeric/number/estimate.hpp"

namespace steadyslide::numeric {

class PeriodicImages {
 public:
  /// sigma_xx, sigma_zz, sigma_xz and W = (d u_z/dx - d u_x/dz)/(2 c).
  using Stress = std::array<Estimate<double>, 4>;

  /// Returns the length of parts that is short enough for the forces.
  static double longest_part(const Body& body) { return to_real<double>(*body.period()) / 4; }
  /// The body of the problem has a period. The tractions are those of nested meshes.
  PeriodicImages(const ContactProblem& problem, std::vector<SurfaceForces> tractions);

  const Rational& period() const { return exact_period_; }
  /// Returns the number of periods by which x lies to the right of the period around the contact's middle.
  double periods_away(double x) const;
  /// Returns the stresses of a traction at a place in that period.
  Stress at(std::size_t traction, double x, double z) const;

 private:
  Rational exact_period_;
  double period_;
  double gamma_;
  std::vector<SurfaceForces> tractions_;
};

}  // namespace steadyslide::numeric
