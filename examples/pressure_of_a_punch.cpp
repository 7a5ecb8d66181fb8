// The pressure under a flat punch with two friction values, to 50 digits. It uses the library's own types: an exact
// problem as input, values with their errors as output.

#include <iostream>

#include "numeric/solution/contact_solution.hpp"

using namespace steadyslide;
using numeric::Real50;

int main() {
  const Elasticity half_space{Solid(parse_rational("0.2"), 1)};
  const FrictionProfile friction({parse_rational("0.1"), parse_rational("0.5")}, {0});
  const Indenter flat(-1, {{1, Polynomial()}});
  const ContactProblem problem(half_space, friction, flat, /*load=*/1);

  const numeric::Attempt<Real50> attempt = numeric::closed_form<Real50>(problem);
  if (!attempt.solution) {
    std::cerr << attempt.reason << '\n';
    return 1;
  }
  std::cout.precision(50);
  const numeric::Sample<Real50> sample = attempt.solution->at(parse_rational("1/2"));
  std::cout << "traction at x = 1/2: " << sample.traction.left.value << '\n';
  std::cout << "effective friction:  " << attempt.solution->resultants().effective_friction.value << '\n';
  std::cout.precision(2);
  std::cout << "error of the traction, about: " << sample.traction.left.error << '\n';
}
