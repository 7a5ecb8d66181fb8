// All enclosures that a proof may name.

#include "proofs_checks/enclosures/enclosure_list.hpp"

#include <algorithm>
#include <stdexcept>

namespace steadyslide::proofs_checks {

std::span<const Enclosure> enclosures() {
  static const std::vector<Enclosure> all{edge_powers(),        logarithm_of_two(),     logarithm_of_a_unit(),
                                          triangle_amplitude(), peak_of_parabola(),     galin_at_two(),
                                          contact_over_notch(), contact_of_two_wells(), contact_of_bowl()};
  return all;
}

const Enclosure& enclosure(std::string_view id) {
  const std::span<const Enclosure> all = enclosures();
  const auto found = std::ranges::find(all, id, &Enclosure::id);
  if (found == all.end()) throw std::logic_error("no enclosure " + std::string(id));
  return *found;
}

}  // namespace steadyslide::proofs_checks
