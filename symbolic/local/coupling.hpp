#pragma once
// The constants of the surface equation as expressions, for symbolic or rational arguments. [Bal16, remark 1]

#include <ginac/ginac.h>

#include "model/elasticity.hpp"

namespace steadyslide::symbolic {

/// Returns gamma(nu) under a rigid indenter, as printed: (1-2nu)/(2(1-nu)) in plane strain, (1-nu)/2 in plane stress.
GiNaC::ex coupling_constant(const GiNaC::ex& nu, Plane plane = Plane::strain);
/// Returns the compliance c = u/u_bar under a rigid indenter: 2(1-nu^2)/E in plane strain, 2/E in plane stress.
GiNaC::ex compliance(const GiNaC::ex& nu, const GiNaC::ex& young, Plane plane = Plane::strain);

/// An isotropic solid, given by its shear modulus and Kolosov's constant.
struct KolosovSolid {
  GiNaC::ex mu;
  GiNaC::ex kappa;
};
/// mu = E/(2(1+nu)); kappa = 3-4nu in plane strain, (3-nu)/(1+nu) in plane stress.
KolosovSolid kolosov_solid(const GiNaC::ex& nu, const GiNaC::ex& young, Plane plane = Plane::strain);

/// Returns gamma of a half-space under an elastic indenter, which is Dundurs' constant beta:
/// (mu_2 (kappa_1 - 1) - mu_1 (kappa_2 - 1)) / (mu_2 (kappa_1 + 1) + mu_1 (kappa_2 + 1)).
GiNaC::ex dundurs_constant(const KolosovSolid& half_space, const KolosovSolid& indenter);
/// Returns the contribution of one body to the compliance: (kappa + 1)/(4 mu).
GiNaC::ex compliance(const KolosovSolid& solid);

}  // namespace steadyslide::symbolic
