#pragma once
// Reads a sweep, SWEEP.toml: a problem, its varied data, and the results to compute for each solution. The rules of the
// format and the messages for bad files are here; docs/sweep.md has an example.
//
//   problem = "base.toml"    or the table [problem]
//   [vary]                   every combination of these data; the first changes slowest
//   [together]               these vary in step, as one more datum, in the place where the table stands
//   [output] columns         names of results
//   [solve] digits, method, cells, accuracy, iterations, over, depth
//
// The values of a datum: an array; a range "first:last:step"; { random = N, from = ..., to = ..., seed = ... }.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "library/sweep/combinations.hpp"

namespace steadyslide::library {

/// A word of the file that another part of the program interprets.
struct Word {
  std::string text;
  std::string place;  ///< "FILE:LINE: output.columns[0]", the beginning of an error message
};

struct SweepFile {
  Combinations problems;
  std::vector<Word> columns;  ///< empty if the file has none
  std::optional<Word> method;
  std::optional<int> digits;
  std::optional<int> cells;
  std::optional<int> iterations;
  std::optional<Rational> accuracy;
  std::optional<Rational> over;   ///< the length of the window of averages
  std::optional<Rational> depth;  ///< the smallest depth of the largest stress
  /// A hash of the texts of the sweep, its problem and measured profiles. Sweeps of other problems have other
  /// fingerprints.
  std::uint64_t fingerprint;
};

/// Reads a file, or the standard input for "-". Throws InvalidFile and UnreadableFile.
SweepFile read_sweep(const std::string& name);

}  // namespace steadyslide::library
