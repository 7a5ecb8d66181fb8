#pragma once
// How large T(c), the force left of a place c, can be for its energy: sup T(c)^2/E over tractions of zero mean on
// cells, E = -(1/pi) <t * log|x|, t>.
//
// In the continuum there is no bound: E is the square of a norm of H^(1/2) of T = int t, Green's function of that form
// on ]-1, 1[ is (1/pi) log(2 (1-c^2)/|x-c|) next to c, and so the capacity of a point is zero, that of an interval of
// length h about pi/log(1/h). On equal cells of length h, T is piecewise linear; on the whole line the form has the
// symbol Lambda(theta) = sum_m |theta + 2 pi m| sinc^4(theta/2 + pi m), and what cells put in place of the logarithm's
// pole is the integral of |T^|^2/Lambda - 1/theta, |T^|^2 = 1 - 2 phi (1-phi) (1 - cos theta) for c at the part phi of
// its cell.

#include "proofs_checks/instruments/cells/cells.hpp"
#include "proofs_checks/kit/findings.hpp"

namespace steadyslide::proofs_checks {

/// sup (weights.q)^2/(q.form q), over sum q = 0 or over all q.
double largest_point_value(const Eigen::MatrixXd& form, const Eigen::VectorXd& weights, bool zero_mean);

/// sup T(c)^2/E, c a place in the mesh.
double largest_point_value(const CellMesh& mesh, double c);
/// Of the operator's symmetric part on zero mean.
double smallest_eigenvalue(const CellFrictionSteps& steps, const CellMesh& mesh);
/// Has the smallest eigenvalue on these cells the sign that a law foretells?
void check_sign(Findings& findings, double smallest_eigenvalue, bool definite, const std::string& where);

/// On N equal cells of [-1, 1], for N to infinity:
///   (log(N (1-c^2)) + int_0^pi (|T^|^2/Lambda - 1/theta) dtheta + log pi + Euler's constant)/pi.
struct PointValueLaw {
  double slope = 1;        ///< of the logarithm, times pi
  bool constant = true;    ///< counted
  bool cells_form = true;  ///< Lambda of the cells, else theta
  double moved = 0;

  double operator()(double cells, double c) const;
  /// Where it has a value, for c between two cells.
  double cells(double value, double c) const;
  /// What is added to the logarithm, times pi, for c at this part of its cell.
  double rest(double part) const;
};

}  // namespace steadyslide::proofs_checks
