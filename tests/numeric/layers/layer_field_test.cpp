// Stresses below the surface of layered bodies: against a matrix exponential with another integral over wave numbers, the
// half-plane, equilibrium, interfaces, the surface, and other methods.

#include "numeric/layers/layer_field.hpp"

#include "numeric/bodies/body_contact.hpp"
#include "numeric/closed_form/closed_form.hpp"
#include "numeric/interior/interface_stress.hpp"
#include "numeric/interior/largest_stress.hpp"
#include "numeric/interior/surface_stress.hpp"
#include "numeric/solution/gathered_forces.hpp"
#include "numeric/variational/variational_inequality.hpp"
#include "support/problems.hpp"
#include "transfer_matrix.hpp"

namespace {

const Solid stiff(0.25_r, 40_r), polymer(0.45_r, 1_r), lowest(0.3_r, 9_r);

ContactProblem pressed(const Body& body, std::vector<Rational> friction, const Indenter& indenter) {
  const std::vector<Rational> jumps = friction.size() > 1 ? std::vector<Rational>{0.1_r} : std::vector<Rational>{};
  return ContactProblem(Elasticity(body.layers()[0].solid), FrictionProfile(std::move(friction), jumps), indenter, 1)
      .with_body(body);
}

std::shared_ptr<const ContactSolution<double>> by_riemann_hilbert(const ContactProblem& problem) {
  const auto found = contact_on_body(problem);
  INFO(found.reason);
  REQUIRE(found.solution);
  return found.solution;
}

/// Stresses and the rotation, as LayerField returns them.
using Numbers = std::array<double, 4>;

/// Returns the stresses under t = -1, t_t = r t on [-1, 1] at these x, by the midpoint rule in k.
std::vector<Numbers> by_matrix_exponential(const Body& body, std::size_t layer, const Rational& depth, double r,
                                           const std::vector<double>& places) {
  constexpr double step = 0.35, last = 16;
  const Lame lame(body.layers()[layer].solid, Plane::strain);
  std::vector<Numbers> sums(places.size(), Numbers{});
  for (double k = step / 2; k < last; k += step) {
    const double load = 2 * std::sin(k) / k * step / std::numbers::pi;
    for (const bool shear : {false, true}) {
      const State state =
          state_inside(body, Plane::strain, k, shear ? 0 : 1, shear ? 1 : 0, layer, to_real<Real100>(depth));
      const Real100 rotation = -(k * state[1] + state[2] / (2 * lame.mu)) / lame.compliance();
      for (std::size_t i = 0; i < places.size(); ++i) {
        // A shear traction -r cos(kx) is that of r sin(k (x - pi/(2k))).
        const double c = std::cos(k * places[i]), s = std::sin(k * places[i]);
        const double even = load * (shear ? r * s : c), odd = load * (shear ? -r * c : s);
        sums[i][0] += even * static_cast<double>(stress_xx(lame, k, state));
        sums[i][1] += even * static_cast<double>(state[3]);
        sums[i][2] += odd * static_cast<double>(state[2]);
        sums[i][3] += odd * static_cast<double>(rotation);
      }
    }
  }
  return sums;
}

}  // namespace

TEST_CASE("stresses under a uniform traction agree with a matrix exponential and a trapezoidal rule in k") {
  // On a rigid base stresses vanish exponentially, so that the midpoint rule is exact.
  const Body body = Body::layered({{0.9_r, lowest}, {0.3_r, stiff}}, std::nullopt);
  const double r = 0.7;
  PiecewiseTraction<double> traction{Elasticity(lowest)};
  traction.add({-1, 0}, {1, 0}, 2, -1, r);
  const LayerField field(pressed(body, {0}, one_piece(-1, 1, {0})),
                         {gathered_forces(traction, LayerField::longest_part(body))});
  const InteriorStress<double> half_plane(traction);
  const double c = static_cast<double>(Lame(lowest, Plane::strain).compliance());
  CHECK(field.layer_at(0.9) == 0);
  CHECK(field.layer_at(0.91) == 1);
  const std::vector<double> places{-1.7, 0.25};
  for (const auto& [layer, depth] : std::vector<std::pair<std::size_t, Rational>>{{0, 0.9_r}, {1, 0.2_r}}) {
    const std::vector<Numbers> truth = by_matrix_exponential(body, layer, depth, r, places);
    const double z = to_real<double>(layer == 0 ? depth : Rational(depth + 0.9_r));
    for (std::size_t i = 0; i < places.size(); ++i) {
      CAPTURE(places[i]);
      Numbers found{};
      if (layer == 0) {
        const StressState<double> part = half_plane.on_finest_mesh(places[i], z);
        found = {part.xx.value, part.zz.value, part.xz.value,
                 (part.gradient->z_x.value - part.gradient->x_z.value) / 2 / c};
      }
      const LayerField::Stress smooth = field.at(0, places[i], z);
      for (std::size_t j = 0; j < 4; ++j) CHECK(std::abs(found[j] + smooth[j].value - truth[i][j]) < 1e-6);
      CHECK(std::abs(smooth[0].value) > 0.01);
    }
  }
}

TEST_CASE("a layer of the base's own solid, and a thick layer, have the stresses of the half-plane") {
  const Indenter parabola = one_piece(-2, 2, {0, 0, 2});
  const ContactProblem problem =
      pressed(Body::layered({{0.3_r, lowest}, {0.4_r, lowest}}, lowest), {0.2_r, 0.6_r}, parabola);
  const ContactProblem thick =
      pressed(Body::layered({{Rational(100000), lowest}}, std::nullopt), {0.2_r, 0.6_r}, parabola);
  const auto solution = by_riemann_hilbert(problem);
  const auto on_thick = by_riemann_hilbert(thick);
  const InteriorStress<double> layered(problem, *solution), deep(thick, *on_thick), half_plane(*solution);
  for (const Rational& x : {-0.4_r, 0.1_r, 3_r}) {
    for (const Rational& z : {0.01_r, 0.3_r, 0.5_r, 2_r}) {
      const StressState<double> a = layered.at(x, z), b = half_plane.at(x, z), c = deep.at(x, z);
      for (const auto part : {&StressState<double>::xx, &StressState<double>::zz, &StressState<double>::xz}) {
        CHECK(std::abs((a.*part).value - (b.*part).value) < std::min(1e-10, (a.*part).error + (b.*part).error));
        CHECK(std::abs((c.*part).value - (b.*part).value) < 1e-4);
      }
      CHECK(std::abs(a.gradient->z_x.value - b.gradient->z_x.value) < 1e-10);
    }
  }
}

TEST_CASE("stresses in layers are in equilibrium, pass bonded interfaces, and stand on a rigid base") {
  const Body body = Body::layered({{0.3_r, polymer}, {0.2_r, stiff, Interface::slip}, {0.25_r, lowest}}, std::nullopt);
  const ContactProblem problem = pressed(body, {0.2_r, 0.7_r}, one_piece(-2, 2, {0, 0, 1}));
  const auto solution = by_riemann_hilbert(problem);
  const InteriorStress<double> stress(problem, *solution);
  const auto at = [&](double x, double z) { return stress.at(Rational(x), Rational(z)); };
  constexpr double step = 1e-3;
  const auto derivative = [](const Estimate<double>& before, const Estimate<double>& behind) {
    return (behind.value - before.value) / (2 * step);
  };
  for (const auto& [x, z] : {std::pair(-0.3, 0.1), {0.2, 0.25}, {-0.1, 0.4}, {0.5, 0.6}}) {
    const auto left = at(x - step, z), right = at(x + step, z), above = at(x, z - step), below = at(x, z + step);
    CHECK(std::abs(derivative(left.xx, right.xx) + derivative(above.xz, below.xz)) < 3e-4);
    CHECK(std::abs(derivative(left.xz, right.xz) + derivative(above.zz, below.zz)) < 3e-4);
    CHECK(std::abs(derivative(left.xx, right.xx)) > 1e-3);
  }
  constexpr double little = 1e-9;
  for (const double x : {-0.5, 0.05, 0.4}) {
    const auto above = at(x, 0.3), below = at(x, 0.3 + little);
    CHECK(std::abs(above.zz.value - below.zz.value) < 1e-7);
    CHECK(std::abs(above.xz.value - below.xz.value) < 1e-7);
    CHECK(std::abs(above.gradient->x_x.value - below.gradient->x_x.value) < 1e-7);
    CHECK(std::abs(above.gradient->z_x.value - below.gradient->z_x.value) < 1e-7);
    CHECK(std::abs(above.xx.value - below.xx.value) > 0.1);
    // The slipping interface has no shear, and the rigid base does not move.
    CHECK(std::abs(at(x, 0.5).xz.value) < 1e-9);
    CHECK(std::abs(at(x, 0.75).gradient->x_x.value) < 1e-9);
    CHECK(std::abs(at(x, 0.75).gradient->z_x.value) < 1e-9);
    CHECK(std::isnan(at(x, 0.8).zz.value));
  }
  CHECK(std::isnan(at(1e4, 0.1).zz.value));
}

TEST_CASE("stresses in layers tend to those at the surface, which contain the slope u_t'") {
  const Body body = Body::layered({{0.4_r, polymer}}, lowest);
  const ContactProblem problem = pressed(body, {0.2_r, 0.7_r}, one_piece(-2, 2, {0, 0, 1}));
  const auto cells = variational_inequality(problem, {.cells = 4096}).solution;
  REQUIRE(cells);
  const auto solution = by_riemann_hilbert(problem);
  const InteriorStress<double> stress(problem, *solution), on_cells(problem, *cells);
  for (const Rational& x : {-0.3_r, 0.2_r, 1.5_r, 3_r}) {
    CAPTURE(to_real<double>(x));
    const StressState<double> surface = surface_stress(problem.elasticity(), solution->details_at(x));
    const StressState<double> below = stress.at(x, Rational(1, 1000000000));
    const StressState<double> coarse = surface_stress(problem.elasticity(), cells->details_at(x));
    for (const auto part : {&StressState<double>::xx, &StressState<double>::zz, &StressState<double>::xz}) {
      CHECK(std::abs((surface.*part).value - (below.*part).value) < 1e-7);
      CHECK((surface.*part).error < 1e-6);
      CHECK(std::abs((surface.*part).value - (coarse.*part).value) <= (surface.*part).error + (coarse.*part).error);
      CHECK((coarse.*part).error < 1e-2);
      for (const Rational& z : {0.1_r, 0.4_r, 0.9_r}) {
        const Estimate<double> a = stress.at(x, z).*part, b = on_cells.at(x, z).*part;
        CHECK(std::abs(a.value - b.value) <= a.error + b.error);
        CHECK(b.error < 1e-3);
        CHECK(a.error < 1e-9);
      }
    }
    CHECK(std::abs(surface.gradient->z_x.value - below.gradient->z_x.value) < 1e-7);
  }
  // Control: the half-plane under this traction is stressed otherwise.
  CHECK(std::abs(InteriorStress<double>(*solution).at(0, 0.4_r).zz.value - stress.at(0, 0.4_r).zz.value) > 0.01);
}

TEST_CASE("the largest stresses of layers and their interfaces: Hertz's contact, and a fine grid") {
  // A quarter of the largest pressure, half of the contact's half-width below it [Joh85, section 4.2].
  const ContactProblem hertz = pressed(Body::layered({{1_r, lowest}}, lowest), {0}, one_piece(-9, 9, {0, 0, 0.1_r}));
  const double a = by_riemann_hilbert(hertz)->contact().front().right.x.value;
  const ContactProblem at_half = hertz.with_body(Body::layered({{Rational(a / 2), lowest}}, lowest));
  const auto pressure = by_riemann_hilbert(at_half);
  const auto coating = interface_stresses(InteriorStress<double>(at_half, *pressure));
  REQUIRE(coating.size() == 1);
  CHECK(coating[0].shear.value == doctest::Approx(pressure->largest_pressure().value.value / 4).epsilon(1e-10));
  CHECK(std::abs(coating[0].shear_x.value) == doctest::Approx(std::sqrt(0.75) * a).epsilon(1e-5));
  CHECK(coating[0].tension.value == 0);

  const Body body = Body::layered({{0.3_r, polymer}, {0.2_r, stiff}, {0.25_r, polymer}}, lowest);
  const ContactProblem problem = pressed(body, {0.2_r, 0.7_r}, one_piece(-2, 2, {0, 0, 1}));
  const auto solution = by_riemann_hilbert(problem);
  const InteriorStress<double> stress(problem, *solution);
  const std::vector<InterfaceStress> interfaces = interface_stresses(stress);
  const auto largest = largest_stress<double>(stress, 0.02);
  REQUIRE(interfaces.size() == 3);
  CHECK(interfaces[0].tension.value > 1e-3);
  double von_mises = 0;
  for (std::size_t n = 0; n < 3; ++n) {
    double shear = 0, tension = 0;
    for (double x = -6; x < 6; x += 0.005) {
      const StressState<double> above = stress.on_finest_mesh(x, interfaces[n].depth);
      von_mises = std::max({von_mises, above.von_mises()->value,
                            stress.on_finest_mesh(x, interfaces[n].depth + 1e-9).von_mises()->value});
      shear = std::max(shear, std::abs(above.xz.value));
      tension = std::max(tension, above.zz.value);
    }
    CHECK(interfaces[n].shear.value == doctest::Approx(shear).epsilon(1e-3));
    CHECK(interfaces[n].shear.value >= shear);
    CHECK(interfaces[n].tension.value == doctest::Approx(tension).epsilon(1e-3));
    CHECK(interfaces[n].tension.value >= tension);
    const StressState<double> there = stress.at(Rational(interfaces[n].shear_x.value), Rational(interfaces[n].depth));
    CHECK(std::abs(there.xz.value) == doctest::Approx(interfaces[n].shear.value).epsilon(1e-10));
  }
  // The stiff layer has the largest stress, at an interface.
  CHECK(largest->von_mises.value == doctest::Approx(von_mises).epsilon(1e-3));
  CHECK(largest->von_mises.value >= von_mises);
  CHECK((largest->z.value - 0.3) * (largest->z.value - 0.5) == doctest::Approx(0).epsilon(1e-6));
}

TEST_CASE("errors of stresses cover the difference to the same layer, divided in two") {
  for (const Rational& h : {0.5_r, 0.25_r}) {
    const auto divided = [&](const Rational& part) {
      std::vector<Layer> layers{{part * h, polymer}};
      if (part < 1) layers.push_back({(1 - part) * h, polymer});
      return pressed(Body::layered(layers, lowest), {0.2_r, 0.7_r}, one_piece(-2, 2, {0, 0, 1}));
    };
    const ContactProblem one = divided(1), two = divided(0.7_r);
    const InteriorStress<double> whole(one, *by_riemann_hilbert(one)), parts(two, *by_riemann_hilbert(two));
    for (const Rational& x : {-3_r, -0.5_r, 0.05_r, 1_r}) {
      for (const Rational& z : {0.01_r, 0.8_r, 1_r, 1.5_r}) {
        const StressState<double> a = whole.at(x, z * h), b = parts.at(x, z * h);
        for (const auto part : {&StressState<double>::xx, &StressState<double>::zz, &StressState<double>::xz}) {
          CHECK(std::abs((a.*part).value - (b.*part).value) <= (a.*part).error + (b.*part).error);
          CHECK((a.*part).error < 1e-7);
        }
      }
    }
  }
}
