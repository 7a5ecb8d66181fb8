#include "proofs_checks/instruments/problem_law.hpp"

namespace steadyslide::proofs_checks {

Claim eq_03_translation() {
  const Law law{.lift = Polynomial::constant(Rational(-7, 5))};
  return law_claim("eq-03-translation", law,
                   {variant("the gap grows with C", law, [](Law& l) { l.gap = Rational(7, 5); }),
                    variant("a profile that is tilted instead of lifted", law,
                            [](Law& l) {
                              l.lift = Polynomial({0, Rational(1, 100)});
                            }),
                    variant("the load changes, too", law, [](Law& l) { l.load = 2; }),
                    variant("near miss: the traction moved by ten times the tolerance", law, miss_of_traction),
                    variant("near miss: the traction on cells moved by ten times the tolerance", law, miss_on_cells)});
}

}  // namespace steadyslide::proofs_checks
