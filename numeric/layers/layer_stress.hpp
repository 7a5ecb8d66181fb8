#pragma once
// Stresses in a layered body under surface tractions of one wave number, the transfer functions of stresses: under a
// pressure cos(kx), or a shear traction sin(kx) towards +x,
//
//   sigma_xx = xx cos(kx),   sigma_zz = zz cos(kx),   sigma_xz = xz sin(kx),   W = rotation sin(kx),   z downwards,
//
// with W = (d u_z/dx - d u_x/dz)/(2 c), c of the layer, as in numeric/interior/force_sums.hpp. No exponential grows, and
// thin layers are treated as in body_symbols.hpp.

#include "numeric/layers/body_symbols.hpp"

namespace steadyslide::numeric {

template <Real R>
struct WaveStress {
  R xx;
  R zz;
  R xz;
  R rotation;
};

template <Real R>
struct WaveStresses {
  WaveStress<R> of_pressure;
  WaveStress<R> of_shear;
};

template <Real R>
class LayerStress {
 public:
  /// Throws std::invalid_argument if the symbols are not those of layers, or unless k > 0.
  LayerStress(const BodySymbols<R>& symbols, const R& k);

  /// Returns the stresses at a depth below the upper side of a layer, 0 <= depth <= its thickness; number 0 is the first
  /// layer, and the number of layers is the base. An interface has two sides, the end of one layer and the start of the
  /// next. Throws std::out_of_range for a number beyond these.
  WaveStresses<R> at(std::size_t layer, const R& depth) const;
  /// Returns those at a depth in the first layer, minus those of the half-plane of its solid; without cancellation if k h
  /// > 1.
  WaveStresses<R> defects_at(const R& depth) const;

 private:
  /// The columns of its matrices belong to the pressure and to the shear traction.
  struct Field {
    R gamma;
    R rest;
    R xi;
    Matrix2<R> down;  ///< thick layers: traction of the downward field at the upper side
    Matrix2<R> up;    ///< of the upward field at the lower side
    HeldSide<R> held;
    Matrix2<R> held_by;  ///< thin layers: e of `held`
  };
  static WaveStresses<R> stresses(const Field& field, const Matrix2<R>& displacement, const Matrix2<R>& traction);

  R k_;
  std::vector<Field> fields_;
  Matrix2<R> down_defect_;  ///< of the first layer if it is thick: `down` minus that of the half-plane
};

}  // namespace steadyslide::numeric
