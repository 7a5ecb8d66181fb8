#pragma once
// The elastic half-space, and the elastic indenter if there is one. The surface depends on two constants of them.
//
//   compliance c:  u = c u_bar, in the user's units;           rigid indenter, plane strain: c = 2 (1 - nu^2) / E
//   coupling gamma: A t = (1/pi) PV int t/(x'-x) dx' + gamma f t;   plane strain: gamma = (1-2nu) / (2 (1-nu))
//
// [Bal16, section 2]; with an elastic indenter c is the sum of both bodies' compliances and gamma is Dundurs'
// constant beta [Bal16, remark 1].

#include <optional>

#include "model/rational.hpp"

namespace steadyslide {

enum class Plane { strain, stress };

/// An isotropic solid. Throws InvalidData unless -1 < poisson < 1/2 and young > 0.
class Solid {
 public:
  Solid(const Rational& poisson, const Rational& young);

  const Rational& poisson() const { return poisson_; }
  const Rational& young() const { return young_; }
  Rational shear_modulus() const { return young_ / (2 * (1 + poisson_)); }
  /// Kolosov's constant: 3 - 4 nu in plane strain, (3 - nu)/(1 + nu) in plane stress.
  Rational kolosov(Plane plane) const;
  friend bool operator==(const Solid&, const Solid&) = default;

 private:
  Rational poisson_;
  Rational young_;
};

class Elasticity {
 public:
  /// A half-space under a rigid indenter.
  explicit Elasticity(const Solid& half_space, Plane plane = Plane::strain);
  /// A half-space under an elastic indenter.
  Elasticity(const Solid& half_space, const Solid& indenter, Plane plane = Plane::strain);
  /// Reduced data: gamma itself, psi and u already divided by c. Throws InvalidData unless -1 < gamma < 1.
  static Elasticity reduced(const Rational& gamma);

  const Rational& gamma() const { return gamma_; }
  const Rational& compliance() const { return compliance_; }
  Plane plane() const { return plane_; }
  /// Returns the half-space; absent for reduced data.
  const std::optional<Solid>& half_space() const { return half_space_; }
  /// Returns the indenter; absent for a rigid indenter.
  const std::optional<Solid>& indenter() const { return indenter_; }
  friend bool operator==(const Elasticity&, const Elasticity&) = default;

 private:
  Elasticity(Rational gamma, Rational compliance) : gamma_(std::move(gamma)), compliance_(std::move(compliance)) {}

  Rational gamma_;
  Rational compliance_;
  Plane plane_ = Plane::strain;
  std::optional<Solid> half_space_;
  std::optional<Solid> indenter_;
};

}  // namespace steadyslide
