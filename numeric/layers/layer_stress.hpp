#pragma once
// Stresses in a layered body under surface tractions of one wave number, the transfer functions of stresses: under a
// pressure P cos(kx) and a shear traction Q sin(kx) towards +x,
//
//   sigma_xx = xx cos(kx),   sigma_zz = zz cos(kx),   sigma_xz = xz sin(kx),   z downwards.
//
// No exponential grows, and thin layers are treated as in body_symbols.hpp.

#include "numeric/layers/body_symbols.hpp"

namespace steadyslide::numeric {

template <Real R>
struct WaveStress {
  R xx;
  R zz;
  R xz;
};

template <Real R>
class LayerStress {
 public:
  /// Throws std::invalid_argument if the symbols are not those of layers, or unless k > 0.
  LayerStress(const BodySymbols<R>& symbols, const R& k, const R& pressure, const R& shear);

  /// Returns the stresses at a depth below the upper side of a layer, 0 <= depth <= its thickness; number 0 is the first
  /// layer, and the number of layers is the base. An interface has two sides, the end of one layer and the start of the
  /// next. Throws std::out_of_range for a number beyond these.
  WaveStress<R> at(std::size_t layer, const R& depth) const;

 private:
  struct Vector {
    R first = 0;
    R second = 0;
  };
  struct Field {
    R gamma;
    R rest;
    R xi;
    Vector down;  ///< thick layers: traction of the downward field at the upper side
    Vector up;    ///< of the upward field at the lower side
    HeldSide<R> held;
    Vector held_by;  ///< thin layers: e of `held`
  };
  static Vector product(const Matrix2<R>& m, const Vector& v) {
    return {m.a * v.first + m.b * v.second, m.c * v.first + m.d * v.second};
  }

  R k_;
  std::vector<Field> fields_;
};

}  // namespace steadyslide::numeric
