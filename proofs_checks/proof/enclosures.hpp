#pragma once
// Statements decided in balls over a box of parameters, by name. Their sources are in proofs_checks/enclosures/.

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "proofs_checks/proof/proof.hpp"

namespace steadyslide::proofs_checks {

struct Enclosure {
  using Decide = std::function<Decision(const Box&)>;
  /// A wrong variant: it must be decided as `no` over each box that a proof uses.
  struct Variant {
    std::string name;
    Decide decide;
  };

  std::string id;  ///< "gamma-of-nu"
  Decide decide;
  std::vector<Variant> wrong;
};

std::span<const Enclosure> enclosures();
/// Returns the enclosure of this name. Throws std::logic_error if there is none.
const Enclosure& enclosure(std::string_view id);

}  // namespace steadyslide::proofs_checks
