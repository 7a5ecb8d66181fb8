#include "symbolic/field/expression.hpp"
#include "model/elasticity.hpp"
#include "support/test.hpp"
#include "symbolic/local/coupling.hpp"

using namespace steadyslide::symbolic;
using GiNaC::ex;
using GiNaC::ex_to;
using GiNaC::numeric;

TEST_CASE("numbers go to GiNaC and back unchanged") {
  CHECK(rc::check([](long long numerator, long long denominator) {
    RC_PRE(denominator != 0);
    const Rational value = Rational(Integer(numerator), Integer(denominator));
    RC_ASSERT(to_rational(to_expression(value)) == value);
  }));
  CHECK(to_rational(to_expression(-7e-400_r)) == -7e-400_r);
  CHECK_THROWS_AS(to_rational(numeric(0.5)), std::domain_error);
}

TEST_CASE("the symbolic constants at rational arguments are the model's") {
  CHECK(rc::check([] {
    const auto poisson = [] { return Rational(uniform(-999, 498), 1000); };
    const auto young = [] { return Rational(uniform(1, 999), 7); };
    const auto value = [](const ex& e) { return to_rational(ex_to<numeric>(e)); };
    const Solid body(poisson(), young()), indenter(poisson(), young());
    for (const Plane plane : {Plane::strain, Plane::stress}) {
      const ex nu = to_expression(body.poisson()), modulus = to_expression(body.young());
      const KolosovSolid one = kolosov_solid(nu, modulus, plane);
      const KolosovSolid two = kolosov_solid(to_expression(indenter.poisson()), to_expression(indenter.young()), plane);
      const Elasticity rigid(body, plane), elastic(body, indenter, plane);
      RC_ASSERT(value(coupling_constant(nu, plane)) == rigid.gamma());
      RC_ASSERT(value(compliance(nu, modulus, plane)) == rigid.compliance());
      RC_ASSERT(value(dundurs_constant(one, two)) == elastic.gamma());
      RC_ASSERT(value(compliance(one) + compliance(two)) == elastic.compliance());
    }
  }));
}
