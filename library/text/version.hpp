#pragma once

namespace steadyslide::library {

/// The project's version, and its date as 2026-11-28, from CMake.
extern const char* const version;
extern const char* const version_date;

}  // namespace steadyslide::library
