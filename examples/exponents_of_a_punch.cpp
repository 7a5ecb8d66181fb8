// Exponents are exact. Their signs are decided, not computed; then they are evaluated to any precision.

#include <iostream>

#include "model/singular_point.hpp"
#include "numeric/number/real.hpp"

using namespace steadyslide;

int main() {
  const Elasticity half_space{Solid(parse_rational("0.3"), 1)};
  const FrictionProfile friction({parse_rational("0.2"), parse_rational("0.6")}, {0});
  const Indenter flat(-1, {{1, Polynomial()}});
  const ContactProblem problem(half_space, friction, flat, /*load=*/1);

  std::cout.precision(30);
  for (const SingularPoint& point : possible_singular_points(problem)) {
    if (!point.x) continue;
    std::cout << name_of(point.kind) << " at x = " << to_string(*point.x) << ": " << to_string(*point.exponent) << " = "
              << numeric::to_real<numeric::Real50>(*point.exponent)
              << (point.exponent->sign() < 0 ? ", blows up\n" : ", vanishes\n");
  }
}
