#pragma once
// The force T(c) left of a point c, compared with the energy: sup T(c)^2/E over tractions of zero mean on cells,
// E = -(1/pi) <t * log|x|, t>.
//
// In the continuum there is no bound. E is the square of an H^(1/2) norm of T = int t. Close to c, Green's function of
// this form on ]-1, 1[ is (1/pi) log(2 (1-c^2)/|x-c|). Therefore the capacity of a point is zero, and that of an
// interval of length h is about pi/log(1/h). On equal cells of length h, T is piecewise linear. On the whole line the
// form then has the symbol Lambda(theta) = sum_m |theta + 2 pi m| sinc^4(theta/2 + pi m). On cells, the integral of
// |T^|^2/Lambda - 1/theta replaces the pole of the logarithm: |T^|^2 = 1 - 2 phi (1-phi) (1 - cos theta), where c lies
// at the part phi of its cell.

#include "proofs_checks/instruments/cells/cells.hpp"
#include "proofs_checks/kit/findings.hpp"

namespace steadyslide::proofs_checks {

/// Returns sup (weights.q)^2/(q.form q), over all q with sum q = 0 or over all q.
double largest_point_value(const Eigen::MatrixXd& form, const Eigen::VectorXd& weights, bool zero_mean);

/// Returns sup T(c)^2/E for a point c in the mesh.
double largest_point_value(const CellMesh& mesh, double c);
/// Returns the smallest eigenvalue of the operator's symmetric part on tractions of zero mean.
double smallest_eigenvalue(const CellFrictionSteps& steps, const CellMesh& mesh);
/// Requires that the smallest eigenvalue on these cells is positive if and only if a law predicts it (`definite`).
void check_sign(Findings& findings, double smallest_eigenvalue, bool definite, const std::string& where);

/// The law for N equal cells of [-1, 1], as N tends to infinity:
///   (log(N (1-c^2)) + int_0^pi (|T^|^2/Lambda - 1/theta) dtheta + log pi + Euler's constant)/pi.
struct PointValueLaw {
  double slope = 1;        ///< factor of the logarithm, times pi
  bool constant = true;    ///< include the constant terms
  bool cells_form = true;  ///< use Lambda of the cells; if false, theta
  double moved = 0;

  double operator()(double cells, double c) const;
  /// Returns the number of cells at which the law has this value, for c between two cells.
  double cells(double value, double c) const;
  /// Returns the constant terms, times pi, for c at this part of its cell.
  double rest(double part) const;
};

}  // namespace steadyslide::proofs_checks
