#pragma once
// The table [half_space] of a problem file: the material at the surface, and the body.

#include <string>

#include "library/problem_file/problem_reader.hpp"
#include "model/body.hpp"

namespace steadyslide::library {

inline constexpr std::size_t max_layers = 64;

struct ReadBody {
  Elasticity elasticity;  ///< of the surface, and of an elastic indenter
  Body body;
};

/// `file` is the problem file's name; a table of symbols is looked for in its folder. Throws InvalidFile.
ReadBody read_body(const ProblemReader& reader, const std::string& file);

}  // namespace steadyslide::library
