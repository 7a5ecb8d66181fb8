#include "proofs_checks/instruments/solutions/problem_law.hpp"

namespace steadyslide::proofs_checks::eq_03_mirror {

Claim claim() {
  return law_claim("eq-03-mirror", {.scale = -1, .turned = true})
      .wrong("the sliding direction kept", &Law::turned, false)
      .wrong("the direction turned, the data not mirrored", &Law::scale, 1)
      .wrong("the friction not mirrored", &Law::keeps_friction, true)
      .wrong("near miss: the heights moved by ten times the tolerance", &Law::missed, &Law::height)
      .near_miss("the traction on cells", [](Law& l, const Number&) { l.missed_on_cells = true; });
}

}  // namespace steadyslide::proofs_checks::eq_03_mirror
