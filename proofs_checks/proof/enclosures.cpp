#include "proofs_checks/proof/enclosures.hpp"

#include <algorithm>
#include <stdexcept>

namespace steadyslide::proofs_checks {

const Enclosure& enclosure(std::string_view id) {
  const std::span<const Enclosure> all = enclosures();
  const auto found = std::ranges::find(all, id, &Enclosure::id);
  if (found == all.end()) throw std::logic_error("no enclosure " + std::string(id));
  return *found;
}

}  // namespace steadyslide::proofs_checks
