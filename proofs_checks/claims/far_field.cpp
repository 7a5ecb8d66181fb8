#include "proofs_checks/claims/far_field.hpp"

#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <numbers>

#include "numeric/interior_stress.hpp"
#include "numeric/trapezoidal.hpp"
#include "proofs_checks/claims/near.hpp"
#include "proofs_checks/claims/parabola_cases.hpp"
#include "proofs_checks/claims/trial.hpp"
#include "proofs_checks/rate.hpp"

namespace steadyslide::proofs_checks {
namespace {

/// energy (1 - nu^2) (normal P^2 + tangential F^2) log 2/(pi E) between R and 2 R, R -> oo; rise c P log 2/pi of the
/// surface from R to 2 R; both with errors like R^-rate.
struct FarSaid {
  double energy = 1;
  double normal = 1;
  double tangential = 1;
  double rise = 1;
  double rate = 1;
  bool plane_stress = false;
};

std::vector<ContactProblem> problems(const Context& context) {
  std::vector<ContactProblem> all{punch(Rational(1, 5), {Rational(1, 2), 2}, {Rational(1, 4)}, Rational(3, 2))};
  if (context.quick) return all;
  all.push_back(parabola(Rational(2, 5), {1, Rational(1, 3)}, {Rational(1, 10)}, 1, 2, Rational(1, 2)));
  all.push_back(punch(Rational(-1, 2), {Rational(3, 4)}, {}, 1, Sliding::minus_x));
  return all;
}

/// int sigma:epsilon/2 over radius < r < 2 radius, z > 0.
double annulus_energy(const numeric::InteriorStress<double>& stress, const Solid& body, double radius) {
  using boost::math::quadrature::gauss;
  const double nu = numeric::to_real<double>(body.poisson());
  const double young = numeric::to_real<double>(body.young());
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

/// The value at R = oo of a function of 1/R, from values at R, 2 R, 4 R, ...
double extrapolated_to_infinity(std::vector<double> f) {
  double power = 2;
  for (std::size_t n = f.size(); n > 1; --n) {
    for (std::size_t i = 0; i + 1 < n; ++i) f[i] = f[i + 1] + (f[i + 1] - f[i]) / (power - 1);
    power *= 2;
  }
  return f.front();
}

/// Values at R, 2 R, ... against their limit.
void check_limit(Findings& findings, const Quantity& quantity, const std::string& rate_of,
                 const std::vector<double>& radii, const std::vector<double>& values, double limit, double rate) {
  findings.compare(quantity, relative_difference(extrapolated_to_infinity(values), limit));
  std::vector<Level> levels;
  for (std::size_t i = 0; i < radii.size(); ++i) levels.push_back({radii[i], std::abs(values[i] - limit) / limit});
  const Rate measured = fitted_rate(levels);
  findings.measure({rate_of, measured.value, measured.error_bar, rate, 0.05, "radii in powers of two"});
}

std::vector<Evidence> check(const Context& context, const FarSaid& said) {
  // The stresses far away are sums of parts that nearly cancel, and extrapolation takes differences.
  const Quantity energy{
      "energy between R and 2 R, R -> oo", {"stresses of solutions", "two concentrated forces"}, 1e-11};
  const Quantity rise{"rise of the surface from R to 2 R, R -> oo", {"trapezoidal rule", "c P log 2/pi"}, 1e-11};
  return gather([&] {
    Findings findings;
    const std::vector<ContactProblem> all = problems(context);
    for (const ContactProblem& problem : all) {
      findings.begin_case(text_of(problem));
      const auto solution = solve<double>(problem);
      const double p = numeric::to_real<double>(problem.load());
      const double f = solution->resultants().tangential.value;
      const Solid& body = *problem.elasticity().half_space();
      const double nu = numeric::to_real<double>(body.poisson());
      const double modulus = numeric::to_real<double>(body.young()) / (said.plane_stress ? 1 : 1 - nu * nu);

      const auto& form = solution->form();
      const double load = form.problem().load();
      const numeric::trapezoidal::Grid<double> grid(traction_density(form));
      const std::size_t last = segments_of(form).size() - 1;
      std::vector<double> radii;
      std::vector<double> rises;
      std::vector<double> energies;
      const numeric::InteriorStress<double> stress(*solution);
      for (double radius = 64; radius <= 1024; radius *= 2) {
        radii.push_back(radius);
        rises.push_back(grid.displacement(last, Side::right, 2 * radius) -
                        grid.displacement(last, Side::right, radius));
      }
      check_limit(findings, rise, "rise of the surface", radii, rises,
                  said.rise * load * std::numbers::ln2 / std::numbers::pi, said.rate);
      for (const double radius : radii) energies.push_back(annulus_energy(stress, body, radius));
      check_limit(findings, energy, "energy of an annulus", radii, energies,
                  said.energy * (said.normal * p * p + said.tangential * f * f) * std::numbers::ln2 /
                      (std::numbers::pi * modulus),
                  said.rate);
    }
    return findings.evidence("solved problems with and without friction jumps, sliding both ways");
  });
}

}  // namespace

Claim infinite_energy_claim() {
  const auto wrong = [](std::string name, auto change) {
    FarSaid said;
    change(said);
    return Wrong<FarSaid>{std::move(name), said};
  };
  return make_claim(
      {"sec-02-infinite-energy", "[Bal16, section 2]: infinite energy, unbounded displacement",
       "Far from the contact the stresses fall like `1/r` only: the elastic energy between the radii `R` and `2 R` "
       "tends to `(1-nu^2) (P^2+F^2) log 2/(pi E)`, `F = int t_t`, so that the energy of the half-plane is infinite; "
       "the surface outside rises by `c P log 2/pi` from `R` to `2 R`, `c = 2 (1-nu^2)/E`, so that no displacement at "
       "infinity can be prescribed; both with errors like `1/R`.",
       "plane strain, `P > 0`; examined for solved contact problems",
       "Seen from afar the tractions are two concentrated forces, with the radial stress `sigma_rr = -2 (P sin theta + "
       "F cos theta)/(pi r)` and no other component, `theta` counted from the surface. In plane strain the energy per "
       "area is `(1-nu^2) sigma_rr^2/(2 E)`; `int_0^pi (P sin theta + F cos theta)^2 d theta = pi (P^2+F^2)/2` and "
       "`int_R^{2R} dr/r = log 2` give the constant, the same for every annulus, so that the sum over annuli diverges. "
       "Outside the contact `u' = (c/pi) int t/(x'-x) dx' = c P/(pi x) + O(1/x^2)`, and the integral of `1/x` is the "
       "logarithm. What the forces' places add is smaller by `1/R`"},
      check, FarSaid{},
      std::vector<Wrong<FarSaid>>{
          wrong("the tangential force forgotten", [](FarSaid& said) { said.tangential = 0; }),
          wrong("the work of the stresses instead of half of it", [](FarSaid& said) { said.energy = 2; }),
          wrong("the modulus of plane stress", [](FarSaid& said) { said.plane_stress = true; }),
          wrong("the surface sinks away from the contact", [](FarSaid& said) { said.rise = -1; }),
          wrong("errors like 1/R^2", [](FarSaid& said) { said.rate = 2; }),
          wrong("near miss: the energy moved by ten times the tolerance",
                [](FarSaid& said) { said.energy = 1 + 1e-10; }),
          wrong("near miss: the rise moved by ten times the tolerance", [](FarSaid& said) { said.rise = 1 + 1e-10; })});
}

}  // namespace steadyslide::proofs_checks
