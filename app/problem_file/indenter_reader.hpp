#pragma once
// The table [indenter] of a problem file: its support and its profile, as a polynomial, as pieces or as a measured
// trace.

#include "app/problem_file/problem_file.hpp"
#include "app/problem_file/problem_reader.hpp"

namespace steadyslide::app {

struct ReadIndenter {
  Indenter shape;
  std::optional<MeasuredProfile> measured;
};

/// `file`: the problem file's name, beside which a trace is looked for. Throws Failure.
ReadIndenter read_indenter(const ProblemReader& reader, const std::string& file);

}  // namespace steadyslide::app
