#pragma once
// How many things go on at a time.

#include <string>

#include "app/commands/command_line.hpp"

namespace steadyslide::app {

inline constexpr int most_jobs = 1000;

inline Option jobs_option(const std::string& what) {
  return {"--jobs", "N", what + " at a time, 1 to " + std::to_string(most_jobs) + "; default: one on each core"};
}

inline unsigned jobs(const Given& given, unsigned otherwise) {
  return static_cast<unsigned>(given.count("--jobs", 1, most_jobs).value_or(static_cast<int>(otherwise)));
}

}  // namespace steadyslide::app
