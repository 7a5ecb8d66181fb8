#pragma once
// Exact data: rational numbers (FLINT's fmpq), and polynomials over them.

#include <flint/fmpq.h>

#include <compare>
#include <string>
#include <vector>

namespace steadyslide::checker {

class Rational {
 public:
  Rational(slong n = 0) {
    fmpq_init(value_);
    fmpq_set_si(value_, n, 1);
  }
  Rational(const Rational& other) {
    fmpq_init(value_);
    fmpq_set(value_, other.value_);
  }
  Rational(Rational&& other) noexcept : Rational() { fmpq_swap(value_, other.value_); }
  Rational& operator=(Rational other) noexcept {
    fmpq_swap(value_, other.value_);
    return *this;
  }
  ~Rational() { fmpq_clear(value_); }

  /// Reads texts such as "2", "-0.25", "1e-3" and "1/3". Errors name `place`.
  static Rational parse(const std::string& text, const std::string& place);
  const fmpq* get() const { return value_; }
  int sign() const { return fmpq_sgn(value_); }
  std::string text() const;

  friend Rational operator+(const Rational& a, const Rational& b) { return made(fmpq_add, a, b); }
  friend Rational operator-(const Rational& a, const Rational& b) { return made(fmpq_sub, a, b); }
  friend Rational operator*(const Rational& a, const Rational& b) { return made(fmpq_mul, a, b); }
  /// b must not be zero.
  friend Rational operator/(const Rational& a, const Rational& b) { return made(fmpq_div, a, b); }
  friend bool operator==(const Rational& a, const Rational& b) { return fmpq_equal(a.value_, b.value_) != 0; }
  friend std::strong_ordering operator<=>(const Rational& a, const Rational& b) {
    return fmpq_cmp(a.value_, b.value_) <=> 0;
  }

 private:
  template <class Operation>
  static Rational made(Operation operation, const Rational& a, const Rational& b) {
    Rational result;
    operation(result.value_, a.value_, b.value_);
    return result;
  }

  fmpq_t value_;
};

/// Coefficients of 1, x, x^2, ...; the last one is not zero, and the zero polynomial has none.
using Polynomial = std::vector<Rational>;

Polynomial trimmed(Polynomial p);
Polynomial operator+(const Polynomial& a, const Polynomial& b);
Polynomial operator*(const Polynomial& a, const Polynomial& b);
inline Polynomial operator-(const Polynomial& a, const Polynomial& b) { return a + b * Polynomial{-1}; }
Polynomial derivative(const Polynomial& p);
/// Returns p(scale x + shift).
Polynomial composed(const Polynomial& p, const Rational& scale, const Rational& shift);
Rational value(const Polynomial& p, const Rational& x);

}  // namespace steadyslide::checker
