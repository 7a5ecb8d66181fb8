#pragma once
// Gauss-Jacobi rules for any two exponents > -1, on the unit interval:
//
//   int_0^1 y^a (1-y)^b f(y) dy = sum_i weight_i f(y_i),   exact for polynomials f of degree < 2n.
//
// The eigenvalues of the Jacobi matrix in double [GW69] are the starting values of the nodes; Halley's method refines
// them in R. The method uses only 1 + a and 1 + b, and measures nodes from the nearer end. So distances to both ends
// and weights have full relative precision, for exponents arbitrarily close to -1.

#include <map>
#include <tuple>
#include <vector>

#include "numeric/number/power.hpp"

namespace steadyslide::numeric {

/// A rule on the unit interval: int_0^1 w(y) f(y) dy = sum_i weight_i f(y_i), nearly, for the w of the function that makes it.
template <Real R>
struct UnitRule {
  std::vector<R> from_left;   ///< y_i, increasing
  std::vector<R> from_right;  ///< 1 - y_i
  std::vector<R> weights;

  std::size_t size() const { return weights.size(); }
};

/// Throws std::invalid_argument unless n >= 1 and both powers are > -1, std::runtime_error if a node is not found.
template <Real R>
UnitRule<R> jacobi_rule(const Power<R>& left, const Power<R>& right, int n);

/// A cache of rules: each pair of exponents and number of nodes is computed once. Threads must not share it.
template <Real R>
class JacobiRules {
 public:
  /// Returns the rule. The reference is valid as long as this object exists.
  const UnitRule<R>& get(const Power<R>& left, const Power<R>& right, int n);

 private:
  /// 1 + a, 1 + b, n.
  using Key = std::tuple<R, R, int>;
  std::map<Key, UnitRule<R>> rules_;
};

}  // namespace steadyslide::numeric
