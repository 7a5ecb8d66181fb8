#pragma once
// Random exact problems for the laws. They shrink towards simple ones. Some have small data, so that coincidences are
// frequent.

#include "model/contact_problem.hpp"
#include "support/test.hpp"

namespace steadyslide::testing {

/// A rational in [low, high] with the given denominator.
inline rc::Gen<Rational> rational(int low, int high, int denominator) {
  return rc::gen::exec([=] { return Rational(uniform(low * denominator, high * denominator), denominator); });
}

/// f: one in five is zero, one in five large (up to 50), the rest up to 2.
inline rc::Gen<Rational> friction() {
  return rc::gen::weightedOneOf<Rational>({{1, rc::gen::just(0_r)}, {1, rational(2, 50, 7)}, {3, rational(0, 2, 97)}});
}

inline rc::Gen<Elasticity> elasticity() {
  const auto poisson = rc::gen::exec([] { return Rational(uniform(-899, 498), 1000); });
  return rc::gen::oneOf(
      rc::gen::apply([](const Rational& nu, const Rational& young,
                        bool strain) { return Elasticity(Solid(nu, young), strain ? Plane::strain : Plane::stress); },
                     poisson, rational(1, 9, 4), rc::gen::arbitrary<bool>()),
      // The coupling has either sign, as with an elastic indenter.
      rc::gen::exec([] { return Elasticity::reduced(Rational(uniform(-90, 90), 100)); }));
}

struct SurfaceData {
  FrictionProfile friction;
  Rational left;
  Rational right;
};

/// A support of width 1/2..8 anywhere, with 0..max_jumps jumps inside.
inline rc::Gen<SurfaceData> surface(int max_jumps) {
  return rc::gen::exec([max_jumps] {
    const Rational left = *rational(-3, 3, 8), width = *rational(1, 16, 3) / 2;
    const int count = uniform(0, max_jumps);
    std::set<Rational> places;
    for (int k = 0; k < count; ++k) places.insert(left + width * uniform(1, 399) / 400);
    std::vector<Rational> values{*friction()};
    for (std::size_t k = 0; k < places.size(); ++k) values.push_back(*friction());
    return SurfaceData{FrictionProfile(values, {places.begin(), places.end()}), left, left + width};
  });
}

inline rc::Gen<Sliding> sliding() { return rc::gen::element(Sliding::plus_x, Sliding::minus_x); }

/// A flat punch in full contact.
inline rc::Gen<ContactProblem> flat_punch(int max_jumps) {
  return rc::gen::exec([max_jumps] {
    const SurfaceData s = *surface(max_jumps);
    const Polynomial height = Polynomial::constant(*rational(-1, 1, 3));
    return ContactProblem(*elasticity(), s.friction, Indenter(s.left, {{s.right, height}}), *rational(1, 40, 9),
                          *sliding());
  });
}

/// A parabola A x^2 + B x + C on a support so wide that both ends of its contact are free. The jumps lie inside or
/// outside of the contact.
inline rc::Gen<ContactProblem> parabola(int max_jumps) {
  return rc::gen::exec([max_jumps] {
    const SurfaceData s = *surface(max_jumps);
    const Polynomial profile({*rational(-1, 1, 3), *rational(-2, 2, 5), Rational(uniform(1, 64), 32)});
    return ContactProblem(*elasticity(), s.friction, Indenter(Rational(-1000000), {{1000000_r, profile}}),
                          *rational(1, 40, 9), *sliding());
  });
}

/// Periodic contact on one zone: a flat punch, or a wave that is lowest inside the support, under a load that keeps a gap
/// open if the support is long.
inline rc::Gen<ContactProblem> periodic_zone(int max_jumps) {
  return rc::gen::exec([max_jumps] {
    const SurfaceData s = *surface(max_jumps);
    const Rational width = s.right - s.left,
                   period = width * (30 + uniform(0, 60)) / 20;  // beside the contact there is none
    const Elasticity e = *elasticity();
    Indenter indenter(s.left, {{s.right, Polynomial::constant(*rational(-1, 1, 3))}});
    Rational load = *rational(1, 40, 9);
    if (*rc::gen::arbitrary<bool>()) {
      const Rational height = *rational(1, 4, 7);
      indenter = indenter.with_harmonics({{1, -height, height * uniform(-9, 9) / 40}, {2, height / uniform(10, 20), 0}},
                                         s.left + width * uniform(25, 75) / 100);
      load = height / e.compliance() * uniform(1, 20) / 8;
    }
    return ContactProblem(e, s.friction, indenter, load, *sliding(), std::nullopt, Body::periodic(period));
  });
}

/// Any profile with small data: jumps on wedges, jumps of height zero, equal friction values, gamma = 0.
inline rc::Gen<ContactProblem> coincidences() {
  return rc::gen::exec([] {
    const auto whole = [](int low, int high) { return Rational(uniform(low, high)); };
    const auto places = [] {
      std::set<Rational> chosen;
      for (int k = uniform(0, 3); k > 0; --k) chosen.insert(Rational(uniform(-3, 3), 4));
      return std::vector<Rational>(chosen.begin(), chosen.end());
    };
    const std::vector<Rational> jumps = places();
    std::vector<Rational> values;
    for (std::size_t k = 0; k <= jumps.size(); ++k) values.push_back(whole(0, 3) / 2);
    std::vector<Indenter::Piece> pieces;
    std::vector<Rational> ends = places();
    ends.push_back(1);
    for (const Rational& to : ends) pieces.push_back({to, Polynomial({whole(0, 1), whole(0, 1), whole(0, 1)})});
    std::optional<Rational> load_at;
    if (uniform(0, 3) == 0) load_at = whole(-1, 1) / 2;
    return ContactProblem(Elasticity::reduced(whole(-2, 2) / 3), FrictionProfile(values, jumps), Indenter(-1, pieces),
                          1, *sliding(), load_at);
  });
}

}  // namespace steadyslide::testing
