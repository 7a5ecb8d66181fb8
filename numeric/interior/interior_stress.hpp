#pragma once
// The stresses and the displacement gradient below the surface, at (x, z) with depth z > 0, under the traction t of a
// solution (of any method) and t_t = -f t (f t for sliding towards -x). This is the field of half_plane_stress.hpp,
//
//   (sigma_xx, sigma_zz, sigma_xz) = (2/pi) int_K t(x') (s - r c)/d (c^2, s^2, c s) dx',
//   d^2 = (x-x')^2 + z^2,  c = (x-x')/d,  s = z/d,  r = t_t/t on each piece of the friction,
//
// and with Hooke's law and W of force_sums.hpp, mu the half-space's shear modulus, kappa Kolosov's constant [Mus63],
//
//   2 mu d u_x/dx = sigma_xx - (3-kappa)/4 (sigma_xx + sigma_zz),   2 mu d u_z/dz alike,
//   2 mu d u_z/dx = sigma_xz + (kappa+1)/2 W,                       2 mu d u_x/dz = sigma_xz - (kappa+1)/2 W.
//
// As z -> 0 at a point of contact: sigma_zz -> t, sigma_xz -> -t_t = -r t, and with u_t'/c = H t_t + gamma t
// [Bal16, (2)] sigma_xx -> t + 2 H t_t = (1 - 2 gamma) t + 2 u_t'/c; if one ratio r holds in the whole contact, this is
// t + 2 r (u'/c + gamma r t). d u_z/dx -> -u', the displacement u of contact problems pointing along -z, and d
// u_x/dx -> u_t', where the indenter is rigid. Outside the contact sigma_zz and sigma_xz -> 0.
//
// The sums over the contact and their errors are those of body_sums.hpp. On cells the errors are those that coarser
// meshes show. In the first layer of a layered body the smooth stresses of layer_field.hpp are added. Below it these are
// the stresses. An interface belongs to the layer above it. Each layer has its own Hooke's law. In periodic contact the
// stresses are sums over three periods, and those of periodic_images.hpp.

#include "numeric/interior/body_sums.hpp"
#include "numeric/interior/hookes_law.hpp"
#include "numeric/interior/stress_field.hpp"
#include "numeric/layers/layer_field.hpp"
#include "numeric/periodic/periodic_images.hpp"
#include "numeric/solution/contact_solution.hpp"

namespace steadyslide::numeric {

template <Real R>
class InteriorStress : public StressField<R> {
 public:
  /// The half-plane under the traction of a solution.
  explicit InteriorStress(const ContactSolution<R>& solution) : InteriorStress(solution.piecewise_traction()) {}
  explicit InteriorStress(PiecewiseTraction<R> traction);
  /// The body of the problem. Throws std::invalid_argument if it has given symbols. What layers and periods add is computed
  /// in double.
  InteriorStress(const ContactProblem& problem, const ContactSolution<R>& solution);

  const PiecewiseTraction<R>& traction() const override { return meshes_.front().traction(); }

  /// True if R can represent the square of the depth with all digits.
  static bool reaches(const R& z) { return z * z >= std::numeric_limits<R>::min(); }
  /// Return NaN with infinite errors if reaches(z) is false. Throw std::invalid_argument unless z > 0.
  StressState<R> at(const Rational& x, const Rational& z) const;
  /// Computes the stresses at many points. The spans have the same length.
  void at(std::span<const R> x, std::span<const R> z, std::span<StressState<R>> states) const override;
  StressState<R> on_finest_mesh(const R& x, const R& z) const override;
  std::vector<double> interfaces() const override { return layers_ ? layers_->interfaces() : std::vector<double>(); }

 private:
  using Mesh = BodySums<R, StressKernel<R>>;
  static constexpr const char* below = "the depth of a point below the surface is positive";
  StressState<R> at(const SurfacePlace<R>& x, const R& z, std::span<const Mesh> meshes, TractionNodes<R>& nodes) const;

  std::vector<HookesLaw<R>> laws_;  ///< of each layer, and of an elastic base
  std::vector<Mesh> meshes_;        ///< the finest first
  std::shared_ptr<const LayerField> layers_;
  std::shared_ptr<const PeriodicImages> images_;
};

}  // namespace steadyslide::numeric
