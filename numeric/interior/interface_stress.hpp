#pragma once
// The stresses that decide whether a layer comes off: the largest shear and the largest tension along each interface.

#include "numeric/interior/interior_stress.hpp"

namespace steadyslide::numeric {

struct InterfaceStress {
  double depth;
  Estimate<double> shear;      ///< the largest |sigma_xz|
  Estimate<double> shear_x;    ///< its place
  Estimate<double> tension;    ///< the largest sigma_zz, or 0
  Estimate<double> tension_x;  ///< NaN without tension
};

/// Returns them from the surface down; empty for the half-plane. They are searched below the contact and up to 30 widths of
/// contact and depths beside it. Between neighbouring places of the search the field is smooth.
std::vector<InterfaceStress> interface_stresses(const InteriorStress<double>& stress);

}  // namespace steadyslide::numeric
