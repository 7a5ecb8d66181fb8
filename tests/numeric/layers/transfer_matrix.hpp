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

/// Returns the state at a height h above the given one in the same solid.
inline State raised(const Lame& solid, const Real100& k, const Real100& h, State state) {
  const auto& [l, m] = solid;
  const Real100 n = l + 2 * m;
  const StateMatrix rate{{{Real100(0), k, 1 / m, Real100(0)},
                          {-k * l / n, Real100(0), Real100(0), 1 / n},
                          {k * k * (n - l * l / n), Real100(0), Real100(0), k * l / n},
                          {Real100(0), Real100(0), -k, Real100(0)}}};
  const int steps = 4 + static_cast<int>(8 * std::abs(static_cast<double>(k * h)));
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

/// Returns a state without shear and u_x, in proportion to what two states admit.
inline State without_shear(const std::array<State, 2>& states) {
  const std::size_t pivot = size_of(states[0][2]) > size_of(states[1][2]) ? 0 : 1;
  return combined(states[1 - pivot], -states[1 - pivot][2] / states[pivot][2], states[pivot]);
}

/// Returns the two states at the upper side of a layer, or of the base, that the body below admits.
inline std::array<State, 2> states_at(std::size_t first, const Body& body, Plane plane, const Real100& k) {
  std::array<State, 2> states{
      {{Real100(0), Real100(0), Real100(1), Real100(0)}, {Real100(0), Real100(0), Real100(0), Real100(1)}}};
  if (body.base()) {
    // The gradient of exp(-kz) cos(kx), and ((kappa + 1) B e_z - grad(z B))/(2 mu) with B = exp(-kz) cos(kx).
    const Lame base(*body.base(), plane);
    const Real100 kappa = (base.lambda + 3 * base.mu) / (base.lambda + base.mu);
    states[0] = {-k, -k, 2 * base.mu * k * k, 2 * base.mu * k * k};
    states[1] = {Real100(0), kappa / (2 * base.mu), -(kappa - 1) * k / 2, -(kappa + 1) * k / 2};
  }
  for (std::size_t n = body.layers().size(); n-- > first;) {
    const Layer& layer = body.layers()[n];
    if (layer.below == Interface::slip) {
      // No shear below, and any u_x above.
      State held = without_shear(states);
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
  const auto [u, v] = states_at(0, body, plane, k);
  const Real100 determinant = u[2] * v[3] - u[3] * v[2];
  const auto displacement = [&, &u = u, &v = v](const Real100& xz, const Real100& zz) {
    return (xz * (v[3] * u[1] - u[3] * v[1]) + zz * (u[2] * v[1] - v[2] * u[1])) / determinant;
  };
  const Real100 unit = k / Lame(body.layers()[0].solid, plane).compliance();
  return {unit * displacement(Real100(0), Real100(-1)), unit * displacement(Real100(1), Real100(0))};
}

/// Returns the state at a depth in a layer or in the base, under a pressure P cos(kx) and a shear traction Q sin(kx).
inline State state_inside(const Body& body, Plane plane, const Real100& k, const Real100& pressure,
                          const Real100& shear, std::size_t layer, const Real100& depth) {
  const auto [u, v] = states_at(0, body, plane, k);
  const Real100 determinant = u[2] * v[3] - u[3] * v[2];
  State state{};
  state = combined(state, (-shear * v[3] + pressure * v[2]) / determinant, u);
  state = combined(state, (-pressure * u[2] + shear * u[3]) / determinant, v);
  for (std::size_t n = 0; n < layer; ++n) {
    const Layer& above = body.layers()[n];
    state = raised(Lame(above.solid, plane), k, -to_real<Real100>(above.thickness), state);
    if (above.below == Interface::bonded) continue;
    const State held = without_shear(states_at(n + 1, body, plane, k));
    state = combined(State{}, state[3] / held[3], held);
  }
  const Solid& solid = layer < body.layers().size() ? body.layers()[layer].solid : *body.base();
  return raised(Lame(solid, plane), k, -depth, state);
}

/// Returns sigma_xx/cos(kx) of a state.
inline Real100 stress_xx(const Lame& solid, const Real100& k, const State& state) {
  const Real100 n = solid.lambda + 2 * solid.mu;
  return (n - solid.lambda * solid.lambda / n) * k * state[0] + solid.lambda / n * state[3];
}

}  // namespace steadyslide::testing
