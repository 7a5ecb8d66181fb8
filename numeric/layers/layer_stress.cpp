#include "numeric/layers/layer_stress.hpp"

#include <stdexcept>

namespace steadyslide::numeric {

template <Real R>
LayerStress<R>::LayerStress(const BodySymbols<R>& symbols, const R& k, const R& pressure, const R& shear) : k_(k) {
  if (symbols.layers().empty() || !(k > 0)) throw std::invalid_argument("stresses of layers: layers, k > 0");
  const std::vector<HeldSide<R>> sides = symbols.held_sides(k);
  const Matrix2<R> one{R(1), R(0), R(0), R(1)};
  Vector traction{pressure, -shear};  // on the upper side, as (p, q) of layer_matrices.hpp
  for (std::size_t n = 0; n < sides.size(); ++n) {
    const auto& layer = symbols.layers()[n];
    Field field{layer.gamma, layer.rest, k * layer.thickness, {}, {}, sides[n], {}};
    if (field.xi > 1) {
      const Matrix2<R> lower = reflection(layer.gamma, sides[n]);
      field.down = product((one + rising(field.xi) * lower * falling(field.xi)).inverse(), traction);
      const Vector arriving = product(falling(field.xi), field.down);
      field.up = product(lower, arriving);
      traction = {arriving.first + field.up.first, arriving.second + field.up.second};
    } else {
      field.held_by = product(raised(layer.gamma, layer.rest, field.xi, sides[n]).tractions.inverse(), traction);
      traction = product(sides[n].tractions, field.held_by);
    }
    fields_.push_back(field);
  }
  if (!symbols.base_gamma()) return;
  // The half-plane has no lower side.
  fields_.push_back({*symbols.base_gamma(), 1 - *symbols.base_gamma(), infinity<R>(), traction, {}, {}, {}});
}

template <Real R>
WaveStress<R> LayerStress<R>::at(std::size_t layer, const R& depth) const {
  const Field& field = fields_.at(layer);
  const R zeta = k_ * depth;
  Vector traction;
  R v = 0;
  if (field.xi > 1) {
    const Vector down = product(falling(zeta), field.down);
    const Vector up = isinf(field.xi) ? Vector{} : product(rising(R(field.xi - zeta)), field.up);
    traction = {down.first + up.first, down.second + up.second};
    v = field.gamma * (down.first + up.first) + down.second - up.second;
  } else {
    const HeldSide<R> here = raised(field.gamma, field.rest, R(field.xi - zeta), field.held);
    traction = product(here.tractions, field.held_by);
    v = product(here.displacements, field.held_by).second;
  }
  // q' = -2 v - (1 - 2 gamma) p balances sigma_xx.
  return {-2 * v - (1 - 2 * field.gamma) * traction.first, -traction.first, traction.second};
}

STEADYSLIDE_INSTANTIATE_CLASS(LayerStress)

}  // namespace steadyslide::numeric
