#include "proofs_checks/instruments/solutions/problem_law.hpp"

namespace steadyslide::proofs_checks::eq_03_height_zero {

Claim claim() {
  return law_claim("eq-03-height-zero", {.jump = Rational(0)})
      .wrong("a jump of 1/10", &Law::jump, Rational(1, 10))
      .wrong("the load changes, too", &Law::load, Rational(1001, 1000))
      .wrong("near miss: a jump a thousand times the tolerance", &Law::missed_jump, true)
      .near_miss("the traction on cells", [](Law& l, const Number&) { l.missed_on_cells = true; });
}

}  // namespace steadyslide::proofs_checks::eq_03_height_zero
