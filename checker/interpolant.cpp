#include "checker/interpolant.hpp"

#include <algorithm>
#include <cmath>

namespace steadyslide::checker {

std::optional<Interpolant> Interpolant::of(const TractionRepresentation& form, slong bits, std::size_t k,
                                           const SurfacePoint& start, const Ball& length) {
  const slong precision = form.contact().precision();
  const Ball half = length * Ball(0.5);
  const SurfacePoint panel{start.left, start.right, start.from_left + hull(Ball(), length),
                           start.from_right - hull(Ball(), length)};
  const std::vector<TractionRepresentation::Piece> pieces = form.other_pieces(k, panel);
  Interpolant result;
  std::vector<Ball> growth;  // z
  double least = 1e9;
  for (const auto& [distance, size, relative_error] : pieces) {
    const Ball y = Ball(1).rounded(precision) + distance / half;
    if (!(y - Ball(1.25)).is_positive()) return std::nullopt;
    growth.push_back((y + sqrt(y * y - Ball(1))).lower());
    least = std::min(least, growth.back().approximately());
    result.integrals_ += size / distance;
    result.rest_ += size / distance * relative_error;
  }
  const auto n = std::max(static_cast<slong>(form.terms(k)),
                          static_cast<slong>(std::ceil(static_cast<double>(bits + 1) / std::log2(least))) + 1);
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    Ball power = growth[i];
    arb_pow_ui(power.get(), power.get(), static_cast<ulong>(n), precision);
    result.rest_ += (Ball(2) * pieces[i].size / (pieces[i].distance * power)).size();
  }
  // cos(pi m/(2n)), and the values at the zeros.
  std::vector<Ball> cosines, values;
  for (slong m = 0; m < 4 * n; ++m) {
    const Rational turns = Rational(static_cast<int>(m)) / Rational(static_cast<int>(2 * n));
    cosines.push_back(cos(Ball::pi(precision) * Ball(turns, precision)));
  }
  for (slong l = 0; l < n; ++l) {
    const Ball d = half + half * cosines[static_cast<std::size_t>(2 * l + 1)];
    values.push_back(
        form.sums_to(bits + 6, k, {start.left, start.right, start.from_left + d, start.from_right - d}).value);
  }
  for (slong j = 0; j < n; ++j) {
    Ball sum = Ball().rounded(precision);
    for (slong l = 0; l < n; ++l) {
      const Ball& cosine = cosines[static_cast<std::size_t>(j * (2 * l + 1) % (4 * n))];
      arb_addmul(sum.get(), values[static_cast<std::size_t>(l)].get(), cosine.get(), precision);
    }
    sum = sum * Ball(j == 0 ? 1 : 2) / Ball(static_cast<int>(n));
    result.coefficients_.push_back(sum.middle());
    result.rest_ += sum.radius();
  }
  return result;
}

Ball Interpolant::range() const {
  Ball variation = rest_;
  for (std::size_t j = 1; j < coefficients_.size(); ++j) variation += coefficients_[j].size();
  return coefficients_[0].widened(variation);
}

std::vector<Ball> Interpolant::polynomial() const {
  const std::size_t n = coefficients_.size();
  std::vector<Ball> result(n), before(n), now(n);  // T_{j-1}, T_j
  now[0] = 1;
  for (std::size_t j = 0; j < n; ++j) {
    for (std::size_t m = 0; m <= j; ++m) result[m] += coefficients_[j] * now[m];
    // T_{j+1} = 2 y T_j - T_{j-1}, T_1 = y
    for (std::size_t m = n; m-- > 0;) {
      const Ball next = (m == 0 ? Ball() : now[m - 1] * Ball(j == 0 ? 1 : 2)) - before[m];
      before[m] = now[m];
      now[m] = next;
    }
  }
  return result;
}

}  // namespace steadyslide::checker
