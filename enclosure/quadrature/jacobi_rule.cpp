#include "enclosure/quadrature/jacobi_rule.hpp"

#include <arb_hypgeom.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "enclosure/quadrature/jacobi_polynomial.hpp"
#include "enclosure/quadrature/jacobi_starts.hpp"

namespace steadyslide::enclosure {
namespace {

Ball digamma(const Ball& x) {
  Ball result(0, x.bits());
  arb_digamma(result.get(), x.get(), x.bits());
  return result;
}

/// int (1+x)^left (1-x)^right dx = 2^(left+right+1) B(left+1, right+1).
Ball mass_of(const Ball& left, const Ball& right) {
  const Ball sum = left + right;
  return power(Ball(2, sum.bits()), sum + 1) * gamma(left + 1) * gamma(right + 1) / gamma(sum + 2);
}

Ball rounded(const Ball& x, Bits bits) {
  Ball result(0, bits);
  arb_set_round(result.get(), x.get(), bits);
  return result;
}

bool centred_at_zero(const Ball& x) { return arf_is_zero(arb_midref(x.get())) != 0; }

}  // namespace

JacobiRule::JacobiRule(int count, const Ball& left, const Ball& right, Bits bits)
    : mass(mass_of(left.at(bits + 16), right.at(bits + 16)).at(bits)), spread_(0, bits) {
  if (count < 1 || !(left > -1 && right > -1)) throw std::invalid_argument("Gauss-Jacobi rule: n >= 1, powers > -1");
  const Ball dl = left.radius(), dr = right.radius();
  if (dl.is_positive() || dr.is_positive()) {
    const Ball a = left.at(64) + 1, b = right.at(64) + 1;
    const Ball common = log(Ball(2, 64)) + digamma(a + b);
    spread_ = mass.at(64) * (dl * (common - digamma(a)) + dr * (common - digamma(b)));
  }
  for (std::vector<Ball>* part : {&from_left, &from_right, &weights}) part->reserve(static_cast<std::size_t>(count));
  const Ball l = left.midpoint(), r = right.midpoint();
  if (centred_at_zero(l) && centred_at_zero(r)) {
    make_legendre(count, bits);
    if (is_proved(bits)) return;
  }
  // In the recurrence a ball's radius grows up to 1 + sqrt(2) times a step; nodes next to an end are as small as
  // (power + 1)/n^2. Where this is too little, more is tried.
  const double smallest = std::max(0.0, -std::min(rough_log2(l + 1), rough_log2(r + 1)));
  const double size = count;
  Bits guard = static_cast<Bits>(1.28 * size + 6 * std::log2(size + 1) + 2 * smallest) + 48;
  for (int attempt = 0; attempt < 4; ++attempt, guard *= 2) {
    const Bits working = std::max(bits, static_cast<Bits>(1.28 * size)) + guard;
    if (make(count, l, r, bits, working) && is_proved(bits)) return;
  }
  throw std::runtime_error("Gauss-Jacobi rule: a node was not proved");
}

bool JacobiRule::make(int count, const Ball& left, const Ball& right, Bits bits, Bits working) {
  for (std::vector<Ball>* part : {&from_left, &from_right, &weights}) part->clear();
  const JacobiPolynomial polynomial(count, left, right, working);
  const Ball factor = mass_of(left.at(working), right.at(working)) * polynomial.norm();
  const double a = (left + 1).to_double(), b = (right + 1).to_double();
  const int in_left = (count + 1) / 2;
  const std::vector<double> lefts = jacobi_starts(count, in_left, a, b);
  const std::vector<double> rights = jacobi_starts(count, count - in_left, b, a);
  for (int i = 0; i < count; ++i) {
    const Side side = i < in_left ? Side::left : Side::right;
    const double y =
        side == Side::left ? lefts[static_cast<std::size_t>(i)] : rights[static_cast<std::size_t>(count - 1 - i)];
    const std::optional<JacobiPolynomial::Zero> zero = polynomial.zero_near(2 * y, side);
    if (!zero) return false;
    const Ball other = 2 - zero->distance;
    from_left.push_back(rounded(side == Side::left ? zero->distance : other, bits));
    from_right.push_back(rounded(side == Side::left ? other : zero->distance, bits));
    weights.push_back(rounded(factor / (zero->distance * other * zero->slope * zero->slope), bits));
  }
  return true;
}

void JacobiRule::make_legendre(int count, Bits bits) {
  const auto n = static_cast<std::size_t>(count);
  const Bits working = bits + 2 * static_cast<Bits>(std::log2(count + 1)) + 16;
  from_left.assign(n, Ball(0, bits));
  from_right.assign(n, Ball(0, bits));
  weights.assign(n, Ball(0, bits));
  for (std::size_t k = 0; k < n; ++k) {
    // Arb counts the roots from the right, and makes the left half from the right one.
    Ball x(0, working), weight(0, working);
    arb_hypgeom_legendre_p_ui_root(x.get(), weight.get(), n, k, working);
    const std::size_t i = n - 1 - k;
    from_left[i] = rounded(1 + x, bits);
    from_right[i] = rounded(1 - x, bits);
    weights[i] = rounded(weight, bits);
  }
}

bool JacobiRule::is_proved(Bits bits) const {
  for (std::size_t i = 0; i < weights.size(); ++i) {
    for (const Ball* number : {&from_left[i], &from_right[i], &weights[i]}) {
      if (!number->is_positive() || arb_rel_accuracy_bits(number->get()) < bits - 4) return false;
    }
    // Seen from the nearer end: there the difference of neighbours has its digits.
    if (i > 0 && !(from_left[i - 1] < from_left[i] || from_right[i - 1] > from_right[i])) return false;
  }
  return true;
}

Ball JacobiRule::remainder(const Ball& bound, const Ball& rho) const {
  if (!(rho > 1)) return Ball::unknown(rho.bits());
  const Ball r = rho.at(64), size = abs(bound.at(64)).upper();
  const int n = static_cast<int>(weights.size());
  return (size * (4 * mass.at(64) * power(r, 1 - 2 * n) / (r - 1) + spread_.at(64))).upper();
}

Ball JacobiRule::remainder(const Ball& bound) const { return (abs(bound.at(64)).upper() * spread_.at(64)).upper(); }

}  // namespace steadyslide::enclosure
