#include "model/polynomial.hpp"

#include <algorithm>

namespace steadyslide {

Polynomial::Polynomial(std::vector<Rational> coefficients) : coefficients_(std::move(coefficients)) {
  while (!coefficients_.empty() && coefficients_.back() == 0) coefficients_.pop_back();
}

Rational Polynomial::operator()(const Rational& x) const {
  Rational value = 0;
  for (auto c = coefficients_.rbegin(); c != coefficients_.rend(); ++c) value = value * x + *c;
  return value;
}

Polynomial Polynomial::derivative() const {
  std::vector<Rational> result;
  for (std::size_t k = 1; k < coefficients_.size(); ++k) result.push_back(coefficients_[k] * static_cast<unsigned>(k));
  return Polynomial(std::move(result));
}

Polynomial Polynomial::composed(const Rational& a, const Rational& b) const {
  const Polynomial line({b, a});
  Polynomial result;
  for (auto c = coefficients_.rbegin(); c != coefficients_.rend(); ++c) result = result * line + constant(*c);
  return result;
}

Polynomial operator+(const Polynomial& a, const Polynomial& b) {
  std::vector<Rational> sum(std::max(a.coefficients_.size(), b.coefficients_.size()));
  for (std::size_t k = 0; k < sum.size(); ++k) sum[k] = a.coefficient(k) + b.coefficient(k);
  return Polynomial(std::move(sum));
}

Polynomial operator-(const Polynomial& a, const Polynomial& b) { return a + Polynomial::constant(-1) * b; }

Polynomial operator*(const Polynomial& a, const Polynomial& b) {
  if (a.coefficients_.empty() || b.coefficients_.empty()) return {};
  std::vector<Rational> product(a.coefficients_.size() + b.coefficients_.size() - 1);
  for (std::size_t i = 0; i < a.coefficients_.size(); ++i) {
    for (std::size_t j = 0; j < b.coefficients_.size(); ++j) product[i + j] += a.coefficients_[i] * b.coefficients_[j];
  }
  return Polynomial(std::move(product));
}

std::string to_string(const Polynomial& polynomial) {
  std::string text;
  for (int k = polynomial.degree(); k >= 0; --k) {
    const Rational c = polynomial.coefficient(static_cast<std::size_t>(k));
    if (c == 0) continue;
    const Rational size = abs(c);
    if (text.empty()) {
      if (c < 0) text = "-";
    } else {
      text += c < 0 ? " - " : " + ";
    }
    const std::string power = k == 0 ? "" : k == 1 ? "x" : "x^" + std::to_string(k);
    if (power.empty() || size != 1) text += to_string(size) + (power.empty() ? "" : "*");
    text += power;
  }
  return text.empty() ? "0" : text;
}

}  // namespace steadyslide
