#pragma once

namespace steadyslide::app {

/// The project's version, as CMake has it.
extern const char* const version;

}  // namespace steadyslide::app
