#pragma once

namespace steadyslide::library {

/// The project's version, from CMake.
extern const char* const version;

}  // namespace steadyslide::library
