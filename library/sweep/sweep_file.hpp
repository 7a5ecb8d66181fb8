#pragma once
// A sweep, SWEEP.toml: a problem, the data of it that vary, and what is asked of each solution. The rules and the messages
// of bad files are here; docs/sweep.md has an example.
//
//   problem = "base.toml"    or the table [problem]
//   [vary]                   every combination of these data; the first changes slowest
//   [together]               these vary in step, as one more datum, in the place where the table stands
//   [output] columns         names of results
//   [solve] digits, method, cells, iterations
//
// What a datum takes: an array; a range "first:last:step"; { random = N, from = ..., to = ..., seed = ... }.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "library/sweep/combinations.hpp"

namespace steadyslide::library {

/// A word of the file that somebody else has to understand.
struct Word {
  std::string text;
  std::string place;  ///< "FILE:LINE: output.columns[0]", which a complaint begins with
};

struct SweepFile {
  Combinations problems;
  std::vector<Word> columns;  ///< empty: not given
  std::optional<Word> method;
  std::optional<int> digits;
  std::optional<int> cells;
  std::optional<int> iterations;
  /// Of all texts: of the sweep, its problem, measured profiles. Other problems have another one.
  std::uint64_t fingerprint;
};

/// "-" is the standard input. Throws InvalidFile, UnreadableFile.
SweepFile read_sweep(const std::string& name);

}  // namespace steadyslide::library
