// Every enclosure that a proof may name.

#include "proofs_checks/enclosures/remark_enclosures.hpp"
#include "proofs_checks/enclosures/section_3_enclosures.hpp"
#include "proofs_checks/proof/enclosures.hpp"

namespace steadyslide::proofs_checks {

std::span<const Enclosure> enclosures() {
  static const std::vector<Enclosure> all{edge_powers(),        logarithm_of_two(),     logarithm_of_a_unit(),
                                          triangle_amplitude(), peak_of_parabola(),     galin_at_two(),
                                          contact_over_notch(), contact_of_two_wells(), contact_of_bowl()};
  return all;
}

}  // namespace steadyslide::proofs_checks
