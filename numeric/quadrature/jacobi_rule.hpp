#pragma once
// Gauss-Jacobi rules for any two exponents > -1, on the unit interval:
//
//   int_0^1 y^a (1-y)^b f(y) dy = sum_i weight_i f(y_i),   exact for polynomials f of degree < 2n.
//
// Nodes start from the eigenvalues of the Jacobi matrix in double [GW69] and are polished in R by Halley's method. Only
// 1 + a and 1 + b enter, and nodes are formed from the end that is nearer: distances to both ends and weights have full
// relative precision, however near to -1 the exponents are.

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

/// The former name, which claims still use.
template <Real R>
using JacobiRule = UnitRule<R>;

/// Throws std::invalid_argument unless n >= 1 and both powers are > -1, std::runtime_error if a node is not found.
template <Real R>
UnitRule<R> jacobi_rule(const Power<R>& left, const Power<R>& right, int n);

/// Rules made once per pair of exponents and number of nodes. Not to be shared between threads.
template <Real R>
class JacobiRules {
 public:
  /// Stays valid as long as this object.
  const UnitRule<R>& get(const Power<R>& left, const Power<R>& right, int n);

 private:
  /// 1 + a, 1 + b, n.
  using Key = std::tuple<R, R, int>;
  std::map<Key, UnitRule<R>> rules_;
};

}  // namespace steadyslide::numeric
