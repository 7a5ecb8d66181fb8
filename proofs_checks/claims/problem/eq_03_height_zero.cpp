#include "proofs_checks/instruments/problem_law.hpp"

namespace steadyslide::proofs_checks {

Claim eq_03_height_zero() {
  const Law law{.jump = Rational(0)};
  return law_claim("eq-03-height-zero", law,
                   {variant("a jump of 1/10", law, [](Law& l) { l.jump = Rational(1, 10); }),
                    variant("the load changes, too", law, [](Law& l) { l.load = Rational(1001, 1000); }),
                    variant("near miss: a jump a thousand times the tolerance", law, miss_of_jump),
                    variant("near miss: the traction on cells moved by ten times the tolerance", law, miss_on_cells)});
}

}  // namespace steadyslide::proofs_checks
