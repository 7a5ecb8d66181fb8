#pragma once
// The steady sliding contact problem [Bal16, (3)], exact, in the user's units and the user's x (left to right):
//
//   A t := (1/pi) PV int t(x')/(x'-x) dx' + s(x) t(x) = u'(x)/c,   u + C <= psi,   t <= 0,   t (u + C - psi) = 0,
//   int t = -load,   s = +-gamma f: + when the indenter slides towards +x, - when towards -x.

#include <optional>

#include "model/body.hpp"
#include "model/direction.hpp"
#include "model/elasticity.hpp"
#include "model/friction_profile.hpp"
#include "model/indenter.hpp"

namespace steadyslide {

class ContactProblem {
 public:
  /// Throws InvalidData unless load > 0, every jump and load_at lie strictly inside the support, and the profile is
  /// smooth if the indenter is elastic (at its own edges and steps the half-plane idealisation fails). `elasticity` is
  /// that of the surface; with layers it is the solid of the first one, and the indenter is rigid. With a period the
  /// support is not longer than it, and the attitude is fixed.
  ContactProblem(Elasticity elasticity, FrictionProfile friction, Indenter indenter, Rational load,
                 Sliding sliding = Sliding::plus_x, std::optional<Rational> load_at = std::nullopt, Body body = {});

  const Elasticity& elasticity() const { return elasticity_; }
  const FrictionProfile& friction() const { return friction_; }
  const Indenter& indenter() const { return indenter_; }
  /// P > 0, force per unit thickness.
  const Rational& load() const { return load_; }
  Sliding sliding() const { return sliding_; }
  /// The place where the load acts if the indenter may tilt; absent if the indenter cannot rotate.
  const std::optional<Rational>& load_at() const { return load_at_; }
  const Body& body() const { return body_; }

  /// s = +-gamma f on friction piece k, signed by the direction of sliding.
  Rational coupled_friction(std::size_t piece) const;
  /// t_t/t = -+f on friction piece k. The indenter drags the body in the direction in which it slides.
  Rational shear_ratio(std::size_t piece) const;

  /// The place where u = 0 by convention: x = 0, or the support's left end if x = 0 lies outside the support.
  Rational origin_of_displacement() const;

  /// A part of the support on which the friction has one value and the profile is one polynomial.
  struct Piece {
    Rational left;
    Rational right;
    std::size_t friction;  ///< the index of the value
    std::size_t profile;   ///< the index of the polynomial
  };
  /// The support between its ends, the friction's jumps and the profile's breaks, left to right.
  std::vector<Piece> pieces() const;

  /// Each returns a copy of the problem with one datum replaced. Each throws as the constructor does.
  ContactProblem with_load(Rational load) const;
  ContactProblem with_friction(FrictionProfile friction) const;
  ContactProblem with_indenter(Indenter indenter) const;
  ContactProblem with_sliding(Sliding sliding) const;
  ContactProblem with_body(Body body) const;
  /// Returns the problem with one more jump at c: f is larger by `height` between c and the next jump.
  ContactProblem with_jump(const Rational& c, const Rational& height) const;
  /// Returns the problem with the same heights and the same load in the coordinate y = scale x + shift, scale != 0. The
  /// body's lengths are scaled, too. A negative scale mirrors the problem and reverses the direction of sliding.
  ContactProblem moved(const Rational& scale, const Rational& shift) const;
  /// Returns the mirror image, x -> -x: the same bodies seen from the other side of the plane of the drawing.
  ContactProblem mirrored() const { return moved(-1, 0); }
  friend bool operator==(const ContactProblem&, const ContactProblem&) = default;

 private:
  void check_body() const;

  Elasticity elasticity_;
  FrictionProfile friction_;
  Indenter indenter_;
  Rational load_;
  Sliding sliding_;
  std::optional<Rational> load_at_;
  Body body_;
};

}  // namespace steadyslide
