#pragma once
// Problem I on polynomials of degree < n: find u, in the quotient by the constants, with
//
//   a(v - u, u) + phi(v) - phi(u) >= 0 for all v,   phi(v) = P (max_i w_i - sum_i tau_i w_i),   w = v - psi.
//
// The essential supremum is taken over the nodes, and t_0 has its exact weights tau_i [Bal16, (13), problem I]. phi is
// the largest of finitely many linear functions. Therefore the inequality states: there are forces p_i >= 0 with sum P,
// only at nodes at which w is largest, with a(v, u) = sum_i (P tau_i - p_i) v_i for all v. With the gaps
// g_i = max w - w_i:
//
//   p = P tau - force psi + force g,   p >= 0,   g >= 0,   p_i g_i = 0.
//
// The kernel of `force` consists of the constants on both sides, so that sum p = P automatically. If some g_i are zero,
// the remaining matrix is positive definite. Solved in double by active sets from any start, or by interior points.

#include <Eigen/Core>
#include <functional>
#include <optional>

#include "proofs_checks/instruments/operators/displacement_operator.hpp"

namespace steadyslide::proofs_checks {

/// The formula of problem I, or a wrong variant of it.
struct DisplacementFormula {
  InverseVariant inverse;
  double load = 1;           ///< factor of the load
  double profile = 1;        ///< factor of psi
  bool other_angle = false;  ///< use t_0 of -alpha in phi

  bool operator==(const DisplacementFormula&) const = default;
};

class DisplacementProblem {
 public:
  /// Takes the reduced profile psi(x) on [-1, 1].
  DisplacementProblem(const Rational& s, int n, const std::function<double(double)>& profile, double load,
                      const DisplacementFormula& formula = {});

  struct State {
    Eigen::VectorXd gap;
    Eigen::VectorXd force;  ///< the forces p_i
    int steps = 0;
  };

  std::size_t size() const { return operator_.size(); }
  double x(std::size_t i) const { return operator_.node(i).x; }
  /// Returns the solution from a start; `contact` is 1 at nodes in contact. Returns nothing if the active sets cycle.
  std::optional<State> by_active_sets(std::vector<char> contact) const;
  /// Returns the solution without the use of a contact set (interior_point.hpp), or nothing if the path is lost.
  std::optional<State> by_interior_points() const;

  /// Returns a(v - u, u) + phi(v) - phi(u) for v = psi + w. It is >= 0 for the solution.
  double inequality(const State& state, const Eigen::VectorXd& w) const;
  /// Returns P (max w - sum tau w).
  double phi(const Eigen::VectorXd& w) const;
  /// Returns int t_n T_k = -sum p_i T_k(x_i), k = 0, ..., count.
  std::vector<double> moments(const State& state, std::size_t count) const;

 private:
  State state_of(const std::vector<char>& contact) const;
  DisplacementOperator<double> operator_;
  Eigen::MatrixXd force_;
  Eigen::VectorXd tau_;
  Eigen::VectorXd profile_;
  double load_;
};

}  // namespace steadyslide::proofs_checks
