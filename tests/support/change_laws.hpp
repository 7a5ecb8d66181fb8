#pragma once
// Laws that relate the solutions of two problems. Each is written once: a change of the problem, and its effect on the
// solution. They are tested for every method at every precision (tests/laws, tests/symbolic).

#include <functional>

#include "support/random_problem.hpp"

namespace steadyslide::testing {

/// x -> scale x + shift, t -> traction t, gap -> height gap.
struct Image {
  Rational scale, shift, traction, height;

  Image(Rational a = 1, Rational b = 0, Rational t = 1, Rational h = 1)
      : scale(std::move(a)), shift(std::move(b)), traction(std::move(t)), height(std::move(h)) {}
  Rational of(const Rational& x) const { return scale * x + shift; }
};

struct Change {
  ContactProblem problem;
  Image image;

  Change(ContactProblem p, Image i) : problem(std::move(p)), image(std::move(i)) {}
};

/// `k` is a factor. `regular` is a place in the contact where neither friction nor profile changes.
struct ChangeLaw {
  const char* name;
  std::function<Change(const ContactProblem&, const Rational& k, const Rational& regular)> change;
};

/// A random factor from 1/3 to 3.
inline Rational some_factor() { return *rational(1, 9, 5) / 3; }

/// The profile psi times `profile`, the load times `load`.
inline ContactProblem scaled(const ContactProblem& p, const Rational& profile, const Rational& load) {
  return p.with_indenter(p.indenter().scaled(profile)).with_load(load * p.load());
}

/// The profile psi + height.
inline ContactProblem raised(const ContactProblem& p, const Rational& height) {
  std::vector<Indenter::Piece> pieces = p.indenter().pieces();
  for (Indenter::Piece& piece : pieces) piece.profile = piece.profile + Polynomial::constant(height);
  return p.with_indenter(Indenter(p.indenter().left(), pieces)
                             .with_harmonics(p.indenter().harmonics(), p.indenter().origin_of_harmonics()));
}

inline ContactProblem with_elasticity(const ContactProblem& p, const Elasticity& elasticity) {
  return {elasticity, p.friction(), p.indenter(), p.load(), p.sliding(), p.load_at(), p.body()};
}

/// A stiffer solid under a larger load; not for reduced data or an elastic indenter.
inline Change stiffened(const ContactProblem& p, const Rational& k) {
  const Elasticity& e = p.elasticity();
  if (!e.half_space() || e.indenter()) return Change(p, Image());
  const Solid stiffer(e.half_space()->poisson(), k * e.half_space()->young());
  return Change(with_elasticity(scaled(p, 1, k), Elasticity(stiffer, e.plane())), Image(1, 0, k));
}

inline Change reduced_to_compliance(const ContactProblem& p) {
  const Rational c = p.elasticity().compliance();
  return Change(with_elasticity(scaled(p, 1 / c, 1), Elasticity::reduced(p.elasticity().gamma())),
                Image(1, 0, 1, 1 / c));
}

inline const std::vector<ChangeLaw>& change_laws() {
  using P = const ContactProblem&;
  using X = const Rational&;
  static const std::vector<ChangeLaw> laws{
      {"mirror, the sliding reversed", [](P p, X, X) { return Change(p.moved(-1, 0), Image(-1)); }},
      {"translation", [](P p, X k, X) { return Change(p.moved(1, 5 * (1 - k)), Image(1, 5 * (1 - k))); }},
      {"x in proportion: the traction in inverse proportion",
       [](P p, X k, X) { return Change(p.moved(k, Rational(1, 3)), Image(k, Rational(1, 3), 1 / k)); }},
      {"x, profile and load in proportion: the same traction",
       [](P p, X k, X) { return Change(scaled(p, k, k).moved(k, 0), Image(k, 0, 1, k)); }},
      {"profile and load in proportion: the same contact",
       [](P p, X k, X) { return Change(scaled(p, k, k), Image(1, 0, k, k)); }},
      {"compliance and load in inverse proportion: the same contact", [](P p, X k, X) { return stiffened(p, k); }},
      {"the profile over the compliance, in reduced data: the same traction",
       [](P p, X, X) { return reduced_to_compliance(p); }},
      {"a constant added to the profile", [](P p, X k, X) { return Change(raised(p, 3 * (1 - k)), Image()); }},
      {"a jump of height zero", [](P p, X, X regular) { return Change(p.with_jump(regular, 0), Image()); }},
  };
  return laws;
}

/// Laws that are slightly wrong. Each is refuted.
inline std::vector<ChangeLaw> wrong_laws() {
  using P = const ContactProblem&;
  using X = const Rational&;
  const Rational nearly = 1 + 1e-8_r;
  return {
      {"mirror, the sliding kept",
       [](P p, X, X) { return Change(p.moved(-1, 0).with_sliding(p.sliding()), Image(-1)); }},
      {"x in proportion: the same traction", [](P p, X, X) { return Change(p.moved(2, 0), Image(2)); }},
      {"profile in proportion, the load kept", [](P p, X, X) { return Change(scaled(p, 2, 1), Image(1, 0, 2, 2)); }},
      {"a jump of some height", [](P p, X, X) { return Change(p.with_jump(-0.01_r, 0.01_r), Image()); }},
      {"near miss: profile and load", [nearly](P p, X, X) { return Change(scaled(p, nearly, nearly), Image()); }},
  };
}

}  // namespace steadyslide::testing
