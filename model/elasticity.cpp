#include "model/elasticity.hpp"

#include "model/invalid_data.hpp"

namespace steadyslide {

Solid::Solid(const Rational& poisson, const Rational& young) : poisson_(poisson), young_(young) {
  if (poisson <= -1 || 2 * poisson >= 1) {
    throw InvalidData("poisson", "Poisson's ratio out of range", "it lies in ]-1, 1/2[", to_string(poisson));
  }
  if (young <= 0) throw InvalidData("young", "Young's modulus out of range", "it is positive", to_string(young));
}

Rational Solid::kolosov(Plane plane) const {
  return plane == Plane::strain ? Rational(3 - 4 * poisson_) : Rational((3 - poisson_) / (1 + poisson_));
}

Elasticity::Elasticity(const Solid& half_space, Plane plane) : plane_(plane), half_space_(half_space) {
  const Rational kappa = half_space.kolosov(plane);
  gamma_ = (kappa - 1) / (kappa + 1);
  compliance_ = (kappa + 1) / (4 * half_space.shear_modulus());
}

Elasticity::Elasticity(const Solid& half_space, const Solid& indenter, Plane plane)
    : plane_(plane), half_space_(half_space), indenter_(indenter) {
  const Rational kappa1 = half_space.kolosov(plane);
  const Rational kappa2 = indenter.kolosov(plane);
  const Rational mu1 = half_space.shear_modulus();
  const Rational mu2 = indenter.shear_modulus();
  gamma_ = (mu2 * (kappa1 - 1) - mu1 * (kappa2 - 1)) / (mu2 * (kappa1 + 1) + mu1 * (kappa2 + 1));
  compliance_ = (kappa1 + 1) / (4 * mu1) + (kappa2 + 1) / (4 * mu2);
}

Elasticity Elasticity::reduced(const Rational& gamma) {
  if (abs(gamma) >= 1) {
    throw InvalidData("gamma", "coupling constant out of range", "it lies in ]-1, 1[", to_string(gamma));
  }
  return {gamma, 1};
}

}  // namespace steadyslide
