#pragma once
// Makes many problems of one: takes the document of a problem file and data that have several values, and makes a
// problem of every combination of these values. Combinations are counted from 0; the first axis changes slowest.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "library/problem_file/document.hpp"
#include "library/problem_file/problem_file.hpp"
#include "library/sweep/path.hpp"

namespace steadyslide::library {

inline constexpr std::size_t max_combinations = 10000000;

/// A datum and its values.
struct VariedDatum {
  std::string path;  ///< "friction.values[1]"
  std::size_t line;
  std::vector<Value> values;
};

/// Data that change together; all have the same number of values.
using Axis = std::vector<VariedDatum>;

/// Immutable: several threads may use it at the same time.
class Combinations {
 public:
  /// `base` is the document of the problem file `file`; the lines of `axes` are those of `axes_file`. A missing key of
  /// the base is added; a missing entry of an array is not. Throws InvalidFile if a path leads nowhere, if two paths
  /// lead to one datum, and if none of the first 10000 combinations is a problem.
  Combinations(Value base, std::string file, std::vector<Axis> axes, const std::string& axes_file);

  std::size_t size() const { return size_; }
  /// The data of all axes, in their order.
  const std::vector<VariedDatum>& data() const { return data_; }
  /// Returns for each datum the index of its value in the n-th combination.
  std::vector<std::size_t> chosen(std::size_t n) const;
  /// Returns the problem of the n-th combination. Throws InvalidFile if it breaks a rule.
  Problem problem(std::size_t n) const;

 private:
  void add(Axis axis);

  Value base_;
  std::string file_;
  std::shared_ptr<const std::string> axes_file_;  // the values keep a pointer to this name
  std::vector<VariedDatum> data_;
  std::vector<std::vector<Step>> steps_;  // one for each datum
  std::vector<std::size_t> axes_;         // one for each datum
  std::vector<std::size_t> lengths_;      // one for each axis
  std::size_t size_ = 1;
  std::optional<Problem> known_;  // its indenter serves all, if the indenter is not varied
};

}  // namespace steadyslide::library
