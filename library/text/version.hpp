#pragma once

namespace steadyslide::library {

/// The project's version, as CMake has it.
extern const char* const version;

}  // namespace steadyslide::library
