#include "proofs_checks/instruments/solutions/problem_law.hpp"

namespace steadyslide::proofs_checks::eq_03_dilation {

Claim claim() {
  static const Rational factor(5, 3);
  return law_claim("eq-03-dilation",
                   {.scale = factor, .shift = Rational(1, 7), .height = factor, .load = factor, .gap = factor})
      .wrong("heights kept", &Law::height, 1)
      .wrong("load kept", &Law::load, 1)
      .wrong("the traction divided by `k`", &Law::traction, 1 / factor)
      .wrong("the gap kept", &Law::gap, 1)
      .wrong("near miss: the load moved by ten times the tolerance", &Law::missed, &Law::load)
      .near_miss("the traction on cells", [](Law& l, const Number&) { l.missed_on_cells = true; });
}

}  // namespace steadyslide::proofs_checks::eq_03_dilation
