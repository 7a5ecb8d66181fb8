// The powers of the distance in the pressure at both edges of a punch, gamma = 2/7, f = 3/10.

#include <iostream>

#include "model/elasticity.hpp"
#include "model/singular_point.hpp"

int main() {
  using namespace steadyslide;
  const Elasticity elasticity(Solid(parse_rational("0.3"), 1));
  const Rational s = elasticity.gamma() * parse_rational("0.3");
  std::cout << to_string(edge_exponent(End::left, s)) << '\n' << to_string(edge_exponent(End::right, s)) << '\n';
}
