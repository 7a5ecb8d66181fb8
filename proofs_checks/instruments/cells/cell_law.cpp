#include "proofs_checks/instruments/cells/cell_law.hpp"

#include <boost/math/constants/constants.hpp>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/special_functions/polygamma.hpp>
#include <cmath>
#include <numbers>

#include "proofs_checks/instruments/cells/dense_algebra.hpp"

namespace steadyslide::proofs_checks {
namespace {

using std::numbers::pi;

/// Returns the symbol Lambda: 16 sin^4(theta/2) sum_m 1/|theta + 2 pi m|^3. Polygamma functions give the sum.
double symbol(double angle) {
  const double part = angle / (2 * pi);
  const double sum = -(boost::math::polygamma(2, part) + boost::math::polygamma(2, 1 - part)) / 2;
  return 16 * std::pow(std::sin(angle / 2), 4) * sum / std::pow(2 * pi, 3);
}

double cells_integral(double part, bool cells_form) {
  const auto density = [&](double angle) {
    const double t = 1 - 2 * part * (1 - part) * (1 - std::cos(angle));
    return (cells_form ? t / symbol(angle) : t / angle) - 1 / angle;
  };
  // Near 0 the density falls like theta, and its formula subtracts large numbers of almost equal size.
  constexpr double from = 1e-4;
  return boost::math::quadrature::gauss<double, 30>::integrate(density, from, pi) + from * density(from) / 2;
}

}  // namespace

double largest_point_value(const Eigen::MatrixXd& form, const Eigen::VectorXd& weights, bool zero_mean) {
  Eigen::MatrixXd right = Eigen::MatrixXd::Ones(weights.size(), 2);
  right.col(0) = weights;
  const Eigen::MatrixXd solved = definite_solution(form, right);
  const double value = weights.dot(solved.col(0));
  const double mean = solved.col(0).sum();
  return zero_mean ? value - mean * mean / solved.col(1).sum() : value;
}

double largest_point_value(const CellMesh& mesh, double c) {
  return largest_point_value(symmetric_part(mesh, operator_of({{0, 0}, {0}}, mesh), false), weights_of(mesh, c), true);
}

double smallest_eigenvalue(const CellFrictionSteps& steps, const CellMesh& mesh) {
  return eigenvalues(on_zero_mean(symmetric_part(mesh, operator_of(steps, mesh), true)))(0);
}

void check_sign(Findings& findings, double smallest_eigenvalue, bool definite, const std::string& where) {
  findings.require((smallest_eigenvalue > 0) == definite, where + "the smallest eigenvalue, " +
                                                              short_text(smallest_eigenvalue) +
                                                              ", has the other sign than the law foretells");
  findings.compare(
      {"sign of the smallest eigenvalue", {"eigenvalues of the matrix of entries", "the law for `sup(T(c)^2/E)`"}, 0.5},
      0);
}

double PointValueLaw::rest(double part) const {
  return constant ? cells_integral(part, cells_form) + std::log(pi) + boost::math::constants::euler<double>() : 0;
}

double PointValueLaw::operator()(double cells, double c) const {
  const double place = (c + 1) / 2 * cells;
  return (slope * std::log(cells * (1 - c * c)) + rest(place - std::floor(place))) / pi + moved;
}

double PointValueLaw::cells(double value, double c) const {
  return std::exp((pi * (value - moved) - rest(0)) / slope) / (1 - c * c);
}

}  // namespace steadyslide::proofs_checks
