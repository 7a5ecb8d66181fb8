#include "enclosure/quadrature/jacobi_polynomial.hpp"

#include <algorithm>
#include <cmath>

namespace steadyslide::enclosure {
namespace {

/// The precision of bounds, which need few digits.
constexpr Bits root_bits = 64;

Ball upper_size(const Ball& x) { return abs(x).at(root_bits).upper(); }

Ball two_to(Bits exponent) { return made_by(arb_mul_2exp_si, root_bits, Ball(1).get(), exponent); }

struct ValueAndSlope {
  Ball value{0};
  Ball slope{0};
};

/// Returns sum_{k <= degree} c_k d^k and its derivative, by Horner's scheme.
ValueAndSlope horner(const std::vector<Ball>& c, std::size_t degree, const Ball& d, Bits bits) {
  ValueAndSlope result;
  arb_struct* const value = result.value.get();
  arb_struct* const slope = result.slope.get();
  for (std::size_t k = degree + 1; k-- > 0;) {
    arb_mul(slope, slope, d.get(), bits);
    arb_add(slope, slope, value, bits);
    arb_mul(value, value, d.get(), bits);
    arb_add(value, value, c[k].get(), bits);
  }
  return {result.value.at(bits), result.slope.at(bits)};
}

/// Returns an unproved root of Taylor's polynomial, by Newton's steps. Each step uses the precision that it can reach
/// and the terms that are significant at this precision.
Ball approximate_root(const std::vector<Ball>& c, double bits_per_term, Bits bits) {
  Ball root = (-c[0] / c[1]).midpoint();
  double known = bits_per_term;
  while (known < static_cast<double>(bits)) {
    known = 2 * known;
    const Bits precision = std::min(bits, static_cast<Bits>(known) + 32);
    const auto degree = std::min(c.size() - 1, static_cast<std::size_t>(known / bits_per_term) + 1);
    const ValueAndSlope at = horner(c, degree, root, precision);
    Ball step(0, precision);
    arb_div(step.get(), at.value.get(), at.slope.get(), precision);
    root = (root.at(bits) - step.midpoint()).midpoint();
  }
  return root;
}

}  // namespace

TaylorRest taylor_rest(const Ball& size, const Ball& t, const Ball& q, int degree) {
  const Ball last = size * power(q, degree), left = 1 - q;
  return {last * q / left, last * t * (degree + 1) / power(left, 2), 2 * size * t * t / power(left, 3)};
}

JacobiPolynomial::JacobiPolynomial(int count, const Ball& left, const Ball& right, Bits bits)
    : count_(count), bits_(bits), left_(left.at(bits)), right_(right.at(bits)), sum_(left_ + right_) {
  const Ball &l = left_, &r = right_, &s = sum_;
  eigenvalue_ = count * (s + (count + 1));
  // Written without zero denominators: s > -2, and s = 0 or s = -1 are allowed.
  centres_.push_back((l - r) / (s + 2));
  products_.emplace_back(0);
  products_.push_back(4 * (l + 1) * (r + 1) / ((s + 2) * (s + 2) * (s + 3)));
  const Ball difference = (l - r) * s;
  for (int k = 1; k < count; ++k) centres_.push_back(difference / ((s + 2 * k) * (s + (2 * k + 2))));
  for (int k = 2; k <= count; ++k) {
    const Ball t = s + 2 * k;
    products_.push_back(4 * k * (l + k) * (r + k) * (s + k) / (t * t * (t + 1) * (t - 1)));
  }
  norm_ = s + (2 * count + 1);
  for (int k = 1; k <= count; ++k) norm_ *= products_[static_cast<std::size_t>(k)];
}

JacobiPolynomial::Pair JacobiPolynomial::at(const Ball& x) const {
  Ball before(0, bits_), p(1, bits_), next(0, bits_), term(0, bits_);
  for (std::size_t k = 0; k < centres_.size(); ++k) {
    arb_sub(next.get(), x.get(), centres_[k].get(), bits_);
    arb_mul(next.get(), next.get(), p.get(), bits_);
    if (k > 0) {
      arb_mul(term.get(), products_[k].get(), before.get(), bits_);
      arb_sub(next.get(), next.get(), term.get(), bits_);
    }
    arb_swap(before.get(), p.get());
    arb_swap(p.get(), next.get());
  }
  return {p, before};
}

std::optional<JacobiPolynomial::Zero> JacobiPolynomial::zero_near(double start, Side side) const {
  if (!(start > 0 && start < 2)) return std::nullopt;
  const Ball from_end = Ball::exactly(start, bits_);
  Ball x = side == Side::left ? from_end : -from_end;
  arb_add_si(x.get(), x.get(), side == Side::left ? -1 : 1, ARF_PREC_EXACT);
  const Ball u = from_end * (2 - from_end);
  const Ball e = left_ - right_ - (sum_ + 2) * x;

  // c_0 and c_1: (1-x^2) P' = n ((r-l)/(2n+s) - x) P + b_n (2n+s+1) P_{n-1} [DLMF 18.9.17].
  const Pair values = at(x);
  const Ball twice = sum_ + 2 * count_;
  std::vector<Ball> c{values.p};
  c.push_back((count_ * ((right_ - left_) / twice - x) * values.p + products_.back() * (twice + 1) * values.before) /
              u);

  // The bounds in the header. The distance of the root is about |c_0/c_1|, and r is up to twice that if x is a root up
  // to rounding. R is large enough for both.
  const Ball c_1 = abs(c[1]).lower();
  if (!c_1.is_positive()) return std::nullopt;
  const Ball t =
      max(2 * max(Ball(2), upper_size(e)) / u.at(root_bits).lower(), sqrt(upper_size(eigenvalue_ / u))).upper();
  const Ball reach = max(4 * upper_size(c[0]) / c_1.at(root_bits), two_to(-bits_)).upper();
  const Ball q = (t * reach).upper();
  if (!(q < Ball(Rational(1) / 1024, root_bits))) return std::nullopt;
  const Ball size = max(upper_size(c[0]), upper_size(c[1]) / t).upper();

  const double bits_per_term = -rough_log2(q) - 1;
  const auto degree = static_cast<std::size_t>(static_cast<double>(bits_) / bits_per_term) + 2;
  for (std::size_t j = 2; j <= degree; ++j) {
    const int k = static_cast<int>(j) - 2;
    // A later term needs fewer bits, because its factor R^k is small.
    const Bits bits = std::max(root_bits, bits_ - static_cast<Bits>((k - 1) * bits_per_term) + 64);
    Ball next(0, bits), term(0, bits);
    arb_mul_si(next.get(), x.get(), 2L * k, bits);
    arb_sub(next.get(), next.get(), e.get(), bits);
    arb_mul(next.get(), next.get(), c[j - 1].get(), bits);
    arb_mul_si(next.get(), next.get(), k + 1, bits);
    arb_add_si(term.get(), sum_.get(), k + 1, bits);
    arb_mul_si(term.get(), term.get(), -k, bits);
    arb_add(term.get(), term.get(), eigenvalue_.get(), bits);
    arb_submul(next.get(), term.get(), c[j - 2].get(), bits);
    arb_div(next.get(), next.get(), u.get(), bits);
    arb_div_si(next.get(), next.get(), static_cast<slong>(k + 1) * (k + 2), bits);
    c.push_back(std::move(next));
  }

  const Ball d = approximate_root(c, bits_per_term, bits_);
  ValueAndSlope there = horner(c, degree, d, bits_);
  const TaylorRest rest = taylor_rest(size, t, q, static_cast<int>(degree));
  there.value = Ball::plus_or_minus(there.value, rest.value);
  there.slope = Ball::plus_or_minus(there.slope, rest.slope);

  const Ball least_slope = abs(there.slope).at(root_bits).lower();
  if (!least_slope.is_positive()) return std::nullopt;
  const Ball r = max(2 * upper_size(there.value) / least_slope, two_to(-4 * bits_)).upper();
  if (!(upper_size(d) + r <= reach)) return std::nullopt;
  const Ball slope = Ball::plus_or_minus(there.slope, r * rest.curvature);
  const Ball step = there.value / slope;
  if (!(upper_size(step) < r)) return std::nullopt;

  const Ball root = d - step;
  return Zero{side == Side::left ? from_end + root : from_end - root, slope};
}

}  // namespace steadyslide::enclosure
