#pragma once
// The laws that relate the solutions of two problems, each written once: a change of the problem, and what it makes of
// the solution. For every method at every precision (tests/laws, tests/symbolic).

#include <functional>

#include "support/random_problem.hpp"

namespace steadyslide::testing {

/// x -> scale x + shift, t -> traction t, gap -> height gap.
struct Image {
  Rational scale = 1, shift = 0, traction = 1, height = 1;

  Rational of(const Rational& x) const { return scale * x + shift; }
};

struct Change {
  ContactProblem problem;
  Image image;
};

/// `regular` is a place in the contact where neither friction nor profile changes.
struct ChangeLaw {
  const char* name;
  std::function<Change(const ContactProblem&, const Rational& regular)> change;
};

/// 1/3 to 3.
inline Rational some_factor() { return *rational(1, 9, 5) / 3; }

/// psi times `profile`, the load times `load`.
inline ContactProblem scaled(const ContactProblem& p, const Rational& profile, const Rational& load) {
  return p.with_indenter(p.indenter().scaled(profile)).with_load(load * p.load());
}

/// psi + height.
inline ContactProblem raised(const ContactProblem& p, const Rational& height) {
  std::vector<Indenter::Piece> pieces = p.indenter().pieces();
  for (Indenter::Piece& piece : pieces) piece.profile = piece.profile + Polynomial::constant(height);
  return p.with_indenter(Indenter(p.indenter().left(), pieces));
}

inline ContactProblem with_elasticity(const ContactProblem& p, const Elasticity& elasticity) {
  return {elasticity, p.friction(), p.indenter(), p.load(), p.sliding(), p.load_at()};
}

/// Within RapidCheck: factors and shifts are random.
inline const std::vector<ChangeLaw>& change_laws() {
  using P = const ContactProblem&;
  using X = const Rational&;
  static const std::vector<ChangeLaw> laws{
      {"mirror, the sliding reversed",
       [](P p, X) {
         return Change{p.moved(-1, 0), {-1}};
       }},
      {"translation",
       [](P p, X) {
         const Rational shift = *rational(-5, 5, 7);
         return Change{p.moved(1, shift), {1, shift}};
       }},
      {"x in proportion: the traction in inverse proportion",
       [](P p, X) {
         const Rational k = some_factor();
         return Change{p.moved(k, Rational(1, 3)), {k, Rational(1, 3), 1 / k}};
       }},
      {"x, profile and load in proportion: the same traction",
       [](P p, X) {
         const Rational k = some_factor();
         return Change{scaled(p, k, k).moved(k, 0), {k, 0, 1, k}};
       }},
      {"profile and load in proportion: the same contact",
       [](P p, X) {
         const Rational k = some_factor();
         return Change{scaled(p, k, k), {1, 0, k, k}};
       }},
      {"compliance and load in inverse proportion: the same contact",
       [](P p, X) {
         // Of a rigid indenter on a solid; of reduced data the compliance is 1.
         const Elasticity& e = p.elasticity();
         const Rational k = e.half_space() && !e.indenter() ? some_factor() : 1_r;
         const ContactProblem pressed = scaled(p, 1, k);
         if (k == 1) return Change{pressed, {}};
         const Solid stiffer(e.half_space()->poisson(), k * e.half_space()->young());
         return Change{with_elasticity(pressed, Elasticity(stiffer, e.plane())), {1, 0, k}};
       }},
      {"the profile over the compliance, in reduced data: the same traction",
       [](P p, X) {
         const Rational c = p.elasticity().compliance();
         return Change{with_elasticity(scaled(p, 1 / c, 1), Elasticity::reduced(p.elasticity().gamma())),
                       {1, 0, 1, 1 / c}};
       }},
      {"a constant added to the profile",
       [](P p, X) {
         return Change{raised(p, *rational(-3, 3, 7)), {}};
       }},
      {"a jump of height zero",
       [](P p, X regular) {
         return Change{p.with_jump(regular, 0), {}};
       }},
  };
  return laws;
}

/// The near misses of these laws: each is refuted.
inline std::vector<ChangeLaw> wrong_laws() {
  using P = const ContactProblem&;
  using X = const Rational&;
  const Rational nearly = 1_r + Rational(1, 100000000);
  return {
      {"mirror, the sliding kept",
       [](P p, X) {
         return Change{p.moved(-1, 0).with_sliding(p.sliding()), {-1}};
       }},
      {"x in proportion: the same traction",
       [](P p, X) {
         return Change{p.moved(2, 0), {2}};
       }},
      {"profile in proportion, the load kept",
       [](P p, X) {
         return Change{scaled(p, 2, 1), {1, 0, 2, 2}};
       }},
      {"a jump of some height",
       [](P p, X) {
         return Change{p.with_jump(-0.01_r, 0.01_r), {}};
       }},
      {"near miss: profile and load",
       [nearly](P p, X) {
         return Change{scaled(p, nearly, nearly), {}};
       }},
  };
}

}  // namespace steadyslide::testing
