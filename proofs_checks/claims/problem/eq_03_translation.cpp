#include "proofs_checks/instruments/solutions/problem_law.hpp"

namespace steadyslide::proofs_checks {

Claim eq_03_translation() {
  return law_claim("eq-03-translation", {.lift = Polynomial::constant(Rational(-7, 5))})
      .wrong("the gap grows with C", [](Law& l) { l.gap = Rational(7, 5); })
      .wrong("a profile that is tilted instead of lifted",
             [](Law& l) {
               l.lift = Polynomial({0, Rational(1, 100)});
             })
      .wrong("the load changes, too", [](Law& l) { l.load = 2; })
      .wrong("near miss: the traction moved by ten times the tolerance", [](Law& l) { l.missed = &Law::traction; })
      .wrong("near miss: the traction on cells moved by ten times the tolerance",
             [](Law& l) { l.missed_on_cells = true; });
}

}  // namespace steadyslide::proofs_checks
