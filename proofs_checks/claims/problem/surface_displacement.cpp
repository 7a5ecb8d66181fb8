// The displacements of the surface under given tractions, from the field in the body. [Bal16, (1)]

#include <algorithm>
#include <memory>

#include "numeric/quadrature/trapezoidal.hpp"
#include "proofs_checks/claims/claims.hpp"
#include "proofs_checks/claims/problem/far_field.hpp"
#include "proofs_checks/instruments/half_plane_field.hpp"
#include "proofs_checks/instruments/near.hpp"
#include "proofs_checks/instruments/power_form.hpp"
#include "proofs_checks/kit/findings.hpp"
#include "proofs_checks/kit/random.hpp"

namespace steadyslide::proofs_checks {
namespace {

using numeric::StressComponents;

struct Body {
  Solid solid;
  Polynomial normal;
  Polynomial tangential;
};

/// u_n' = c (hilbert PV int t_n/(x'-x) + shear t_t), u_t' = c (hilbert PV int t_t/(x'-x) + pressure t_n).
template <class R>
struct SlopesSaid {
  R hilbert;
  R shear;
  R pressure;
  R compliance;
};
using SlopesFormula = Formula<SlopesSaid, Body>;

Polynomial random_polynomial(Random& random, std::size_t degree) {
  std::vector<Rational> coefficients;
  for (std::size_t k = 0; k <= degree; ++k) coefficients.push_back(random.between(-2, 2));
  return Polynomial(coefficients);
}

std::vector<Body> bodies(const Context& context) {
  Random random(context.seed, "eq-01");
  std::vector<Body> all;
  const std::size_t count = context.quick ? 1 : 12;
  for (std::size_t k = 0; k < count; ++k) {
    const Rational young = random.between(Rational(1, 2), 3);
    all.push_back(
        {Solid(random.poisson(), young), random_polynomial(random, 1 + k % 4), random_polynomial(random, 4 - k % 4)});
  }
  return all;
}

/// The largest difference of components, over the largest component.
template <Real R>
double difference(const StressComponents<R>& a, const StressComponents<R>& b) {
  using std::abs, std::max;
  const R largest = max({R(abs(b.xx)), R(abs(b.zz)), R(abs(b.xz))});
  return static_cast<double>(R(max({R(abs(a.xx - b.xx)), R(abs(a.zz - b.zz)), R(abs(a.xz - b.xz))}) / largest));
}

/// Is it the elastic field of these tractions? Equilibrium, compatibility (sigma_xx + sigma_zz is harmonic: its mean
/// over a circle is its value in the centre), the tractions on the surface, and the sum of radial fields.
template <Real R>
void check_field(Findings& findings, const HalfPlaneField<R>& field, const PiecewiseTraction& normal,
                 const PiecewiseTraction& tangential) {
  using std::abs, std::cos, std::sin;
  // Eight values: an error like the step's eighth power, and rounding over the step.
  const Quantity equilibrium{"equilibrium within the body", {"d sigma_xj/dx", "-d sigma_zj/dz"}, 1e-45};
  const Quantity compatibility{"sigma_xx + sigma_zz within the body", {"mean over a circle", "centre"}, 1e-45};
  const Quantity boundary{"stresses on the surface", {"(sigma_zz, sigma_xz)", "(t_n, -t_t)"}, 1e-45};
  const Quantity radial{"stresses within the body", {"potentials", "sum of radial fields"}, 1e-45};
  const R x = R(1) / 3;
  const R z = R(4) / 5;
  const StressComponents<R> at = field.stress(x, z);
  findings.compare(radial, difference(at, field.superposed_stress(x, z)));
  const R size = abs(at.xx) + abs(at.zz) + abs(at.xz);
  const StressComponents<R> rate = field.stress_rate(x, z);
  const R zz = derivative([&](const R& at) { return field.stress(x, at).zz; }, z, R(1));
  const R xz = derivative([&](const R& at) { return field.stress(x, at).xz; }, z, R(1));
  findings.compare(equilibrium, static_cast<double>(R(abs(rate.xx + xz) / size)));
  findings.compare(equilibrium, static_cast<double>(R(abs(rate.xz + zz) / size)));
  constexpr int points = 64;
  R mean = 0;
  for (int k = 0; k < points; ++k) {
    const R angle = 2 * numeric::pi<R>() * k / points;
    const StressComponents<R> there = field.stress(x + cos(angle) / 10, z + sin(angle) / 10);
    mean += (there.xx + there.zz) / points;
  }
  findings.compare(compatibility, static_cast<double>(R(abs(mean - at.xx - at.zz) / size)));
  const StressComponents<R> surface = field.stress(x, R(0));
  findings.compare(boundary, static_cast<double>(R(abs(surface.zz - value_at<R>(normal, x)) / size)));
  findings.compare(boundary, static_cast<double>(R(abs(surface.xz + value_at<R>(tangential, x)) / size)));
}

std::vector<Evidence> check_slopes(const Context& context, const SlopesFormula& formula, GaussRules& rules) {
  const numeric::Digits digits = std::max(context.digits, numeric::Digits::fifty);
  const auto walk = [&]<Real R>() -> std::vector<Evidence> {
    using std::abs;
    if constexpr (std::same_as<R, double>) {
      return {};
    } else {
      const Quantity normal{"u_n'", {"equation (1)", "strains integrated along the depth"}, 1e-45};
      const Quantity tangential{"u_t'", {"equation (1)", "epsilon_xx of the field at the surface"}, 1e-45};
      const std::vector<Body> all = bodies(context);
      Findings findings;
      for (const Body& body : all) {
        findings.begin_case("nu = " + to_string(body.solid.poisson()) + ", t_n = " + to_string(body.normal) +
                            ", t_t = " + to_string(body.tangential));
        const PiecewiseTraction t_n{{-1, 1, body.normal}};
        const PiecewiseTraction t_t{{-1, 1, body.tangential}};
        const SlopesSaid<R> said = formula.at<R>(body);
        const HalfPlaneField<R> field(body.solid, t_n, t_t, rules);
        const numeric::trapezoidal::Grid<R> grid_n(density_of<R>(t_n));
        const numeric::trapezoidal::Grid<R> grid_t(density_of<R>(t_t));
        const R pi = numeric::pi<R>();
        for (const int percent : {30, 58, 75}) {
          const numeric::PanelPoint<R> at = grid_n.midpoint_near(0, R(percent) / 100);
          const R& x = at.node.x;
          const R n = value_at<R>(t_n, x);
          const R t = value_at<R>(t_t, x);
          const R pv_n = pi * grid_n.hilbert(at);
          const R pv_t = pi * grid_t.hilbert(at);
          const R scale = said.compliance * (abs(n) + abs(t) + (abs(pv_n) + abs(pv_t)) / pi);
          const R u_t = said.compliance * (said.hilbert * pv_t + said.pressure * n);
          findings.compare(tangential, static_cast<double>(R(abs(u_t - field.tangential_slope(x)) / scale)));
          const R u_n = said.compliance * (said.hilbert * pv_n + said.shear * t);
          findings.compare(normal, static_cast<double>(R(abs(u_n - field.normal_slope(x)) / scale)));
          if (context.quick) break;
        }
        check_field(findings, field, t_n, t_t);
      }
      return findings.evidence("random polynomials of degree up to 4 on ]-1, 1[, Poisson ratios of ]-1, 1/2[, seed " +
                               std::to_string(context.seed));
    }
  };
  return gather([&] { return numeric::at_precision(digits, walk); });
}

SlopesFormula slopes_formula() {
  return SlopesFormula::from([]<Real R>(const Body& body) {
    const Rational& nu = body.solid.poisson();
    const R gamma = numeric::to_real<R>((1 - 2 * nu) / (2 * (1 - nu)));
    return SlopesSaid<R>{R(1 / numeric::pi<R>()), R(-gamma), gamma,
                         numeric::to_real<R>(2 * (1 - nu * nu) / body.solid.young())};
  });
}

Claim slopes_claim() {
  const SlopesFormula right = slopes_formula();
  const auto wrong = [&](std::string name, auto change) {
    return Wrong<SlopesFormula>{std::move(name),
                                right.changed([change](auto& said, const Body& b) { change(said, b); })};
  };
  return make_claim(
      claim_text("eq-01-surface-displacement"),
      [rules = std::make_shared<GaussRules>()](const Context& context, const SlopesFormula& formula) {
        return check_slopes(context, formula, *rules);
      },
      right,
      std::vector<Wrong<SlopesFormula>>{
          wrong("gamma's sign in u_n'", [](auto& said, const Body&) { said.shear = -said.shear; }),
          wrong("gamma's sign in u_t'", [](auto& said, const Body&) { said.pressure = -said.pressure; }),
          wrong("gamma's sign in both", [](auto& said, const Body&) { std::swap(said.shear, said.pressure); }),
          wrong("gamma of plane stress, (1-nu)/2",
                []<class R>(SlopesSaid<R>& said, const Body& body) {
                  said.pressure = numeric::to_real<R>((1 - body.solid.poisson()) / 2);
                  said.shear = -said.pressure;
                }),
          wrong("1/pi missing", []<class R>(SlopesSaid<R>& said, const Body&) { said.hilbert *= numeric::pi<R>(); }),
          wrong("the principal value of 1/(x-x')", [](auto& said, const Body&) { said.hilbert = -said.hilbert; }),
          wrong("near miss: gamma in u_n' moved by a hundred times the tolerance",
                []<class R>(SlopesSaid<R>& said, const Body&) { said.shear += R(1e-43); }),
          wrong("near miss: 1/pi moved by a hundred times the tolerance",
                []<class R>(SlopesSaid<R>& said, const Body&) { said.hilbert *= 1 + R(1e-43); })});
}

}  // namespace

std::vector<Claim> surface_displacement_claims() { return {slopes_claim(), infinite_energy_claim()}; }

}  // namespace steadyslide::proofs_checks
