#pragma once
// What tests ask of pictures.

#include <string>
#include <vector>

namespace steadyslide::testing {

/// Is every element closed, in order, and nothing else left open? Are there no bare ampersands?
bool is_well_formed(const std::string& xml);

/// What a reader sees: the characters of each <text>, one after the other in a line.
std::string shown_text(const std::string& svg);

/// The values of all attributes `id`.
std::vector<std::string> ids(const std::string& svg);

}  // namespace steadyslide::testing
