#include "proofs_checks/instruments/solutions/problem_law.hpp"

namespace steadyslide::proofs_checks::eq_03_translation {

Claim claim() {
  static const Polynomial tilt({0, Rational(1, 100)});
  return law_claim("eq-03-translation", {.lift = Polynomial::constant(Rational(-7, 5))})
      .wrong("the gap grows with `C`", &Law::gap, Rational(7, 5))
      .wrong("a profile that is tilted instead of lifted", &Law::lift, tilt)
      .wrong("the load changes, too", &Law::load, 2)
      .wrong("near miss: the traction moved by ten times the tolerance", &Law::missed, &Law::traction)
      .near_miss("the traction on cells", [](Law& l, const Number&) { l.missed_on_cells = true; });
}

}  // namespace steadyslide::proofs_checks::eq_03_translation
