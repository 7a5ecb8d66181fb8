#pragma once
// The form of problem I on polynomials u of degree < n. They are given by their values at n nodes:
//
//   a(v, u) = int_{-1}^1 v L(u) dx,
//   L(u) = (1/(1+s^2)) (s u' - (1/W) (1/pi) PV int W(x') u'(x')/(x'-x) dx'),   W = (1+x)^{1/2+alpha} (1-x)^{1/2-alpha},
//
// [Bal16, (10)]. The nodes are Gauss's for t_0 = (cos(pi alpha)/pi)/W, so that int f t_0 = sum tau_i f(x_i) for f of
// degree < 2n. L(u)/t_0 is a polynomial, so that a(v, u) = sum v_i (force u)_i without error. In the integral,
// (u'(x') - u'(x))/(x'-x) is a polynomial, which Gauss's rule for W integrates; the trapezoidal rule computes
// PV int W/(x'-x). The form b, its matrix on cells and solutions are not used here.

#include <vector>

#include "numeric/quadrature/jacobi_rule.hpp"
#include "proofs_checks/kit/numbers.hpp"

namespace steadyslide::proofs_checks {

/// Formula (10), or a wrong variant of it.
struct InverseVariant {
  int friction = 1;        ///< sign of s, also in alpha
  bool printed = false;    ///< (1+x)^{1/2} in W
  int integral = -1;       ///< sign of the integral
  bool amplitude = false;  ///< 1/sqrt(1+s^2) instead of 1/(1+s^2)

  bool operator==(const InverseVariant&) const = default;
};

template <class R>
class DisplacementOperator {
 public:
  /// Takes n >= 2.
  DisplacementOperator(const Rational& s, int n, const InverseVariant& variant = {});

  std::size_t size() const { return tau_.size(); }
  /// Returns node i as its distances from -1 and from 1.
  const Node<R>& node(std::size_t i) const { return nodes_[i]; }
  /// Returns the weight of t_0 at node i; the weights have the sum 1.
  const R& tau(std::size_t i) const { return tau_[i]; }
  /// Returns force_ij = int v L(u), where u is the polynomial that is 1 at node j and 0 at the others, and v is that of
  /// node i.
  const R& force(std::size_t i, std::size_t j) const { return force_[i * size() + j]; }

  /// Returns the forces (force u)_i.
  std::vector<R> forces(const std::vector<R>& u) const;
  /// Returns sum v_i (force u)_i.
  R form(const std::vector<R>& v, const std::vector<R>& u) const;

 private:
  void place_nodes(const Rational& s, int n);
  std::vector<R> barycentric_weights() const;
  std::vector<R> derivatives(const std::vector<R>& weights) const;

  std::vector<Node<R>> nodes_;
  std::vector<R> tau_;
  std::vector<R> force_;
};

}  // namespace steadyslide::proofs_checks
