#pragma once
// Formulas in the quantities of an instance, as sentences of facts write them:
//
//   -1 < p < 0           p in ]-1, 0[           D >= 0 if at = wedge
//   sin(pi beta) = (s_l - s_r) cos(pi alpha_l) cos(pi alpha_r)
//   int(x, -1, 1, t(x)) = -P
//
// A space between two factors multiplies; a name directly before a bracket is a function. Words between formulas: not,
// and, or, if. Functions: abs, arctan, cos, cosh, cot, digamma, exp, floor, gamma, log, max, min, sgn, sin, sinh, sqrt,
// tan, and those of the instance; int(x, a, b, f) is the integral of f over a < x < b, which may have integrable powers
// at both ends, the stronger one where an end is 0; sum(k, m, n, f) is the sum of f over k = m, ..., n, and
// all(k, m, n, f) says that the statement f holds for all these k.

#include <map>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "model/truth.hpp"
#include "numeric/number/real.hpp"

namespace steadyslide::proofs_checks {

using numeric::Real50;

struct Instance;

class Formula {
 public:
  /// Throws std::logic_error if the text is not a formula.
  explicit Formula(std::string_view text);

  /// Returns the value. Throws std::logic_error if a name has no value in the instance, or if the formula is not a
  /// number.
  Real50 value(const Instance& instance) const;
  /// Decides the formula. Numbers that differ by no more than the accuracy of the instance are equal; if the instance
  /// is not exact, their order is unknown. Throws as value() does.
  Truth holds(const Instance& instance) const;
  /// Returns the names that an instance has to give a value; functions with a bracket: "t(".
  const std::set<std::string>& names() const { return names_; }

  struct Node {
    std::string op;  ///< "number", "name", "call", or a sign
    std::string name = {};
    Real50 number = 0;
    std::vector<Node> parts = {};
  };
  const Node& root() const { return root_; }

 private:
  std::set<std::string> names_;
  Node root_;
};

/// The quantities of one instance of a thing.
struct Instance {
  struct Function {
    std::vector<std::string> parameters;
    Formula body;
  };

  std::map<std::string, Real50> numbers;
  std::shared_ptr<const std::map<std::string, Function>> functions = {};  ///< null if there is none
  Real50 accuracy = 0;  ///< of a number x, over 1 + |x|; 0 if the numbers are exact, up to the rounding of 50 digits
};

std::string text_of(const Instance& instance);

}  // namespace steadyslide::proofs_checks
