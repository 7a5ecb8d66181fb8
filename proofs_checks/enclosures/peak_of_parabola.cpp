// Bounds the fourth Taylor coefficient of exp(-log(1+s^2)/2 + alpha (log(1+2 alpha) - log(1-2 alpha))),
// alpha = arctan(s)/pi. The interval is divided into pieces. The balls c_0, ..., c_4 contain the coefficients at every
// point of a piece. |c_4| <= 1/20 is decided.

#include "enclosure/number/ball.hpp"
#include "proofs_checks/enclosures/enclosure_list.hpp"

namespace steadyslide::proofs_checks {
namespace {

using enclosure::Ball;

constexpr enclosure::Bits peak_bits = 64;
constexpr int peak_order = 4;

struct Taylor {
  Ball coefficients[peak_order + 1];
  Ball& operator[](int k) { return coefficients[k]; }
  const Ball& operator[](int k) const { return coefficients[k]; }
};

Taylor taylor_product(const Taylor& f, const Taylor& g) {
  Taylor h;
  for (int k = 0; k <= peak_order; ++k) {
    for (int j = 0; j <= k; ++j) h[k] += f[j] * g[k - j];
  }
  return h;
}

Taylor taylor_sum(const Taylor& f, const Ball& factor, const Taylor& g) {
  Taylor h;
  for (int k = 0; k <= peak_order; ++k) h[k] = f[k] + factor * g[k];
  return h;
}

/// Returns log(f), from f log(f)' = f'.
Taylor taylor_log(const Taylor& f) {
  Taylor h;
  h[0] = log(f[0]);
  for (int k = 1; k <= peak_order; ++k) {
    Ball rest = f[k] * k;
    for (int j = 1; j < k; ++j) rest -= h[j] * f[k - j] * j;
    h[k] = rest / (f[0] * k);
  }
  return h;
}

/// Returns exp(f), from exp(f)' = f' exp(f).
Taylor taylor_exp(const Taylor& f) {
  Taylor h;
  h[0] = exp(f[0]);
  for (int k = 1; k <= peak_order; ++k) {
    Ball all(0, peak_bits);
    for (int j = 1; j <= k; ++j) all += f[j] * h[k - j] * j;
    h[k] = all / k;
  }
  return h;
}

/// Returns arctan(s)/pi, from (1+s^2) arctan(s)' = 1; `square` is 1 + s^2.
Taylor taylor_angle(const Ball& s, const Taylor& square) {
  const Ball pi = Ball::pi(peak_bits);
  Taylor rate, h;
  h[0] = atan(s) / pi;
  for (int k = 0; k < peak_order; ++k) {
    Ball rest(k == 0 ? 1 : 0, peak_bits);
    for (int j = 1; j <= k; ++j) rest -= square[j] * rate[k - j];
    rate[k] = rest / square[0];
    h[k + 1] = rate[k] / (pi * (k + 1));
  }
  return h;
}

/// Returns cos(pi alpha) ((1 + 2 alpha)/(1 - 2 alpha))^(times alpha).
Taylor taylor_peak(const Ball& s, int times) {
  const Taylor square{1 + s * s, 2 * s, Ball(1, peak_bits), Ball(0, peak_bits), Ball(0, peak_bits)};
  const Taylor alpha = taylor_angle(s, square);
  const Taylor one{Ball(1, peak_bits)};
  const Taylor quotient = taylor_sum(taylor_log(taylor_sum(one, 2, alpha)), -1, taylor_log(taylor_sum(one, -2, alpha)));
  const Ball minus_half = -(Ball(1, peak_bits) / 2);
  return taylor_exp(taylor_sum(taylor_product(taylor_sum({}, times, alpha), quotient), minus_half, taylor_log(square)));
}

Decision peak_bounded(const Box& box, int times, const Rational& most) {
  const Interval s = box.at("s");
  if (!s.from || !s.to) return {Truth::unknown, {"no bounded interval"}};
  constexpr int pieces = 256;
  const Ball bound(most, peak_bits);
  Truth holds = Truth::yes;
  Ball largest(0, peak_bits);
  for (int k = 0; k < pieces; ++k) {
    const Rational width = (*s.to - *s.from) / pieces;
    const Ball from(*s.from + k * width, peak_bits);
    const Ball to(*s.from + (k + 1) * width, peak_bits);
    if (abs(taylor_peak(from, times)[peak_order]) > bound) return {Truth::no, {"c_4 at s = " + from.to_string(6)}};
    const Ball c = abs(taylor_peak(Ball::hull(from, to), times)[peak_order]);
    if (!(c <= bound)) holds = Truth::unknown;
    largest = max(largest, c);
  }
  return {holds, {"|c_4| <= " + largest.upper().to_string(4)}};
}

}  // namespace

Enclosure peak_of_parabola() {
  const Rational twentieth(1, 20);
  const auto with = [](int times, const Rational& most) {
    return [=](const Box& box) { return peak_bounded(box, times, most); };
  };
  return {"peak-of-parabola",
          with(1, twentieth),
          {{"1/30 for 1/20", with(1, Rational(1, 30))},
           {"`cos(pi alpha)` alone", with(0, twentieth)},
           {"the power `2 alpha`", with(2, twentieth)},
           {"the quotient turned", with(-1, twentieth)}}};
}

}  // namespace steadyslide::proofs_checks
