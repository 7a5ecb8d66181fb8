#pragma once
// A polynomial in x with exact coefficients: a piece of an indenter's profile.

#include <vector>

#include "model/rational.hpp"

namespace steadyslide {

class Polynomial {
 public:
  Polynomial() = default;
  /// Takes the coefficients of 1, x, x^2, ...; leading zeros are dropped.
  explicit Polynomial(std::vector<Rational> coefficients);
  static Polynomial constant(const Rational& value) { return Polynomial({value}); }

  /// Returns the degree; -1 for the zero polynomial.
  int degree() const { return static_cast<int>(coefficients_.size()) - 1; }
  const std::vector<Rational>& coefficients() const { return coefficients_; }
  /// Returns the coefficient of x^k; zero beyond the degree.
  Rational coefficient(std::size_t k) const { return k < coefficients_.size() ? coefficients_[k] : Rational(0); }

  Rational operator()(const Rational& x) const;
  Polynomial derivative() const;
  /// Returns p(a x + b).
  Polynomial composed(const Rational& a, const Rational& b) const;

  friend Polynomial operator+(const Polynomial& a, const Polynomial& b);
  friend Polynomial operator-(const Polynomial& a, const Polynomial& b);
  friend Polynomial operator*(const Polynomial& a, const Polynomial& b);
  friend bool operator==(const Polynomial&, const Polynomial&) = default;

 private:
  std::vector<Rational> coefficients_;
};

/// Returns text such as "1/2*x^2 - x", which the reader of problem files accepts.
std::string to_string(const Polynomial& polynomial);

}  // namespace steadyslide
