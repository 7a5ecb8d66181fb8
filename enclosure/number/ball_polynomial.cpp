#include "enclosure/number/ball_polynomial.hpp"

#include <algorithm>
#include <cmath>

namespace steadyslide::enclosure {
namespace {

/// From this number of coefficients on, evaluation uses blocks.
constexpr std::size_t many_coefficients = 16;

/// Returns the size of a block, such that as many blocks contain `count` powers.
std::size_t block_of(std::size_t count) {
  return static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(count))));
}

/// Returns the same numbers in one array for Arb. Read only.
std::vector<arb_struct> array_of(const std::vector<Ball>& balls) {
  std::vector<arb_struct> result;
  for (const Ball& ball : balls) result.push_back(*ball.get());
  return result;
}

Ball value_of_many(const BallPolynomial& polynomial, const Ball& x) {
  const std::size_t block = block_of(polynomial.size());
  std::vector<Ball> powers{Ball(1, x.bits())};
  while (powers.size() <= block) powers.push_back(powers.back() * x);
  const std::vector<arb_struct> factors = array_of(powers);
  const std::vector<arb_struct> coefficients = array_of(polynomial);
  Ball value(0, x.bits());
  for (std::size_t first = (polynomial.size() - 1) / block * block;; first -= block) {
    value *= powers.back();
    const std::size_t length = std::min(block, polynomial.size() - first);
    arb_dot(value.get(), value.get(), 0, &coefficients[first], 1, factors.data(), 1, static_cast<slong>(length),
            value.bits());
    if (first == 0) return value;
  }
}

}  // namespace

BallPolynomial in_balls(const Polynomial& polynomial, Bits bits) {
  BallPolynomial result;
  for (const Rational& c : polynomial.coefficients()) result.emplace_back(c, bits);
  return result;
}

Ball value_at(const BallPolynomial& polynomial, const Ball& x) {
  if (polynomial.size() >= many_coefficients) return value_of_many(polynomial, x);
  Ball value(0, x.bits());
  for (std::size_t i = polynomial.size(); i-- > 0;) value = value * x + polynomial[i];
  return value;
}

Ball bound_within(const BallPolynomial& polynomial, const Ball& radius) {
  const Bits bits = radius.bits();
  Ball value(0, bits);
  for (std::size_t i = polynomial.size(); i-- > 0;) value = value * radius + abs(polynomial[i].at(bits));
  return value;
}

void add_moments(std::span<Ball> moments, const std::vector<Ball>& weights, const std::vector<Ball>& points) {
  const std::size_t block = block_of(moments.size());
  // powers[a] = points^a; weighted = weights points^(block b): moment a + block b is their product.
  std::vector<std::vector<Ball>> powers{std::vector<Ball>(points.size(), Ball(1))};
  std::vector<std::vector<arb_struct>> factors{array_of(powers[0])};
  const auto times = [](const std::vector<Ball>& a, const std::vector<Ball>& b) {
    std::vector<Ball> result;
    for (std::size_t i = 0; i < a.size(); ++i) result.push_back(a[i] * b[i]);
    return result;
  };
  for (std::size_t a = 1; a <= block; ++a) {
    powers.push_back(times(powers.back(), points));
    factors.push_back(array_of(powers.back()));
  }
  std::vector<Ball> weighted = weights;
  for (std::size_t first = 0; first < moments.size(); first += block) {
    if (first > 0) weighted = times(weighted, powers[block]);
    const std::vector<arb_struct> terms = array_of(weighted);
    for (std::size_t k = first; k < std::min(first + block, moments.size()); ++k) {
      arb_dot(moments[k].get(), moments[k].get(), 0, terms.data(), 1, factors[k - first].data(), 1,
              static_cast<slong>(terms.size()), moments[k].bits());
    }
  }
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
