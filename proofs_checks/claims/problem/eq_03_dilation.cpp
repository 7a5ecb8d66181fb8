#include "proofs_checks/instruments/problem_law.hpp"

namespace steadyslide::proofs_checks {
namespace {
const Rational factor(5, 3);
}

Claim eq_03_dilation() {
  const Law law{.scale = factor, .shift = Rational(1, 7), .height = factor, .load = factor, .gap = factor};
  return law_claim("eq-03-dilation", law,
                   {variant("heights kept", law, [](Law& l) { l.height = 1; }),
                    variant("load kept", law, [](Law& l) { l.load = 1; }),
                    variant("the traction divided by k", law, [](Law& l) { l.traction = 1 / factor; }),
                    variant("the gap kept", law, [](Law& l) { l.gap = 1; }),
                    variant("near miss: the load moved by ten times the tolerance", law, miss_of_load),
                    variant("near miss: the traction on cells moved by ten times the tolerance", law, miss_on_cells)});
}

}  // namespace steadyslide::proofs_checks
