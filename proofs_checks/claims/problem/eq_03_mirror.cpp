#include "proofs_checks/instruments/problem_law.hpp"

namespace steadyslide::proofs_checks {

Claim eq_03_mirror() {
  const Law law{.scale = -1, .turned = true};
  return law_claim("eq-03-mirror", law,
                   {variant("the sliding direction kept", law, [](Law& l) { l.turned = false; }),
                    variant("the direction turned, the data not mirrored", law, [](Law& l) { l.scale = 1; }),
                    variant("the friction not mirrored", law, [](Law& l) { l.keeps_friction = true; }),
                    variant("near miss: the heights moved by ten times the tolerance", law, miss_of_height),
                    variant("near miss: the traction on cells moved by ten times the tolerance", law, miss_on_cells)});
}

}  // namespace steadyslide::proofs_checks
