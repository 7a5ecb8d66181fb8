#include "numeric/layers/layer_stress.hpp"

#include <stdexcept>

namespace steadyslide::numeric {

template <Real R>
LayerStress<R>::LayerStress(const BodySymbols<R>& symbols, const R& k) : k_(k) {
  if (symbols.layers().empty() || !(k > 0)) throw std::invalid_argument("stresses of layers: layers, k > 0");
  const std::vector<HeldSide<R>> sides = symbols.held_sides(k);
  const Matrix2<R> one{R(1), R(0), R(0), R(1)};
  Matrix2<R> traction{R(1), R(0), R(0), R(-1)};  // on the upper side, as (p, q) of layer_matrices.hpp
  for (std::size_t n = 0; n < sides.size(); ++n) {
    const auto& layer = symbols.layers()[n];
    Field field{layer.gamma, layer.rest, k * layer.thickness, {}, {}, sides[n], {}};
    if (field.xi > 1) {
      const Matrix2<R> lower = reflection(layer.gamma, sides[n]);
      const Matrix2<R> returned = rising(field.xi) * lower * falling(field.xi);
      const Matrix2<R> arrived = (one + returned).inverse();
      field.down = arrived * traction;
      if (n == 0) down_defect_ = R(-1) * (arrived * returned * traction);
      const Matrix2<R> arriving = falling(field.xi) * field.down;
      field.up = lower * arriving;
      traction = arriving + field.up;
    } else {
      field.held_by = raised(layer.gamma, layer.rest, field.xi, sides[n]).tractions.inverse() * traction;
      traction = sides[n].tractions * field.held_by;
    }
    fields_.push_back(field);
  }
  if (!symbols.base_gamma()) return;
  // The half-plane has no lower side.
  fields_.push_back({*symbols.base_gamma(), 1 - *symbols.base_gamma(), infinity<R>(), traction, {}, {}, {}});
}

template <Real R>
WaveStresses<R> LayerStress<R>::stresses(const Field& field, const Matrix2<R>& displacement,
                                         const Matrix2<R>& traction) {
  // q' = -2 v - (1 - 2 gamma) p balances sigma_xx, and u_z = (c/k) w cos(kx).
  const auto of = [&](const R& w, const R& v, const R& p, const R& q) {
    return WaveStress<R>{-2 * v - (1 - 2 * field.gamma) * p, -p, q, -w - field.rest * q};
  };
  const auto& [w, w_of_shear, v, v_of_shear] = displacement;
  const auto& [p, p_of_shear, q, q_of_shear] = traction;
  return {of(w, v, p, q), of(w_of_shear, v_of_shear, p_of_shear, q_of_shear)};
}

template <Real R>
WaveStresses<R> LayerStress<R>::at(std::size_t layer, const R& depth) const {
  const Field& field = fields_.at(layer);
  const R zeta = k_ * depth;
  if (field.xi > 1) {
    const Matrix2<R> down = falling(zeta) * field.down;
    const Matrix2<R> up = isinf(field.xi) ? Matrix2<R>{} : rising(R(field.xi - zeta)) * field.up;
    return stresses(field, half_plane_compliance(field.gamma) * down - half_plane_compliance(R(-field.gamma)) * up,
                    down + up);
  }
  const HeldSide<R> here = raised(field.gamma, field.rest, R(field.xi - zeta), field.held);
  return stresses(field, here.displacements * field.held_by, here.tractions * field.held_by);
}

template <Real R>
WaveStresses<R> LayerStress<R>::defects_at(const R& depth) const {
  const Field& field = fields_.front();
  const R zeta = k_ * depth;
  if (field.xi > 1) {
    const Matrix2<R> down = falling(zeta) * down_defect_, up = rising(R(field.xi - zeta)) * field.up;
    return stresses(field, half_plane_compliance(field.gamma) * down - half_plane_compliance(R(-field.gamma)) * up,
                    down + up);
  }
  const HeldSide<R> here = raised(field.gamma, field.rest, R(field.xi - zeta), field.held);
  const Matrix2<R> down = falling(zeta) * Matrix2<R>{R(1), R(0), R(0), R(-1)};
  return stresses(field, here.displacements * field.held_by - half_plane_compliance(field.gamma) * down,
                  here.tractions * field.held_by - down);
}

STEADYSLIDE_INSTANTIATE_CLASS(LayerStress)

}  // namespace steadyslide::numeric
