#include "app/figures/figures_command.hpp"

namespace steadyslide::app {

ExitCode run(const FiguresOptions& /*options*/) { throw bad_command_line("figures: not available in this version"); }

}  // namespace steadyslide::app
