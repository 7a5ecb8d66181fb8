#pragma once
// The surface symbols of a layered body by another formulation: the matrix exponential of displacements and stresses
// through each layer, Lame's constants, and potentials in the base. Growing exponentials lose about exp(2 k h) digits,
// so it needs many of them.

#include <array>

#include "model/body.hpp"
#include "support/numeric_test.hpp"

namespace steadyslide::testing {

/// u_x/sin(kx), u_z/cos(kx), sigma_xz/sin(kx), sigma_zz/cos(kx); z points downwards.
using State = std::array<Real100, 4>;
using StateMatrix = std::array<State, 4>;

inline State product(const StateMatrix& matrix, const State& state) {
  State result{};
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) result[i] += matrix[i][j] * state[j];
  }
  return result;
}

struct Lame {
  Real100 lambda;
  Real100 mu;
  Lame(const Solid& solid, Plane plane) : mu(to_real<Real100>(solid.shear_modulus())) {
    const Rational nu = solid.poisson();
    const Rational three = solid.young() * nu / ((1 + nu) * (1 - 2 * nu));
    const Rational m = solid.shear_modulus();
    lambda = to_real<Real100>(plane == Plane::strain ? three : Rational(2 * m * three / (three + 2 * m)));
  }
  /// c = (lambda + 2 mu)/(2 mu (lambda + mu)).
  Real100 compliance() const { return (lambda + 2 * mu) / (2 * mu * (lambda + mu)); }
};

/// Returns the state at the upper side of a layer.
inline State raised(const Lame& solid, const Real100& k, const Real100& h, State state) {
  const auto& [l, m] = solid;
  const Real100 n = l + 2 * m;
  const StateMatrix rate{{{Real100(0), k, 1 / m, Real100(0)},
                          {-k * l / n, Real100(0), Real100(0), 1 / n},
                          {k * k * (n - l * l / n), Real100(0), Real100(0), k * l / n},
                          {Real100(0), Real100(0), -k, Real100(0)}}};
  const int steps = 4 + static_cast<int>(8 * static_cast<double>(k * h));
  const Real100 step = -h / steps;
  for (int n_step = 0; n_step < steps; ++n_step) {
    State term = state;
    for (int order = 1; order < 90; ++order) {
      term = product(rate, term);
      for (std::size_t i = 0; i < 4; ++i) {
        term[i] *= step / order;
        state[i] += term[i];
      }
    }
  }
  return state;
}

/// Returns u + factor v.
inline State combined(const State& u, const Real100& factor, const State& v) {
  State result = u;
  for (std::size_t i = 0; i < 4; ++i) result[i] += factor * v[i];
  return result;
}

/// Returns the two states at the surface that the base admits.
inline std::array<State, 2> surface_states(const Body& body, Plane plane, const Real100& k) {
  std::array<State, 2> states{
      {{Real100(0), Real100(0), Real100(1), Real100(0)}, {Real100(0), Real100(0), Real100(0), Real100(1)}}};
  if (body.base()) {
    // The gradient of exp(-kz) cos(kx), and ((kappa + 1) B e_z - grad(z B))/(2 mu) with B = exp(-kz) cos(kx).
    const Lame base(*body.base(), plane);
    const Real100 kappa = (base.lambda + 3 * base.mu) / (base.lambda + base.mu);
    states[0] = {-k, -k, 2 * base.mu * k * k, 2 * base.mu * k * k};
    states[1] = {Real100(0), kappa / (2 * base.mu), -(kappa - 1) * k / 2, -(kappa + 1) * k / 2};
  }
  for (std::size_t n = body.layers().size(); n-- > 0;) {
    const Layer& layer = body.layers()[n];
    if (layer.below == Interface::slip) {
      // No shear below, and any u_x above.
      const std::size_t pivot = size_of(states[0][2]) > size_of(states[1][2]) ? 0 : 1;
      State held = combined(states[1 - pivot], -states[1 - pivot][2] / states[pivot][2], states[pivot]);
      held[0] = 0;
      held[2] = 0;
      states = {held, State{Real100(1), Real100(0), Real100(0), Real100(0)}};
    }
    for (State& state : states) {
      state = raised(Lame(layer.solid, plane), k, to_real<Real100>(layer.thickness), state);
    }
  }
  return states;
}

struct TransferSymbols {
  Real100 normal;
  Real100 coupling;
};

/// Returns W and gamma V: u_z = (c/k) (W p - gamma V q), p = -sigma_zz, q = -sigma_xz.
inline TransferSymbols by_transfer_matrix(const Body& body, Plane plane, const Real100& k) {
  const auto [u, v] = surface_states(body, plane, k);
  const Real100 determinant = u[2] * v[3] - u[3] * v[2];
  const auto displacement = [&](const Real100& xz, const Real100& zz) {
    return (xz * (v[3] * u[1] - u[3] * v[1]) + zz * (u[2] * v[1] - v[2] * u[1])) / determinant;
  };
  const Real100 unit = k / Lame(body.layers()[0].solid, plane).compliance();
  return {unit * displacement(Real100(0), Real100(-1)), unit * displacement(Real100(1), Real100(0))};
}

}  // namespace steadyslide::testing
