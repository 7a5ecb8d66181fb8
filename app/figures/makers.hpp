#pragma once
// One function for each figure, each in a file of its name. [Bal16, figures 3-5] and what the paper has not drawn.

#include "app/figures/figure.hpp"

namespace steadyslide::app {

Figure make_flat_punch();
Figure make_friction_jump_rising();
Figure make_friction_jump_falling();
Figure make_parabola();
Figure make_local_forms();
Figure make_contact_load();
Figure make_effective_friction();
Figure make_convergence();
Figure make_stress_map();

}  // namespace steadyslide::app
