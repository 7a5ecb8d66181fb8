#pragma once
// The competitor for integrals with singular ends: Arb's adaptive integrator, acb_calc_integrate.

#include <acb_calc.h>

#include <vector>

#include "enclosure/number/ball.hpp"

namespace steadyslide::bench {

struct ComplexBall {
  ComplexBall() { acb_init(value); }
  ComplexBall(const ComplexBall&) = delete;
  ComplexBall& operator=(const ComplexBall&) = delete;
  ~ComplexBall() { acb_clear(value); }
  operator acb_ptr() { return value; }  // NOLINT(google-explicit-constructor): as acb_t is

  acb_t value;
};

struct PowerIntegrand {
  std::vector<enclosure::Ball> points;  ///< e_j, increasing
  std::vector<enclosure::Ball> powers;  ///< p_j
};

/// prod |x - e_j|^(p_j) on the interval between two neighbouring points, by distances from its ends.
struct Stretch {
  struct Factor {
    bool on_left;
    enclosure::Ball beyond_end, power;
  };
  enclosure::Ball length;
  std::vector<Factor> factors;

  Stretch(const PowerIntegrand& all, std::size_t left) : length(all.points[left + 1] - all.points[left]) {
    for (std::size_t j = 0; j < all.points.size(); ++j) {
      const bool on_left = j <= left;
      const std::size_t end = on_left ? left : left + 1;
      if (j == end) {  // one power more, because dx/dtau is the product of the distances over the length
        factors.push_back({on_left, 0, all.powers[j] + 1});
      } else {
        factors.push_back({on_left, enclosure::abs(all.points[end] - all.points[j]), all.powers[j]});
      }
    }
  }
};

/// Computes the integrand times dx/dtau, x = tanh(tau/2) on the interval. Arb's own function computes each power, as a
/// holomorphic function if `order` requires it.
inline int value_on_stretch(acb_ptr result, const acb_t tau, void* parameters, slong order, slong bits) {
  const Stretch& stretch = *static_cast<const Stretch*>(parameters);
  ComplexBall from_left, from_right, base, exponent, power;
  const auto distance = [&](acb_ptr from_end, const acb_t argument) {
    acb_exp(from_end, argument, bits);
    acb_add_ui(from_end, from_end, 1, bits);
    acb_inv(from_end, from_end, bits);
    acb_mul_arb(from_end, from_end, stretch.length.get(), bits);
  };
  acb_neg(base, tau);
  distance(from_left, base);
  distance(from_right, tau);
  acb_one(result);
  acb_div_arb(result, result, stretch.length.get(), bits);
  for (const Stretch::Factor& factor : stretch.factors) {
    acb_add_arb(base, factor.on_left ? from_left : from_right, factor.beyond_end.get(), bits);
    acb_set_arb(exponent, factor.power.get());
    acb_pow_analytic(power, base, exponent, order != 0, bits);
    acb_mul(result, result, power, bits);
  }
  return 0;
}

/// Returns the integral between two neighbouring points, to an absolute tolerance of 2^-bits. Parts in which the
/// integrand is below 2^-bits are left out.
inline enclosure::Ball arb_integral(const PowerIntegrand& integrand, std::size_t left, enclosure::Bits bits) {
  Stretch stretch(integrand, left);
  const double decay = static_cast<double>(bits) * 0.693;
  ComplexBall from, to, value;
  acb_set_d(from, -decay / (integrand.powers[left].to_double() + 1));
  acb_set_d(to, decay / (integrand.powers[left + 1].to_double() + 1));
  mag_t tolerance;
  mag_init(tolerance);
  mag_set_ui_2exp_si(tolerance, 1, -bits);
  acb_calc_integrate_opt_t options;
  acb_calc_integrate_opt_init(options);
  options->eval_limit = 100000000;
  options->depth_limit = 100000;
  acb_calc_integrate(value, value_on_stretch, &stretch, from, to, bits, tolerance, options, bits);
  mag_clear(tolerance);
  enclosure::Ball real(0, bits);
  acb_get_real(real.get(), value);
  return real;
}

}  // namespace steadyslide::bench
