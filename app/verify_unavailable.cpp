#include "app/verify_command.hpp"

namespace steadyslide::app {

ExitCode run(const VerifyOptions&) { throw bad_command_line("verify: not available in this version"); }

}  // namespace steadyslide::app
