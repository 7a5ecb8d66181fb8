#include "model/elasticity.hpp"
#include "broken_rule.hpp"

namespace {

Solid random_solid() { return Solid(Rational(uniform(-999, 499), 1000), Rational(uniform(1, 999), 7)); }

}  // namespace

TEST_CASE("a rigid indenter: gamma and the compliance as printed [Bal16, section 2]") {
  CHECK(rc::check([] {
    const Solid body = random_solid();
    const Rational& nu = body.poisson();
    const Elasticity strain(body);
    RC_ASSERT(strain.plane() == Plane::strain);
    RC_ASSERT(strain.gamma() == (1 - 2 * nu) / (2 * (1 - nu)));
    RC_ASSERT(strain.compliance() == 2 * (1 - nu * nu) / body.young());
    RC_ASSERT(strain.gamma() > 0);
    RC_ASSERT(strain.gamma() < 0.75_r);
    const Elasticity stress(body, Plane::stress);
    RC_ASSERT(stress.plane() == Plane::stress);
    RC_ASSERT(stress.gamma() == (1 - nu) / 2);
    RC_ASSERT(stress.compliance() == 2 / body.young());
    RC_ASSERT(stress.gamma() > 0.25_r);
    RC_ASSERT(stress.gamma() < 1);
    RC_ASSERT(!strain.indenter().has_value());
    RC_ASSERT(strain.half_space()->poisson() == nu);
  }));
}

TEST_CASE("an elastic indenter: exchange, identical bodies, compliances that add") {
  CHECK(rc::check([] {
    const Solid one = random_solid(), two = random_solid();
    for (const Plane plane : {Plane::strain, Plane::stress}) {
      const Elasticity there(one, two, plane), back(two, one, plane);
      RC_ASSERT(there.gamma() == -back.gamma());
      RC_ASSERT(there.compliance() == back.compliance());
      RC_ASSERT(there.compliance() == Elasticity(one, plane).compliance() + Elasticity(two, plane).compliance());
      RC_ASSERT(abs(there.gamma()) < 1);
      RC_ASSERT(Elasticity(one, one, plane).gamma() == 0);
      RC_ASSERT(Elasticity(one, one, plane).compliance() == 2 * Elasticity(one, plane).compliance());
      RC_ASSERT(there.plane() == plane);
      RC_ASSERT(there.indenter()->young() == two.young());
      // The stiffness of both bodies times k: gamma stays, the compliance is divided by k.
      const Elasticity stiffer(Solid(one.poisson(), 3 * one.young()), Solid(two.poisson(), 3 * two.young()), plane);
      RC_ASSERT(stiffer.gamma() == there.gamma());
      RC_ASSERT(3 * stiffer.compliance() == there.compliance());
    }
  }));
}

TEST_CASE("an indenter of growing stiffness tends to the rigid one, at the rate mu_1/mu_2") {
  CHECK(rc::check([] {
    const Solid body = random_solid();
    const Rational nu2(uniform(-999, 499), 1000);
    for (const Plane plane : {Plane::strain, Plane::stress}) {
      const Elasticity rigid(body, plane);
      for (const char* factor : {"1e3", "1e12", "1e200"}) {
        const Solid indenter(nu2, body.young() * parse_rational(factor));
        const Elasticity elastic(body, indenter, plane);
        // With q = mu_1/mu_2: gamma - gamma_rigid = -q ((kappa_2-1) + gamma_rigid (kappa_2+1)) / ((kappa_1+1) + q
        // (kappa_2+1)), and kappa_1 > 1 (plane stress: > 5/3), |gamma_rigid| < 1: the difference is below q kappa_2.
        const Rational q = body.shear_modulus() / indenter.shear_modulus();
        RC_ASSERT(abs(elastic.gamma() - rigid.gamma()) <= q * indenter.kolosov(plane));
        RC_ASSERT(elastic.gamma() != rigid.gamma());
        RC_ASSERT(elastic.gamma() < rigid.gamma());
        RC_ASSERT(elastic.compliance() > rigid.compliance());
      }
    }
  }));
}

TEST_CASE("an indenter more compliant than the body makes gamma negative") {
  CHECK(Elasticity(Solid(0.3_r, 10), Solid(0.3_r, 1)).gamma() < 0);
  CHECK(Elasticity(Solid(0.3_r, 1), Solid(0.3_r, 10)).gamma() > 0);
}

TEST_CASE("reduced data") {
  const Elasticity reduced = Elasticity::reduced(Rational(-2, 7));
  CHECK(reduced.gamma() == Rational(-2, 7));
  CHECK(reduced.compliance() == 1);
  CHECK_FALSE(reduced.half_space().has_value());
  CHECK_FALSE(reduced.indenter().has_value());
  CHECK(Elasticity::reduced(0).gamma() == 0);
}

TEST_CASE("solids and constants that do not exist") {
  const auto solid = [](const Rational& nu, const Rational& young) { return refusal([&] { Solid(nu, young); }); };
  const std::string poisson = "poisson: Poisson's ratio out of range; it lies in ]-1, 1/2[; ";
  CHECK(solid(0.5_r, 1) == poisson + "0.5");
  CHECK(solid(-1, 1) == poisson + "-1");
  CHECK(solid(Rational(499999, 1000000), 1) == "accepted");
  CHECK(solid(Rational(-999999, 1000000), 1) == "accepted");
  CHECK(solid(0, 0) == "young: Young's modulus out of range; it is positive; 0");
  CHECK(solid(0, -3) == "young: Young's modulus out of range; it is positive; -3");
  const auto reduced = [](const Rational& gamma) { return refusal([&] { Elasticity::reduced(gamma); }); };
  for (const Rational& gamma : {1_r, -1_r, Rational(4, 3)}) {
    CHECK(reduced(gamma) == "gamma: coupling constant out of range; it lies in ]-1, 1[; " + to_string(gamma));
  }
  CHECK(reduced(-0.99_r) == "accepted");
}
