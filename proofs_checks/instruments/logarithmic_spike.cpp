#include "proofs_checks/instruments/logarithmic_spike.hpp"

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <numbers>

#include "numeric/quadrature/tanh_sinh.hpp"

namespace steadyslide::proofs_checks {
namespace {

using std::numbers::pi;
using Gauss = boost::math::quadrature::gauss<double, 20>;

}  // namespace

double spike_energy(double l) {
  double tail = 0;
  for (int k = 1; k < 40; k += 2) tail += std::exp(-k * l) / (k * k * k);
  const double zeta3 = boost::math::constants::zeta_three<double>();
  return 4 / (pi * l * l) * (pi * pi * l / 4 - 7 * zeta3 / 4 + 2 * tail);
}

double spike_energy_by_quadrature(double l) {
  const double length = std::min(l, 40.0);  // e^-40 is left out
  const auto integrand = [l](const numeric::Node<double>& node) {
    const double r = node.from_left;
    return (l - r) * (std::log1p(std::exp(-r)) - std::log(-std::expm1(-r)));
  };
  const numeric::Power<double> none{0, 1};
  return 4 / (pi * l * l) *
         numeric::tanh_sinh::panel_integral<double>({{0, length, length}, none, none, integrand}).value;
}

double spike_weight(const Rational& s, double l) {
  const auto alpha = numeric::to_real<double>(Exponent::angle(s));
  const auto unit = [alpha](double x) {
    return std::cos(pi * alpha) / pi * std::pow(1 + x, -0.5 - alpha) * std::pow(1 - x, -0.5 + alpha);
  };
  // (1/L) int_0^L (mass of t_0 on |x| < e^-r/2) dr.
  const auto mass = [&](double r) {
    const double radius = std::exp(-r) / 2;
    return Gauss::integrate(unit, -radius, radius);
  };
  double sum = 0;
  const double most = std::min(l, 40.0);
  for (double from = 0; from < most; from += 2) sum += Gauss::integrate(mass, from, std::min(from + 2, most));
  return sum / l;
}

}  // namespace steadyslide::proofs_checks
