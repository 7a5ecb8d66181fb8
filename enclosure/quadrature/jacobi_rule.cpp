#include "enclosure/quadrature/jacobi_rule.hpp"

#include <arb_hypgeom.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "enclosure/quadrature/jacobi_polynomial.hpp"

namespace steadyslide::enclosure {
namespace {

// The zeros in double are starting values for the proof (jacobi_polynomial.hpp). They need no proof.

/// P_k with P_k(0) = a, computed from differences in which nothing cancels next to y = 0:
///   P_{k+1} - P_k = h_k (P_k - P_{k-1}) - y g_k P_k,   g, h > 0.
class Differences {
 public:
  Differences(int count, double a, double b) {
    const double total = a + b;
    g_.push_back(total / a);
    h_.push_back(0);
    for (int k = 1; k < count; ++k) {
      const double denominator = (a + k) * (total + (k - 1));
      g_.push_back((total + (2 * k - 1)) * (total + 2 * k) / denominator);
      h_.push_back(k * ((b + (k - 1)) / (total + (2 * k - 2))) * (total + 2 * k) / denominator);
    }
    first_ = a;
  }

  /// Returns value and slope.
  std::pair<double, double> at(double y) const {
    double p = first_;
    double slope = 0;
    double change = 0;
    double slope_change = 0;
    for (std::size_t k = 0; k < g_.size(); ++k) {
      slope_change = h_[k] * slope_change - g_[k] * (p + y * slope);
      change = h_[k] * change - y * g_[k] * p;
      p += change;
      slope += slope_change;
    }
    return {p, slope};
  }

 private:
  double first_;
  std::vector<double> g_;
  std::vector<double> h_;
};

/// Returns, in increasing order, the first `wanted` of the `count` zeros of the orthogonal polynomial for y^(a-1)
/// (1-y)^(b-1) on [0, 1]. The relative error in the left half is usually about 1e-14.
std::vector<double> jacobi_starts(int count, int wanted, double a, double b) {
  const Differences differences(count, a, b);
  const double total = a + b;
  const double eigenvalue = count * (total + (count - 1));
  std::vector<double> zeros;
  // Newton's step from y = 0 does not go beyond the first zero.
  double y = a / eigenvalue;
  while (static_cast<int>(zeros.size()) < wanted) {
    // Laguerre's method for the polynomial divided by the known zeros. All zeros are real, so steps from the left
    // converge to the first one. The convergence is cubic.
    for (int step = 0; step < 60; ++step) {
      const auto [p, slope] = differences.at(y);
      if (p == 0) break;
      const double newton = slope / p;
      const double second = -((a - total * y) * newton + eigenvalue) / (y * (1 - y));
      double g = newton;
      double h = newton * newton - second;
      for (const double zero : zeros) {
        const double inverse = 1 / (y - zero);
        g -= inverse;
        h -= inverse * inverse;
      }
      const double left = count - static_cast<double>(zeros.size());
      const double root = std::sqrt(std::max(0.0, (left - 1) * (left * h - g * g)));
      const double change = -left / (g < 0 ? g - root : g + root);
      if (!std::isfinite(change)) break;
      y += change;
      if (std::abs(change) <= 1e-5 * (zeros.empty() ? y : std::min(y, y - zeros.back()))) break;
    }
    const double gap = zeros.empty() ? y : y - zeros.back();
    zeros.push_back(y);
    // Distances grow towards the middle. Only the first zero may be tiny; the next one is beyond the first zero of P',
    // which is also a Jacobi polynomial.
    y += gap / 1024;
    if (zeros.size() == 1 && count > 1) y = std::max(y, (a + 1) / ((count - 1) * (total + count)));
  }
  return zeros;
}

Ball digamma(const Ball& x) { return made_by(arb_digamma, x.bits(), x.get(), x.bits()); }

/// Returns int (1+x)^left (1-x)^right dx = 2^(left+right+1) B(left+1, right+1).
Ball mass_of(const Ball& left, const Ball& right) {
  const Ball sum = left + right;
  return power(Ball(2, sum.bits()), sum + 1) * gamma(left + 1) * gamma(right + 1) / gamma(sum + 2);
}

Ball rounded(const Ball& x, Bits bits) { return made_by(arb_set_round, bits, x.get(), bits); }

bool centred_at_zero(const Ball& x) { return arf_is_zero(arb_midref(x.get())) != 0; }

/// Compares balls as objects, not the numbers in them.
int order(const Ball& a, const Ball& b) {
  const int midpoints = arf_cmp(arb_midref(a.get()), arb_midref(b.get()));
  return midpoints != 0 ? midpoints : mag_cmp(arb_radref(a.get()), arb_radref(b.get()));
}

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
  const Ball l = left.midpoint(), r = right.midpoint();
  if (centred_at_zero(l) && centred_at_zero(r)) {
    make_legendre(count, bits);
    if (is_proved(bits)) return;
  }
  // In each step of the recurrence a ball's radius grows by a factor of up to 1 + sqrt(2). Nodes next to an end are as
  // small as (power + 1)/n^2. If this precision is too small, a higher one is tried.
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
  // A node is measured from the nearer end. A single node is at a/(a + b) of the interval.
  const int in_left = count == 1 && a > b ? 0 : (count + 1) / 2;
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
  // Arb numbers the roots from the right, and computes the left half from the right half.
  for (std::size_t k = n; k-- > 0;) {
    Ball x(0, working), weight(0, working);
    arb_hypgeom_legendre_p_ui_root(x.get(), weight.get(), n, k, working);
    from_left.push_back(rounded(1 + x, bits));
    from_right.push_back(rounded(1 - x, bits));
    weights.push_back(rounded(weight, bits));
  }
}

bool JacobiRule::is_proved(Bits bits) const {
  for (std::size_t i = 0; i < weights.size(); ++i) {
    for (const Ball* number : {&from_left[i], &from_right[i], &weights[i]}) {
      if (!number->is_positive() || arb_rel_accuracy_bits(number->get()) < bits - 4) return false;
    }
    // Measure from the nearer end, where the difference of neighbours has full precision.
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

bool JacobiRules::Before::operator()(const Key& a, const Key& b) const {
  if (a.count != b.count) return a.count < b.count;
  const int lefts = order(a.left, b.left);
  return lefts != 0 ? lefts < 0 : order(a.right, b.right) < 0;
}

const JacobiRule& JacobiRules::operator()(int count, const Ball& left, const Ball& right) {
  const Key key{count, left, right};
  const std::lock_guard lock(in_use_);
  auto place = rules_.find(key);
  if (place == rules_.end()) place = rules_.emplace(key, JacobiRule(count, left, right, bits_)).first;
  return place->second;
}

}  // namespace steadyslide::enclosure
