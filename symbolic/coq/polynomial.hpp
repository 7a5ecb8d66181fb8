#pragma once
// Polynomials with rational coefficients in generators numbered 0, 1, 2, ...: sparse, expanded, exact. Equal
// polynomials have equal terms in the same order, in every run. They do not use GiNaC and so check its arithmetic
// independently.

#include <map>
#include <string>
#include <vector>

#include "model/rational.hpp"

namespace steadyslide::symbolic {

class Polynomial {
 public:
  /// The powers of the generators, without trailing zeros.
  using Powers = std::vector<int>;
  using Terms = std::map<Powers, Rational>;

  Polynomial() = default;
  explicit Polynomial(const Rational& constant) { add({}, constant); }
  static Polynomial generator(std::size_t k, int power = 1);

  const Terms& terms() const { return terms_; }
  bool is_zero() const { return terms_.empty(); }
  int degree(std::size_t generator) const;
  /// Returns the coefficient of generator^power, which does not contain the generator.
  Polynomial coefficient(std::size_t generator, int power) const;

  Polynomial& operator+=(const Polynomial& other);
  Polynomial operator-() const;
  friend Polynomial operator+(Polynomial a, const Polynomial& b) { return a += b; }
  friend Polynomial operator-(Polynomial a, const Polynomial& b) { return a += -b; }
  friend Polynomial operator*(const Polynomial& a, const Polynomial& b);
  Polynomial to_the(int power) const;

  /// Returns text such as "[1#2] * x^2 * y - [3]" with the names of the generators; "[0]" for zero.
  std::string text(const std::vector<std::string>& names) const;

 private:
  void add(const Powers& powers, const Rational& coefficient);
  Terms terms_;
};

/// Returns a number in the notation of algebra.v: "[3]", "[-1#2]".
std::string coq_number(const Rational& value);

}  // namespace steadyslide::symbolic
