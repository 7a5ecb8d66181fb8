#include "proofs_checks/instruments/problem_law.hpp"

namespace steadyslide::proofs_checks {
namespace {
const Rational factor(5, 3);
}

Claim eq_03_scaling() {
  const Law law{.height = factor, .load = factor, .traction = factor, .gap = factor};
  return law_claim("eq-03-scaling", law,
                   {variant("load kept", law, [](Law& l) { l.load = 1; }),
                    variant("profile kept", law, [](Law& l) { l.height = 1; }),
                    variant("the traction like k^2", law, [](Law& l) { l.traction = factor * factor; }),
                    variant("the traction kept", law, [](Law& l) { l.traction = 1; }),
                    variant("near miss: the profile moved by ten times the tolerance", law, miss_of_height),
                    variant("near miss: the traction on cells moved by ten times the tolerance", law, miss_on_cells)});
}

}  // namespace steadyslide::proofs_checks
