#include "numeric/layers/body_symbols.hpp"

#include <stdexcept>

namespace steadyslide::numeric {

template <Real R>
BodySymbols<R>::BodySymbols(const Elasticity& elasticity, const Body& body) : gamma_(to_real<R>(elasticity.gamma())) {
  if (body.period()) throw std::invalid_argument("a periodic contact has no symbols of its own");
  if (body.symbols()) {
    const std::vector<SymbolRow>& rows = *body.symbols();
    const Rational growth = rows[1].normal / rows[0].normal;
    absolute_ = growth * growth * rows[0].wave_number > rows[1].wave_number;
    std::vector<R> normal{absolute_ ? R(0) : to_real<R>(rows[0].normal)};
    std::vector<R> coupling{absolute_ ? R(0) : to_real<R>(rows[0].coupling)};
    given_.push_back(R(0));
    for (const SymbolRow& row : rows) {
      given_.push_back(to_real<R>(row.wave_number));
      normal.push_back(to_real<R>(row.normal));
      coupling.push_back(to_real<R>(row.coupling));
    }
    given_normal_.emplace(given_, std::move(normal));
    given_coupling_.emplace(given_, std::move(coupling));
    last_ = given_.back();
    return;
  }
  if (body.layers().empty()) return;
  if (!elasticity.half_space()) throw std::invalid_argument("layers need the solid of the surface");
  const Plane plane = elasticity.plane();
  const auto compliance = [&](const Solid& solid) { return Elasticity(solid, plane).compliance(); };
  for (std::size_t n = 0; n < body.layers().size(); ++n) {
    const auto& [thickness, solid, below] = body.layers()[n];
    const Rational kappa = solid.kolosov(plane);
    const Solid* under = n + 1 < body.layers().size() ? &body.layers()[n + 1].solid : nullptr;
    if (!under && body.base()) under = &*body.base();
    layers_.push_back({to_real<R>(thickness), to_real<R>((kappa - 1) / (kappa + 1)), to_real<R>(2 / (kappa + 1)),
                       under ? to_real<R>(compliance(*under) / compliance(solid)) : R(0), below == Interface::bonded});
  }
  if (body.base()) base_gamma_ = to_real<R>(Elasticity(*body.base(), plane).gamma());
  absolute_ = !body.base();
  // exp(-2 k h) (k h)^2 is small against epsilon there.
  last_ = (12 - log(epsilon<R>())) / (2 * layers_[0].thickness);
}

template <Real R>
SymbolValues<R> BodySymbols<R>::at(const R& k) const {
  if (given_normal_ && k < last_) {
    const R normal = given_normal_->at(k);
    const R coupling = given_coupling_->at(k);
    return {normal, coupling, 1 - normal, gamma_ - coupling};
  }
  if (layers_.empty() || given_normal_) return {R(1), gamma_, R(0), R(0)};
  const HeldSide<R> below = held_sides(k)[0];
  const Layer& layer = layers_[0];
  const R xi = k * layer.thickness;
  if (xi > 1) {
    const Matrix2<R> defect = thick_layer_defect(layer.gamma, xi, below);
    return {1 - defect.a, gamma_ - defect.b, defect.a, defect.b};
  }
  const Matrix2<R> compliance = raised(layer.gamma, layer.rest, xi, below).compliance();
  return {compliance.a, compliance.b, 1 - compliance.a, gamma_ - compliance.b};
}

template <Real R>
std::vector<HeldSide<R>> BodySymbols<R>::held_sides(const R& k) const {
  std::vector<HeldSide<R>> result(layers_.size());
  Matrix2<R> compliance{};  // of what lies below, in units of its own c/k
  if (base_gamma_) compliance = half_plane_compliance(*base_gamma_);
  for (std::size_t n = layers_.size(); n-- > 0;) {
    const Layer& layer = layers_[n];
    const R xi = k * layer.thickness;
    result[n] = held_by(layer.below_to_c * compliance, layer.bonded);
    if (n == 0) break;
    compliance = xi > 1 ? half_plane_compliance(layer.gamma) - thick_layer_defect(layer.gamma, xi, result[n])
                        : raised(layer.gamma, layer.rest, xi, result[n]).compliance();
  }
  return result;
}

STEADYSLIDE_INSTANTIATE_CLASS(BodySymbols)

}  // namespace steadyslide::numeric
