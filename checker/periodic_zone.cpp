#include "checker/periodic_zone.hpp"

#include <acb_calc.h>

#include <cmath>

#include "checker/failure.hpp"

namespace steadyslide::checker {
namespace {

/// A place where the friction changes, in xi, and the piece to the right of it.
using Change = std::pair<Rational, std::size_t>;

std::vector<Change> friction_changes(const Periodic& claim, bool around) {
  const Problem& p = claim.problem;
  std::vector<Change> changes;
  for (int turn = around ? -1 : 0; turn <= (around ? 1 : 0); ++turn) {
    const auto xi = [&](const Rational& x) { return (x - claim.origin) / p.period + Rational(turn); };
    if (around) changes.emplace_back(xi(p.left), 0);
    for (std::size_t k = 0; k < p.jumps.size(); ++k) changes.emplace_back(xi(p.jumps[k]), k + 1);
  }
  return changes;
}

}  // namespace

PeriodicZone::PeriodicZone(const Periodic& claim, const std::vector<Ball>& free_ends, slong precision)
    : claim_(&claim), precision_(precision) {
  const Problem& p = claim.problem;
  const auto xi = [&](const Rational& x) { return Ball((x - claim.origin) / p.period, precision); };
  const Ball left = claim.free[0] ? free_ends.front() : xi(p.left);
  const Ball right = claim.free[1] ? free_ends.back() : xi(p.pieces.back().to);
  const bool around = claim.is_whole() && claim.free[0];
  const bool inside = around ? (left + Ball(1) - right).is_positive()
                             : (!claim.free[0] || (left - xi(p.left)).is_positive()) &&
                                   (!claim.free[1] || (xi(p.pieces.back().to) - right).is_positive());
  if (!inside || !(right - left).is_positive()) throw Unproved("an end of contact may lie beyond its place");
  if (around && !((left - xi(p.left) + Ball(1)).is_positive() && (xi(p.left) + Ball(2) - right).is_positive()))
    throw Unproved("a contact more than a period away from the support");
  points_ = {left};
  pieces_ = {around ? p.friction.size() - 1 : 0};
  for (const auto& [place, piece] : friction_changes(claim, around)) {
    const Ball at(place, precision);
    if ((left - at).is_positive()) {
      pieces_ = {piece};
    } else if ((at - left).is_positive() && (right - at).is_positive()) {
      points_.push_back(at);
      pieces_.push_back(piece);
    } else if (!(at - right).is_positive()) {
      throw Unproved("an end of contact may lie at the friction jump xi = " + place.text());
    }
  }
  std::vector<Ball> alphas;
  for (const std::size_t piece : pieces_) {
    const Ball s(p.s(piece), precision);
    alphas.push_back(atan(s) / Ball::pi(precision));
    cosines_.push_back(Ball(1) / sqrt(Ball(1) + s * s));
  }
  const Ball half(0.5);
  powers_ = {!claim.has_gap() ? alphas.back() - alphas[0] : (claim.free[0] ? half : -half) - alphas[0]};
  for (std::size_t k = 1; k < arcs(); ++k) powers_.push_back(alphas[k - 1] - alphas[k]);
  if (!claim.has_gap()) return;
  points_.push_back(right);
  powers_.push_back(alphas.back() + (claim.free[1] ? half : -half));
}

std::vector<std::vector<Complex>> PeriodicZone::expansion(std::optional<std::size_t> moved) const {
  const int N = claim_->harmonics(), m = claim_->m();
  const auto terms = static_cast<std::size_t>(N + 2);
  const auto turned = [&](const Ball& angle) {  // e^(i pi angle)
    return Complex(cos(Ball::pi(precision_) * angle), sin(Ball::pi(precision_) * angle));
  };
  // log prod (1 - w u_j)^(p_j) = -sum_k w^k/k sum_j p_j u_j^k, u_j = e^(-2 pi i e_j), w = q^2.
  std::vector<Complex> sums(terms), series(terms);
  Ball angle = Ball(m) / Ball(2);
  for (std::size_t j = 0; j < points_.size(); ++j) {
    angle += powers_[j] * points_[j];
    for (std::size_t k = 1; k < terms; ++k)
      sums[k] = sums[k] + Complex(powers_[j]) * turned(Ball(-2 * static_cast<int>(k)) * points_[j]);
  }
  Complex factor = turned(angle) * Complex(Ball(std::ldexp(1.0, -m)));
  if (!claim_->has_gap()) {
    const Ball s(claim_->problem.s(pieces_.back()), precision_);
    factor = factor * Complex(s * cosines_.back(), -cosines_.back());
  } else if (claim_->free[1]) {
    factor = factor * Complex(Ball(-1));
  }
  series[0] = Complex(Ball(1).rounded(precision_));
  for (std::size_t n = 1; n < terms; ++n) {
    for (std::size_t k = 1; k <= n; ++k) series[n] = series[n] - sums[k] * series[n - k];
    series[n] = series[n] / Complex(Ball(static_cast<int>(n)));
  }
  if (moved) {
    // The derivative of sin(pi (z - e))^p is -p pi cot(pi (z - e)) times it; cot = -i (1 + 2 sum_l w^l u^l).
    const std::vector<Complex> still = series;
    for (std::size_t n = 0; n < terms; ++n) {
      for (std::size_t l = 1; l <= n; ++l) {
        series[n] =
            series[n] + Complex(Ball(2)) * turned(Ball(-2 * static_cast<int>(l)) * points_[*moved]) * still[n - l];
      }
    }
    factor = (factor * Complex(powers_[*moved] * Ball::pi(precision_))).times_i();
  }
  const auto at = [&](int index) {
    return index < 0 ? Complex() : factor * series.at(static_cast<std::size_t>(index));
  };
  std::vector<std::vector<Complex>> result;
  for (int n = N; n >= 0; --n) {
    std::vector<Complex>& row = result.emplace_back();
    for (int k = m == 0 ? 0 : 1; k <= 2 * N - m; k += 2) {
      const Complex up = at((m + k) / 2 - n);
      const Complex down = m >= k && k > 0 ? at((m - k) / 2 - n) : Complex();
      row.push_back(up + down);
      if (k > 0) row.push_back((up - down).times_i());
    }
  }
  return result;
}

Complex PeriodicZone::wave(const Complex& xi, const Wave& wave) const {
  Complex sum;
  std::size_t next = 0;
  for (int k = claim_->m() == 0 ? 0 : 1; next < wave.size(); k += 2) {
    if (k == 0) {
      sum = sum + Complex(wave[next++]);
      continue;
    }
    const Complex angle = Complex(Ball(k)) * xi;
    sum = sum + Complex(Ball(2) * wave[next++]) * cos_pi(angle);
    sum = sum + Complex(Ball(2) * wave[next++]) * sin_pi(angle);
  }
  return sum;
}

Complex PeriodicZone::smooth(std::size_t corner, int direction, const Complex& d, const Integrand& integrand) const {
  const std::size_t own = corner % points_.size();  // without a gap the last arc ends at e_0 + 1
  const Ball position = point(corner);
  const Complex step = Complex(Ball(direction)) * d, xi = Complex(position) + step;
  Complex logarithm = Complex(powers_[own]) * (log(sinc_pi(d)) + Complex(log(Ball::pi(precision_))));
  for (std::size_t j = 0; j < points_.size(); ++j) {
    if (j == own || powers_[j].is_zero()) continue;
    const bool below = j < corner;
    const Complex distance = below ? Complex(position - points_[j]) + step : Complex(points_[j] - position) - step;
    logarithm = logarithm + Complex(powers_[j]) * log(sin_pi(distance));
  }
  Complex result = exp(logarithm) * wave(xi, *integrand.wave);
  if (integrand.times_place) result = result * xi;
  if (!integrand.moved) return result;
  const std::size_t j = *integrand.moved;
  if (j == own) return result * Complex(-powers_[j] * Ball(direction)) * cos_pi(d) / sinc_pi(d);
  return result * Complex(-powers_[j] * Ball::pi(precision_)) * cot_pi(Complex(position - points_[j]) + step);
}

struct PeriodicZone::Sum {
  const PeriodicZone* zone;
  std::size_t corner;
  int direction;
  const Ball* length;
  const Integrand* integrand;
  Ball exponent;  ///< of e^-v

  /// Sets `out` to e^(-exponent v) times the smooth factor at the distance length e^-v.
  static int at(acb_ptr out, const acb_t v, void* data, slong, slong precision) {
    const auto* sum = static_cast<const Sum*>(data);
    const Complex minus_v = Complex() - Complex(v, precision);
    const Complex value =
        exp(Complex(sum->exponent) * minus_v) *
        sum->zone->smooth(sum->corner, sum->direction, Complex(*sum->length) * exp(minus_v), *sum->integrand);
    acb_set(out, value.get());
    return 0;
  }
};

Ball PeriodicZone::integral(std::size_t corner, int direction, const Ball& length, const Integrand& integrand,
                            slong bits) const {
  const std::size_t own = corner % points_.size();
  Ball exponent = powers_[own] + Ball(1);
  if (integrand.moved == own) exponent -= Ball(1);
  if (!exponent.is_positive()) throw Unproved("a power that is not integrable");
  // Beyond v the smooth factor varies by about e^-v.
  const int last = static_cast<int>(static_cast<double>(bits + 10) * 0.7 / (exponent.approximately() + 1)) + 1;
  Sum sum{this, corner, direction, &length, &integrand, exponent};
  const Complex from(Ball().rounded(precision_)), to(Ball(last).rounded(precision_));
  Complex result(Ball().rounded(precision_));
  Bound tolerance;
  mag_set_ui_2exp_si(tolerance.get(), 1, -bits);
  acb_calc_integrate(result.get(), Sum::at, &sum, from.get(), to.get(), bits, tolerance.get(), nullptr, precision_);
  const Ball end = exp(Ball(-last).rounded(precision_));
  const Ball rest = smooth(corner, direction, Complex(hull(Ball(), length * end)), integrand).re();
  return power(length, exponent) * (result.re() + rest * power(end, exponent) / exponent);
}

Ball PeriodicZone::over_arc(std::size_t arc, const Integrand& integrand, slong bits) const {
  const Ball half = (point(arc + 1) - point(arc)) * Ball(0.5);
  return integral(arc, 1, half, integrand, bits) + integral(arc + 1, -1, half, integrand, bits);
}

Ball PeriodicZone::value(std::size_t corner, int direction, const Ball& d, const Wave& wave) const {
  return power(d, powers_[corner]) * smooth(corner, direction, Complex(d), {&wave}).re();
}

}  // namespace steadyslide::checker
