#pragma once
// What is decided in balls over a box of parameters, by name. Each stands in a file of its own in proofs_checks/enclosures/.

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "proofs_checks/proof/proof.hpp"

namespace steadyslide::proofs_checks {

struct Enclosure {
  using Decide = std::function<Decision(const Box&)>;
  /// Wrong over each box that a proof asks for: has to come out as `no`.
  struct Variant {
    std::string name;
    Decide decide;
  };

  std::string id;  ///< "gamma-of-nu"
  Decide decide;
  std::vector<Variant> wrong;
};

std::span<const Enclosure> enclosures();
/// Throws std::logic_error if there is none of this name.
const Enclosure& enclosure(std::string_view id);

}  // namespace steadyslide::proofs_checks
