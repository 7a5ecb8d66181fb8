#include <array>

#include "proofs_checks/instances/solved_instances.hpp"

namespace steadyslide::proofs_checks {

std::span<const InstanceSource> instance_sources() {
  static constexpr std::string_view local = "d, s, p, D, limit, pole, theta, w_l, w_r, t_l, t_r, accuracy";
  static constexpr std::array sources{
      InstanceSource{"growing-load", "P, dT, left, right, accuracy", growing_load},
      InstanceSource{"solved-rising-jumps", local, solved_rising_jumps},
      InstanceSource{"solved-falling-jumps", local, solved_falling_jumps},
      InstanceSource{"solved-wedges", local, solved_wedges},
  };
  return sources;
}

}  // namespace steadyslide::proofs_checks
