#include "checker/rational.hpp"

#include <algorithm>
#include <regex>

#include "checker/failure.hpp"

namespace steadyslide::checker {
namespace {

/// Reads one decimal number, without a fraction bar. Returns false if the text is not a decimal number.
bool read_decimal(const std::string& text, fmpq_t result) {
  static const std::regex form("([-+]?)([0-9]*)\\.?([0-9]*)(?:[eE]([-+]?[0-9]{1,3}))?");
  std::smatch part;
  if (!std::regex_match(text, part, form)) return false;
  const std::string digits = part[2].str() + part[3].str();
  if (digits.empty() || fmpz_set_str(fmpq_numref(result), digits.c_str(), 10) != 0) return false;
  fmpz_one(fmpq_denref(result));
  if (part[1] == "-") fmpq_neg(result, result);
  const slong scale = (part[4].matched ? std::stol(part[4]) : 0) - static_cast<slong>(part[3].length());
  fmpz_t power;
  fmpz_init_set_ui(power, 10);
  fmpz_pow_ui(power, power, static_cast<ulong>(scale < 0 ? -scale : scale));
  scale < 0 ? fmpq_div_fmpz(result, result, power) : fmpq_mul_fmpz(result, result, power);
  fmpz_clear(power);
  return true;
}

}  // namespace

Rational Rational::parse(const std::string& text, const std::string& place) {
  const std::size_t bar = text.find('/');
  Rational numerator, denominator = 1;
  const bool read = text.size() <= 2000 && read_decimal(text.substr(0, bar), numerator.value_) &&
                    (bar == std::string::npos || read_decimal(text.substr(bar + 1), denominator.value_));
  if (!read || denominator.sign() == 0) {
    throw Malformed(place, "not a number", "a number is written like 2, -0.25, 1e-3 or 1/3", text);
  }
  return numerator / denominator;
}

std::string Rational::text() const {
  char* characters = fmpq_get_str(nullptr, 10, value_);
  std::string result = characters;
  flint_free(characters);
  return result;
}

Polynomial trimmed(Polynomial p) {
  while (!p.empty() && p.back().sign() == 0) p.pop_back();
  return p;
}

Polynomial operator+(const Polynomial& a, const Polynomial& b) {
  Polynomial result(std::max(a.size(), b.size()));
  for (std::size_t k = 0; k < a.size(); ++k) result[k] = a[k];
  for (std::size_t k = 0; k < b.size(); ++k) result[k] = result[k] + b[k];
  return trimmed(std::move(result));
}

Polynomial operator*(const Polynomial& a, const Polynomial& b) {
  Polynomial result(a.size() + b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < b.size(); ++j) result[i + j] = result[i + j] + a[i] * b[j];
  }
  return trimmed(std::move(result));
}

Polynomial derivative(const Polynomial& p) {
  Polynomial result;
  for (std::size_t k = 1; k < p.size(); ++k) result.push_back(p[k] * Rational(static_cast<slong>(k)));
  return result;
}

Polynomial composed(const Polynomial& p, const Rational& scale, const Rational& shift) {
  Polynomial result;
  for (std::size_t k = p.size(); k-- > 0;) result = result * Polynomial{shift, scale} + Polynomial{p[k]};
  return result;
}

Rational value(const Polynomial& p, const Rational& x) {
  Rational result;
  for (std::size_t k = p.size(); k-- > 0;) result = result * x + p[k];
  return result;
}

}  // namespace steadyslide::checker
