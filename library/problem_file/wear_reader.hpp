#pragma once
// Reads the table [wear] of a problem file.

#include <optional>

#include "library/problem_file/problem_reader.hpp"
#include "model/wear.hpp"

namespace steadyslide::library {

/// Absent without the table. Throws InvalidFile.
std::optional<Wear> read_wear(const ProblemReader& reader, const ContactProblem& contact);

}  // namespace steadyslide::library
