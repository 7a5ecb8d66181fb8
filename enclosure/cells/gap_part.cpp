#include "enclosure/cells/gap_part.hpp"

#include <cmath>

namespace steadyslide::enclosure {
namespace {

constexpr int table_size = 64;

Ball times_log(const Ball& x) { return x.is_zero() ? x : x * log(x); }

/// Adds M of -c e_k over [z0, z1], x0 = k + z0 and x1 = k + z1, to `curvature`, or its dip to `beside`.
void add(const Ball& c, const Ball& x0, const Ball& x1, Ball& curvature, Ball& beside) {
  if (c.is_zero()) return;
  if (c.is_negative()) {
    curvature += c / x1;
  } else if (x0.is_positive()) {
    curvature += c / x0;
  } else {
    // 1/e < 0.368.
    beside += c * x1 * Ball(Rational(368, 1000), x1.bits());
  }
}

}  // namespace

NearLogarithms::NearLogarithms(Bits bits) : bits_(bits) {
  for (std::size_t k = 0; k < near; ++k) {
    for (int j = 0; j <= table_size; ++j) tables_[k].push_back(made(k, Ball(j, bits) / Ball(table_size)));
  }
}

Ball NearLogarithms::made(std::size_t k, const Ball& z) const {
  const Ball left(static_cast<int>(k), bits_);
  const Ball right(static_cast<int>(k + 1), bits_);
  return (Ball(1) - z) * times_log(left) + z * times_log(right) - times_log(left + z);
}

Ball NearLogarithms::operator()(std::size_t k, double z) const {
  const double j = z * table_size;
  if (j == std::floor(j)) return tables_[k][static_cast<std::size_t>(j)];
  return made(k, Ball::exactly(z, bits_));
}

Ball GapPart::value(double z, const NearLogarithms& e) const {
  Ball sum = value_at(q, Ball::exactly(z, rest.bits()));
  for (std::size_t k = 0; k < near; ++k) sum += a[k] * e(k, z) - b[k] * e(k, 1 - z);
  return sum;
}

Ball GapPart::dip(double z0, double z1) const {
  const Bits bits = rest.bits();
  const Ball low = Ball::exactly(z0, bits);
  const Ball high = Ball::exactly(z1, bits);
  const Ball width = high - low;
  const Ball range = Ball::hull(low, high);
  Ball curvature(0, bits);
  for (std::size_t k = q.size(); k-- > 2;) {
    curvature = curvature * range + q[k] * Ball(static_cast<int>(k * (k - 1)));
  }
  Ball beside(0, bits);
  for (std::size_t k = 0; k < near; ++k) {
    const auto distance = static_cast<int>(k);
    add(-a[k], Ball(distance) + low, Ball(distance) + high, curvature, beside);
    add(b[k], Ball(distance + 1) - high, Ball(distance + 1) - low, curvature, beside);
  }
  return beside + max(curvature, Ball(0, bits)) * width * width / Ball(8);
}

}  // namespace steadyslide::enclosure
