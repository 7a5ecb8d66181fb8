#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <numbers>

#include "numeric/interior/interior_stress.hpp"
#include "numeric/riemann_hilbert/riemann_hilbert_solution.hpp"
#include "numeric/riemann_hilbert/traction_density.hpp"
#include "proofs_checks/instruments/solutions/local_behaviour.hpp"
#include "proofs_checks/instruments/solutions/trial.hpp"
#include "proofs_checks/instruments/tractions/parabola_cases.hpp"
#include "proofs_checks/kit/claim_builder.hpp"
#include "proofs_checks/kit/rate.hpp"

namespace steadyslide::proofs_checks::sec_02_infinite_energy {
namespace {

/// Returns int sigma:epsilon/2 over radius < r < 2 radius, z > 0.
double annulus_energy(const numeric::InteriorStress<double>& stress, const Solid& body, double radius) {
  using boost::math::quadrature::gauss;
  const auto nu = to_real<double>(body.poisson());
  const auto young = to_real<double>(body.young());
  const auto density = [&](double r, double angle) {
    const auto s = stress.at(Rational(r * std::cos(angle)), Rational(r * std::sin(angle)));
    const double xx = s.xx.value;
    const double zz = s.zz.value;
    const double xz = s.xz.value;
    return (1 + nu) / (2 * young) * ((1 - nu) * (xx * xx + zz * zz) - 2 * nu * xx * zz + 2 * xz * xz);
  };
  const auto ring = [&](double log_r) {
    const double r = radius * std::exp(log_r);
    return r * r * gauss<double, 15>::integrate([&](double angle) { return density(r, angle); }, 0.0, std::numbers::pi);
  };
  return gauss<double, 7>::integrate(ring, 0.0, std::numbers::ln2);
}

/// Returns the value at R = oo of a function of 1/R, from its values at R, 2 R, 4 R, ...
double extrapolated_to_infinity(std::vector<double> f) {
  double power = 2;
  for (std::size_t n = f.size(); n > 1; --n) {
    for (std::size_t i = 0; i + 1 < n; ++i) f[i] = f[i + 1] + (f[i + 1] - f[i]) / (power - 1);
    power *= 2;
  }
  return f.front();
}

/// Returns the rate at which values at R, 2 R, ... approach their limit.
Order approach(const std::vector<double>& radii, const std::vector<double>& values) {
  const double limit = extrapolated_to_infinity(values);
  std::vector<Level> levels;
  for (std::size_t i = 0; i < radii.size(); ++i) levels.push_back({radii[i], std::abs(values[i] - limit)});
  const Rate rate = fitted_rate(levels);
  return {rate.value, rate.error_bar, "radii in powers of two"};
}

/// Returns log 2 (P^2 + F^2)/(pi E') with the modulus E'.
double energy_of_forces(double p, double f, double modulus) {
  return std::numbers::ln2 * (p * p + f * f) / (std::numbers::pi * modulus);
}

double load_of(const ContactProblem& problem) { return to_real<double>(problem.load()); }

double plane_strain_modulus(const ContactProblem& problem) {
  const Solid& body = *problem.elasticity().half_space();
  return to_real<double>(body.young() / (1 - body.poisson() * body.poisson()));
}

}  // namespace

Claim claim() {
  return compared<ContactProblem>("sec-02-infinite-energy")
      .cases(fixed_cases<ContactProblem>(
          {punch(Rational(1, 5), {Rational(1, 2), 2}, {Rational(1, 4)}, Rational(3, 2)),
           parabola(Rational(2, 5), {1, Rational(1, 3)}, {Rational(1, 10)}, 1, 2, Rational(1, 2)),
           punch(Rational(-1, 2), {Rational(3, 4)}, {}, 1, Sliding::minus_x)},
          1, "solved problems with and without friction jumps, sliding both ways"))
      .precision(Precision::in_double)
      // Stresses far away are sums of parts that almost cancel, and extrapolation takes differences: digits are lost.
      .measured([](const ContactProblem& problem) -> Values {
        const auto solution = solve<double>(problem);
        const auto& form = solution->form();
        const trapezoidal::Grid<double> grid(numeric::traction_density(form));
        const std::size_t last = segments_of(form).size() - 1;
        const numeric::InteriorStress<double> stress(*solution);
        const auto scale = to_real<double>(problem.elasticity().compliance() * form.problem().frame().unit);
        std::vector<double> radii, rises, energies;
        for (double radius = 64; radius <= 1024; radius *= 2) {
          radii.push_back(radius);
          rises.push_back(scale * (grid.displacement(last, Side::right, 2 * radius) -
                                   grid.displacement(last, Side::right, radius)));
          energies.push_back(annulus_energy(stress, *problem.elasticity().half_space(), radius));
        }
        return {{"rise", extrapolated_to_infinity(rises)},
                {"energy", extrapolated_to_infinity(energies)},
                {"approach of the rise", approach(radii, rises)},
                {"approach of the energy", approach(radii, energies)}};
      })
      .predicted([](const ContactProblem& problem) -> Values {
        // The statement takes F as given.
        const double f = solve<double>(problem)->resultants().tangential.value;
        const auto compliance = to_real<double>(problem.elasticity().compliance());
        return {{"rise", compliance * load_of(problem) * std::numbers::ln2 / std::numbers::pi},
                {"energy", energy_of_forces(load_of(problem), f, plane_strain_modulus(problem))},
                {"approach of the rise", Order{1}},
                {"approach of the energy", Order{1}}};
      })
      .wrong("the tangential force forgotten",
             [](Values& p, const ContactProblem& problem) {
               p["energy"] = energy_of_forces(load_of(problem), 0, plane_strain_modulus(problem));
             })
      .wrong("the work of the stresses instead of half of it", scaled({"energy"}, 2))
      .wrong("the modulus of plane stress",
             [](Values& p, const ContactProblem& problem) {
               const auto young = to_real<double>(problem.elasticity().half_space()->young());
               p["energy"] *= plane_strain_modulus(problem) / young;
             })
      .wrong("the surface sinks away from the contact", scaled({"rise"}, -1))
      .wrong("errors like `1/R^2`",
             replaced({{"approach of the rise", Order{2}}, {"approach of the energy", Order{2}}}))
      .near_misses();
}

}  // namespace steadyslide::proofs_checks::sec_02_infinite_energy
