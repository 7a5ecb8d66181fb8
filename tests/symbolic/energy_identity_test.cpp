#include "symbolic/statements/energy_identity.hpp"

#include <doctest/doctest.h>

#include "support/decided_statements.hpp"
#include "symbolic/riemann_hilbert/polynomial_families.hpp"

using namespace steadyslide::symbolic;
using GiNaC::ex;

TEST_CASE("every statement on the energy holds, and each of its wrong variants is refuted") {
  CHECK(steadyslide::testing::check_decided(energy_statements()).size() == 6);
}

TEST_CASE("Chebyshev's polynomials and exact integrals") {
  const GiNaC::symbol x("x");
  CHECK((chebyshev_t(0, x) - 1).is_zero());
  CHECK((chebyshev_t(3, x) - (4 * x * x * x - 3 * x)).expand().is_zero());
  CHECK(chebyshev_u(-1, x).is_zero());
  CHECK((chebyshev_u(0, x) - 1).is_zero());
  CHECK((chebyshev_u(3, x) - (8 * x * x * x - 4 * x)).expand().is_zero());
  // Pell's equation.
  for (int n = 1; n < 8; ++n) {
    const ex t = chebyshev_t(n, x);
    const ex u = chebyshev_u(n - 1, x);
    CHECK((t * t - (x * x - 1) * u * u - 1).expand().is_zero());
  }
  const GiNaC::symbol c("c");
  CHECK((integral(3 * x * x + 1, x, c, 2) - (10 - c * c * c - c)).expand().is_zero());
}
