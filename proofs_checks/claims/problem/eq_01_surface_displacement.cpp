#include "proofs_checks/instruments/operators/half_plane_field.hpp"
#include "proofs_checks/instruments/solutions/local_behaviour.hpp"
#include "proofs_checks/kit/claim_builder.hpp"

namespace steadyslide::proofs_checks::eq_01_surface_displacement {
namespace {

using numeric::StressComponents;

/// A half-plane under polynomial tractions on ]-1, 1[.
struct Body {
  Solid solid;
  Polynomial normal;
  Polynomial tangential;
};

std::string text_of(const Body& body) {
  return "nu = " + to_string(body.solid.poisson()) + ", t_n = " + to_string(body.normal) +
         ", t_t = " + to_string(body.tangential);
}

/// The formulas u_n' = compliance (hilbert PV int t_n/(x'-x) dx' + shear t_t), and u_t' in the same way with pressure
/// t_n.
struct SurfaceSlopes {
  Number compliance;
  Number hilbert;
  Number shear;
  Number pressure;
};

CaseList<Body> bodies(const Context& context) {
  return random_cases(context, "eq-01", 12, 1,
                      "random polynomials of degree up to 4 on ]-1, 1[, Poisson ratios of ]-1, 1/2[",
                      [](Random& random, std::size_t k) {
                        const Rational young = random.between(Rational(1, 2), 3);
                        return Body{Solid(random.poisson(), young), Polynomial(random.between(-2, 2, 2 + k % 4)),
                                    Polynomial(random.between(-2, 2, 5 - k % 4))};
                      });
}

/// Returns the largest difference of components, divided by the largest component.
template <Real R>
double difference(const StressComponents<R>& a, const StressComponents<R>& b) {
  using std::abs, std::max;
  const R largest = max({R(abs(b.xx)), R(abs(b.zz)), R(abs(b.xz))});
  return static_cast<double>(R(max({R(abs(a.xx - b.xx)), R(abs(a.zz - b.zz)), R(abs(a.xz - b.xz))}) / largest));
}

/// Checks that the field is the elastic field of these tractions: equilibrium, compatibility (sigma_xx + sigma_zz is
/// harmonic, so that its mean over a circle is its value in the centre), the tractions on the surface, and the sum of
/// radial fields.
template <Real R>
void check_field(Findings& findings, const HalfPlaneField<R>& field, const Body& body) {
  using std::abs, std::cos, std::sin;
  // Eight values: the error is of the order of the step to the power eight, plus rounding divided by the step.
  const R x = R(1) / 3;
  const R z = R(4) / 5;
  const StressComponents<R> at = field.stress(x, z);
  findings.compare("radial", difference(at, field.superposed_stress(x, z)));
  const R size = abs(at.xx) + abs(at.zz) + abs(at.xz);
  const auto small = [&](const char* quantity, const R& value) { findings.compare(quantity, R(abs(value) / size)); };
  const StressComponents<R> rate = field.stress_rate(x, z);
  small("equilibrium", rate.xx + derivative([&](const R& depth) { return field.stress(x, depth).xz; }, z, R(1)));
  small("equilibrium", rate.xz + derivative([&](const R& depth) { return field.stress(x, depth).zz; }, z, R(1)));
  constexpr int points = 64;
  R mean = 0;
  for (int k = 0; k < points; ++k) {
    const R angle = 2 * numeric::pi<R>() * k / points;
    const StressComponents<R> there = field.stress(x + cos(angle) / 10, z + sin(angle) / 10);
    mean += (there.xx + there.zz) / points;
  }
  small("compatibility", mean - at.xx - at.zz);
  const StressComponents<R> surface = field.stress(x, R(0));
  small("boundary", surface.zz - value_of(body.normal, x));
  small("boundary", surface.xz + value_of(body.tangential, x));
}

template <Real R>
void check_slopes(Findings& findings, const SurfaceSlopes& formula, const Body& body, bool quick) {
  using std::abs;
  const PiecewiseTraction t_n{{-1, 1, body.normal}};
  const PiecewiseTraction t_t{{-1, 1, body.tangential}};
  const HalfPlaneField<R> field(body.solid, t_n, t_t);
  const trapezoidal::Grid<R> grid_n(density_of<R>(t_n));
  const trapezoidal::Grid<R> grid_t(density_of<R>(t_t));
  const R pi = numeric::pi<R>();
  const R compliance(formula.compliance);
  const R hilbert = R(formula.hilbert) * pi;
  for (const int percent : {30, 58, 75}) {
    const PanelPoint<R> at = grid_n.midpoint_near(0, R(percent) / 100);
    const R& x = at.node.x;
    const R n = value_of(body.normal, x);
    const R t = value_of(body.tangential, x);
    const R h_n = grid_n.hilbert(at);
    const R h_t = grid_t.hilbert(at);
    const R scale = compliance * (abs(n) + abs(t) + abs(h_n) + abs(h_t));
    const R u_t = compliance * (hilbert * h_t + R(formula.pressure) * n);
    findings.compare("tangential", R(abs(u_t - field.tangential_slope(x)) / scale));
    const R u_n = compliance * (hilbert * h_n + R(formula.shear) * t);
    findings.compare("normal", R(abs(u_n - field.normal_slope(x)) / scale));
    if (quick) break;
  }
  check_field(findings, field, body);
}

}  // namespace

Claim claim() {
  return formula_claim<Body, SurfaceSlopes>("eq-01-surface-displacement")
      .cases(bodies)
      .precision(Precision::at_least_fifty)
      .says([](const Body& body) {
        const Rational& nu = body.solid.poisson();
        const auto gamma = to_real<Number>((1 - 2 * nu) / (2 * (1 - nu)));
        return SurfaceSlopes{to_real<Number>(2 * (1 - nu * nu) / body.solid.young()), 1 / numeric::pi<Number>(), -gamma,
                             gamma};
      })
      .checked([]<Real R>(Findings& findings, const SurfaceSlopes& formula, const Body& body, const Context& context) {
        check_slopes<R>(findings, formula, body, context.quick);
      })
      .wrong("`gamma`'s sign in `u_n'`", [](SurfaceSlopes& u) { u.shear *= -1; })
      .wrong("`gamma`'s sign in `u_t'`", [](SurfaceSlopes& u) { u.pressure *= -1; })
      .wrong("`gamma`'s sign in both", [](SurfaceSlopes& u) { std::swap(u.shear, u.pressure); })
      .wrong("`gamma` of plane stress, `(1-nu)/2`",
             [](SurfaceSlopes& u, const Body& body) {
               u.pressure = to_real<Number>((1 - body.solid.poisson()) / 2);
               u.shear = -u.pressure;
             })
      .wrong("`1/pi` missing", [](SurfaceSlopes& u) { u.hilbert *= numeric::pi<Number>(); })
      .wrong("the principal value of `1/(x-x')`", [](SurfaceSlopes& u) { u.hilbert *= -1; })
      .wrong("near miss: `gamma` in `u_n'` moved by a hundred times the tolerance",
             [](SurfaceSlopes& u) { u.shear += Number("1e-43"); })
      .wrong("near miss: `1/pi` moved by a hundred times the tolerance",
             [](SurfaceSlopes& u) { u.hilbert *= 1 + Number("1e-43"); });
}

}  // namespace steadyslide::proofs_checks::eq_01_surface_displacement
