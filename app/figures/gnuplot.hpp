#pragma once
// gnuplot as a child process: a script on its standard input, what it draws on its standard output.

#include <string>

namespace steadyslide::app {

/// Without anybody's start-up files, in the C locale. Throws Failure (exit code 3) where gnuplot is not found, cannot
/// be run, or does not take the script.
std::string run_gnuplot(const std::string& script);

}  // namespace steadyslide::app
