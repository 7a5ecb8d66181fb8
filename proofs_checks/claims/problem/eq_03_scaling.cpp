#include "proofs_checks/instruments/solutions/problem_law.hpp"

namespace steadyslide::proofs_checks::eq_03_scaling {

Claim claim() {
  static const Rational factor(5, 3);
  return law_claim("eq-03-scaling", {.height = factor, .load = factor, .traction = factor, .gap = factor})
      .wrong("load kept", &Law::load, 1)
      .wrong("profile kept", &Law::height, 1)
      .wrong("the traction like `k^2`", &Law::traction, factor * factor)
      .wrong("the traction kept", &Law::traction, 1)
      .wrong("near miss: the profile moved by ten times the tolerance", &Law::missed, &Law::height)
      .near_miss("the traction on cells", [](Law& l, const Number&) { l.missed_on_cells = true; });
}

}  // namespace steadyslide::proofs_checks::eq_03_scaling
