#pragma once
// The surface symbols of a body that looks the same from every place of its surface, relative to the half-plane of the
// surface's solid. A pressure p cos(kx), k > 0, and a shear traction q sin(kx) displace the surface downwards by
//
//   u_z = (c/k) (W p - gamma V q) cos(kx),   W = V = 1 on the half-plane.
//
// Each layer maps the compliance of what lies below to the compliance of its own surface. Thin layers (k h <= 1) use
// the transfer matrix of displacements and tractions, and the entries that are small for small k h come from series.
// Thick layers use the part of the traction that returns from below, which contains exp(-2 k h) and no growing
// exponential. The compliance stays positive definite, and such maps do not enlarge its relative errors: W loses no
// digit for small or large k h, and at most two digits if moduli of layers differ by factors up to 10^8 (measured on
// random stacks).

#include <optional>
#include <vector>

#include "model/contact_problem.hpp"
#include "numeric/layers/layer_matrices.hpp"
#include "numeric/layers/monotone_cubic.hpp"
#include "numeric/number/real.hpp"

namespace steadyslide::numeric {

template <Real R>
struct SymbolValues {
  R normal;           ///< W > 0
  R coupling;         ///< gamma V
  R normal_defect;    ///< 1 - W, with full relative precision where it is small because k h is large
  R coupling_defect;  ///< gamma - gamma V, likewise
};

template <Real R>
class BodySymbols {
 public:
  /// Throws std::invalid_argument if the body is periodic, or if it has layers and the elasticity is reduced.
  BodySymbols(const Elasticity& elasticity, const Body& body);
  explicit BodySymbols(const ContactProblem& problem) : BodySymbols(problem.elasticity(), problem.body()) {}

  /// Takes k > 0. Given symbols are interpolated by monotone cubics. Below the first row, W tends to 0 like k if the
  /// first two rows rise faster than sqrt(k), and gamma V to 0. Otherwise both are constant there.
  SymbolValues<R> at(const R& k) const;
  /// Returns W.
  R normal(const R& k) const { return at(k).normal; }
  /// Returns gamma V.
  R coupling(const R& k) const { return at(k).coupling; }

  const R& gamma() const { return gamma_; }
  /// True if W tends to 0 like k for small k: the displacement is absolute. So it is on a rigid base.
  bool has_absolute_displacement() const { return absolute_; }
  /// Returns a wave number from which on 1 - W and gamma - gamma V are 0 to the last digit of the type; 0 for the
  /// half-plane.
  const R& last_wave_number() const { return last_; }
  /// Returns the wave numbers of the given symbols, between which alone they are smooth; empty for layers.
  const std::vector<R>& given_wave_numbers() const { return given_; }

  struct Layer {
    R thickness;
    R gamma;
    R rest;        ///< 1 - gamma
    R below_to_c;  ///< the compliance c of the solid below over that of the layer
    bool bonded;
  };
  /// Returns the layers from the surface down; empty for the half-plane and for given symbols.
  const std::vector<Layer>& layers() const { return layers_; }
  /// Returns gamma of the base; absent: it is rigid, or there are no layers.
  const std::optional<R>& base_gamma() const { return base_gamma_; }
  /// Returns the lower side of each layer, in units of its own c/k.
  std::vector<HeldSide<R>> held_sides(const R& k) const;

 private:
  R gamma_;
  std::vector<Layer> layers_;    ///< from the surface down
  std::optional<R> base_gamma_;  ///< absent: rigid
  std::optional<MonotoneCubic<R>> given_normal_;
  std::optional<MonotoneCubic<R>> given_coupling_;
  std::vector<R> given_;
  bool absolute_ = false;
  R last_ = 0;
};

}  // namespace steadyslide::numeric
