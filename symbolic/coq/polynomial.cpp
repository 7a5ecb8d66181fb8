#include "symbolic/coq/polynomial.hpp"

#include <algorithm>

namespace steadyslide::symbolic {

Polynomial Polynomial::generator(std::size_t k, int power) {
  Polynomial result;
  Powers powers(power == 0 ? 0 : k + 1, 0);
  if (power != 0) powers[k] = power;
  result.add(powers, 1);
  return result;
}

void Polynomial::add(const Powers& powers, const Rational& coefficient) {
  if (coefficient == 0) return;
  const auto [place, is_new] = terms_.emplace(powers, coefficient);
  if (is_new) return;
  place->second += coefficient;
  if (place->second == 0) terms_.erase(place);
}

int Polynomial::degree(std::size_t generator) const {
  int degree = 0;
  for (const auto& [powers, c] : terms_) {
    if (generator < powers.size()) degree = std::max(degree, powers[generator]);
  }
  return degree;
}

Polynomial Polynomial::coefficient(std::size_t generator, int power) const {
  Polynomial result;
  for (const auto& [powers, c] : terms_) {
    if ((generator < powers.size() ? powers[generator] : 0) != power) continue;
    Powers rest = powers;
    if (generator < rest.size()) rest[generator] = 0;
    while (!rest.empty() && rest.back() == 0) rest.pop_back();
    result.add(rest, c);
  }
  return result;
}

Polynomial& Polynomial::operator+=(const Polynomial& other) {
  for (const auto& [powers, c] : other.terms_) add(powers, c);
  return *this;
}

Polynomial Polynomial::operator-() const {
  Polynomial result = *this;
  for (auto& [powers, c] : result.terms_) c = -c;
  return result;
}

Polynomial operator*(const Polynomial& a, const Polynomial& b) {
  Polynomial result;
  for (const auto& [p, c] : a.terms_) {
    for (const auto& [q, d] : b.terms_) {
      Polynomial::Powers sum = p.size() < q.size() ? q : p;
      const Polynomial::Powers& shorter = p.size() < q.size() ? p : q;
      for (std::size_t k = 0; k < shorter.size(); ++k) sum[k] += shorter[k];
      result.add(sum, c * d);
    }
  }
  return result;
}

Polynomial Polynomial::to_the(int power) const {
  Polynomial result(1);
  for (int k = 0; k < power; ++k) result = result * *this;
  return result;
}

std::string Polynomial::text(const std::vector<std::string>& names) const {
  std::string text;
  for (const auto& [powers, c] : terms_) {
    const bool minus = c < 0 && !text.empty();
    const Rational number = minus ? -c : c;
    std::string factors = number == 1 ? "" : coq_number(number);
    for (std::size_t k = 0; k < powers.size(); ++k) {
      if (powers[k] == 0) continue;
      factors += (factors.empty() ? "" : " * ") + names.at(k) + (powers[k] == 1 ? "" : "^" + std::to_string(powers[k]));
    }
    text += (text.empty() ? "" : minus ? " - " : " + ") + (factors.empty() ? "[1]" : factors);
  }
  return text.empty() ? "[0]" : text;
}

std::string coq_number(const Rational& value) {
  const Integer below = boost::multiprecision::denominator(value);
  return "[" + Integer(boost::multiprecision::numerator(value)).str() + (below == 1 ? "" : "#" + below.str()) + "]";
}

}  // namespace steadyslide::symbolic
