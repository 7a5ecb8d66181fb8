#include "enclosure/number/ball_polynomial.hpp"

namespace steadyslide::enclosure {

BallPolynomial in_balls(const Polynomial& polynomial, Bits bits) {
  BallPolynomial result;
  for (const Rational& c : polynomial.coefficients()) result.emplace_back(c, bits);
  return result;
}

Ball value_at(const BallPolynomial& polynomial, const Ball& x) {
  Ball value(0, x.bits());
  for (std::size_t i = polynomial.size(); i-- > 0;) value = value * x + polynomial[i];
  return value;
}

Ball integral_over(BallPolynomial polynomial, const Ball& x, const Ball& length) {
  Ball sum(0, x.bits());
  Ball power = length;
  for (int i = 1; !polynomial.empty(); ++i) {
    sum += value_at(polynomial, x) * power;
    power *= length / Ball(i + 1);
    for (std::size_t k = 1; k < polynomial.size(); ++k) polynomial[k - 1] = polynomial[k] * Ball(static_cast<int>(k));
    polynomial.pop_back();
  }
  return sum;
}

BallPolynomial product(const BallPolynomial& a, const BallPolynomial& b) {
  if (a.empty() || b.empty()) return {};
  BallPolynomial result(a.size() + b.size() - 1, Ball(0));
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < b.size(); ++j) result[i + j] += a[i] * b[j];
  }
  return result;
}

BallPolynomial shifted(BallPolynomial polynomial, const Ball& c) {
  for (std::size_t low = 0; low < polynomial.size(); ++low) {
    for (std::size_t i = polynomial.size() - 1; i-- > low;) polynomial[i] += polynomial[i + 1] * c;
  }
  return polynomial;
}

BallPolynomial quotient(const BallPolynomial& polynomial, const Ball& e) {
  BallPolynomial result(polynomial.empty() ? 0 : polynomial.size() - 1, Ball(0, e.bits()));
  Ball carry(0, e.bits());
  for (std::size_t k = polynomial.size(); k-- > 1;) {
    carry = carry * e + polynomial[k];
    result[k - 1] = carry;
  }
  return result;
}

}  // namespace steadyslide::enclosure
