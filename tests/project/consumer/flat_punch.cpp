// The traction of a flat punch gives back its load, in double precision.

#include <cmath>
#include <iostream>

#include "numeric/solution/contact_solution.hpp"

int main() {
  using namespace steadyslide;
  const ContactProblem problem(Elasticity(Solid(Rational(3, 10), 1)),
                               FrictionProfile({Rational(1, 5), Rational(3, 5)}, {0}),
                               Indenter(-1, {{1, Polynomial()}}), 1);
  const numeric::Attempt<double> attempt = numeric::closed_form<double>(problem);
  if (!attempt.solution) {
    std::cerr << attempt.reason << '\n';
    return 1;
  }
  const double load = attempt.solution->resultants().normal.value;
  std::cout << (std::abs(load - 1) < 1e-12 ? "load 1\n" : "another load\n");
}
