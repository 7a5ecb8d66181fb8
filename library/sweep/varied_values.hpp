#pragma once

#include <string>
#include <vector>

#include "library/problem_file/document.hpp"

namespace steadyslide::library {

/// The values that the entry of a sweep says the datum at `path` takes: an array, a range or random ones
/// (sweep_file.hpp). Numbers are numbers, profiles polynomials. Throws InvalidFile.
std::vector<Value> varied_values(const std::string& path, const Entry& entry, const std::string& file);

}  // namespace steadyslide::library
