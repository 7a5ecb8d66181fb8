#pragma once

#include <string>
#include <vector>

#include "library/problem_file/document.hpp"

namespace steadyslide::library {

/// Returns the values that an entry of a sweep gives to the datum at `path`: an array, a range or random numbers
/// (sweep_file.hpp). Numbers come back as numbers, profiles as polynomials. Throws InvalidFile.
std::vector<Value> varied_values(const std::string& path, const Entry& entry, const std::string& file);

}  // namespace steadyslide::library
