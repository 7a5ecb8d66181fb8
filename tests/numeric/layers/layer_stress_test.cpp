#include "numeric/layers/layer_stress.hpp"

#include "transfer_matrix.hpp"

namespace {

/// Stresses under a pressure and a shear traction.
template <Real R>
struct Loaded {
  LayerStress<R> stress;
  R pressure, shear;

  WaveStress<R> at(std::size_t layer, const R& depth) const {
    const auto& [p, q] = stress.at(layer, depth);
    const auto sum = [this](const R& a, const R& b) { return R(pressure * a + shear * b); };
    return {sum(p.xx, q.xx), sum(p.zz, q.zz), sum(p.xz, q.xz), sum(p.rotation, q.rotation)};
  }
};

template <Real R>
Loaded<R> stress_of(const Body& body, Plane plane, const R& k, const R& pressure, const R& shear) {
  return {{BodySymbols<R>(Elasticity(body.layers()[0].solid, plane), body), k}, pressure, shear};
}

/// Returns the largest difference of stresses, in units of the largest stress.
template <Real R>
double stress_error(const WaveStress<R>& found, const State& truth, const Real100& xx, const Real100& rotation) {
  const Real100 size = size_of(xx) + size_of(truth[2]) + size_of(truth[3]) + size_of(rotation);
  const Real100 off = size_of(Real100(found.xx - xx)) + size_of(Real100(found.zz - truth[3])) +
                      size_of(Real100(found.xz - truth[2])) + size_of(Real100(found.rotation - rotation));
  return static_cast<double>(off / size);
}

}  // namespace

TEST_CASE("a layer of the base's own solid has the stresses of the half-plane") {
  const Solid solid(0.3_r, 7_r);
  const Body body = Body::layered({{0.5_r, solid}}, solid);
  for (const double k : {0.2, 1.9, 2.1, 30.0}) {
    for (const double depth : {0.0, 0.1, 0.5, 0.9}) {
      const std::size_t layer = depth <= 0.5 ? 0 : 1;
      const double z = k * depth;
      const double fall = std::exp(-z);
      const auto pressed = stress_of(body, Plane::strain, k, 1.0, 0.0).at(layer, depth - (layer == 0 ? 0 : 0.5));
      CHECK(std::abs(pressed.zz + (1 + z) * fall) < 1e-14);
      CHECK(std::abs(pressed.xz + z * fall) < 1e-14);
      CHECK(std::abs(pressed.xx + (1 - z) * fall) < 1e-14);
      const auto sheared = stress_of(body, Plane::strain, k, 0.0, 1.0).at(layer, depth - (layer == 0 ? 0 : 0.5));
      CHECK(std::abs(sheared.zz - z * fall) < 1e-14);
      CHECK(std::abs(sheared.xz + (1 - z) * fall) < 1e-14);
      CHECK(std::abs(sheared.xx - (2 - z) * fall) < 1e-14);
    }
  }
}

TEST_CASE("stresses in layers, on both sides of interfaces and in the base agree with the matrix exponential") {
  const Solid coating(0.25_r, 400_r), foam(0.49_r, 0.5_r), base(0.3_r, 200_r);
  for (const Body& body :
       {Body::layered({{0.5_r, foam}}, std::nullopt), Body::layered({{0.5_r, coating, Interface::slip}}, std::nullopt),
        Body::layered({{0.02_r, coating}, {1_r, foam, Interface::slip}, {0.3_r, coating}}, base)}) {
    for (const Plane plane : {Plane::strain, Plane::stress}) {
      for (const double k : {0.01, 0.9, 3.0, 9.0}) {
        for (const auto& [pressure, shear] : {std::pair(1.0, 0.0), {0.0, 1.0}}) {
          const auto in_double = stress_of<double>(body, plane, k, pressure, shear);
          const auto in_50 = stress_of<Real50>(body, plane, k, pressure, shear);
          const std::size_t count = body.layers().size();
          for (std::size_t layer = 0; layer < count + (body.base() ? 1 : 0); ++layer) {
            const Solid& solid = layer < count ? body.layers()[layer].solid : *body.base();
            const Rational thickness = layer < count ? body.layers()[layer].thickness : 1_r;
            for (const Rational& part : {0_r, 0.3_r, 1_r}) {
              CAPTURE(k);
              CAPTURE(layer);
              const Rational depth = part * thickness;
              const State truth = state_inside(body, plane, k, pressure, shear, layer, to_real<Real100>(depth));
              const Real100 xx = stress_xx(Lame(solid, plane), k, truth);
              // d u_x/dz = sigma_xz/mu - d u_z/dx
              const Lame lame(solid, plane);
              const Real100 rotation = -(k * truth[1] + truth[2] / (2 * lame.mu)) / lame.compliance();
              CHECK(stress_error(in_double.at(layer, to_real<double>(depth)), truth, xx, rotation) < 1e-12);
              CHECK(stress_error(in_50.at(layer, to_real<Real50>(depth)), truth, xx, rotation) < 1e-50);
            }
          }
        }
      }
    }
  }
}

TEST_CASE("stresses: a slipping interface has no shear, a bonded one passes both, refusals") {
  const Solid hard(0.3_r, 100_r), soft(0.4_r, 1_r);
  const Body body = Body::layered({{0.2_r, hard}, {0.3_r, soft, Interface::slip}}, hard);
  const auto stress = stress_of(body, Plane::strain, 4.0, 1.0, 0.5);
  CHECK(std::abs(stress.at(0, 0).xz + 0.5) < 1e-14);
  CHECK(std::abs(stress.at(0, 0).zz + 1) < 1e-14);
  CHECK(std::abs(stress.at(0, 0.2).xz - stress.at(1, 0).xz) < 1e-14);
  CHECK(std::abs(stress.at(0, 0.2).xx - stress.at(1, 0).xx) > 0.1);
  CHECK(std::abs(stress.at(1, 0.3).xz) < 1e-14);
  CHECK(std::abs(stress.at(2, 0).xz) < 1e-14);
  CHECK(std::abs(stress.at(1, 0.3).zz - stress.at(2, 0).zz) < 1e-14);
  CHECK(std::abs(stress.at(2, 100).zz) < 1e-100);
  CHECK_THROWS_AS(stress.at(3, 0), std::out_of_range);
  CHECK_THROWS_AS(LayerStress<double>(BodySymbols<double>(Elasticity(hard), Body{}), 1.0), std::invalid_argument);
}
