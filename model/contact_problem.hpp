#pragma once
// The steady sliding contact problem [Bal16, (3)], exact, in the user's units and the user's x (left to right):
//
//   A t := (1/pi) PV int t(x')/(x'-x) dx' + s(x) t(x) = u'(x)/c,   u + C <= psi,   t <= 0,   t (u + C - psi) = 0,
//   int t = -load,   s = +-gamma f: + when the indenter slides towards +x, - when towards -x.

#include <optional>

#include "model/direction.hpp"
#include "model/elasticity.hpp"
#include "model/friction_profile.hpp"
#include "model/indenter.hpp"

namespace steadyslide {

class ContactProblem {
 public:
  /// Throws InvalidData unless load > 0, every jump and load_at lie strictly inside the support, and the profile is
  /// smooth if the indenter is elastic (at its own edges and steps the half-plane idealisation fails).
  ContactProblem(Elasticity elasticity, FrictionProfile friction, Indenter indenter, Rational load,
                 Sliding sliding = Sliding::plus_x, std::optional<Rational> load_at = std::nullopt);

  const Elasticity& elasticity() const { return elasticity_; }
  const FrictionProfile& friction() const { return friction_; }
  const Indenter& indenter() const { return indenter_; }
  /// P > 0, force per unit thickness.
  const Rational& load() const { return load_; }
  Sliding sliding() const { return sliding_; }
  /// Where the load acts if the indenter may tilt; absent if it keeps its attitude.
  const std::optional<Rational>& load_at() const { return load_at_; }

  /// s = +-gamma f on friction piece k, signed by the direction of sliding.
  Rational coupled_friction(std::size_t piece) const;

 private:
  Elasticity elasticity_;
  FrictionProfile friction_;
  Indenter indenter_;
  Rational load_;
  Sliding sliding_;
  std::optional<Rational> load_at_;
};

}  // namespace steadyslide
