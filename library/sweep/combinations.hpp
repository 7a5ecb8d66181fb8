#pragma once
// Many problems made of one: a document of a problem file, data of it that take several values, and every combination
// of these as a problem. Combinations are counted from 0; the first axis changes slowest.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "library/problem_file/document.hpp"
#include "library/problem_file/problem_file.hpp"
#include "library/sweep/path.hpp"

namespace steadyslide::library {

inline constexpr std::size_t max_combinations = 10000000;

/// A datum and the values that it takes.
struct VariedDatum {
  std::string path;  ///< "friction.values[1]"
  std::size_t line;
  std::vector<Value> values;
};

/// Data that take their values in step, as many each.
using Axis = std::vector<VariedDatum>;

/// Immutable: may be asked by several threads.
class Combinations {
 public:
  /// `base` is the document of a problem file called `file`; the lines of `axes` are those of `axes_file`. A key that
  /// the base lacks is added, an entry of an array is not. Throws InvalidFile where a path leads nowhere, where two
  /// lead to one datum, and where none of the first 10000 combinations is a problem.
  Combinations(Value base, std::string file, std::vector<Axis> axes, const std::string& axes_file);

  std::size_t size() const { return size_; }
  /// Of all axes, in their order.
  const std::vector<VariedDatum>& data() const { return data_; }
  /// Which of its values each datum takes in the n-th combination.
  std::vector<std::size_t> chosen(std::size_t n) const;
  /// Throws InvalidFile if the n-th combination is none.
  Problem problem(std::size_t n) const;

 private:
  void add(Axis axis);

  Value base_;
  std::string file_;
  std::shared_ptr<const std::string> axes_file_;  // what values say of where they stand
  std::vector<VariedDatum> data_;
  std::vector<std::vector<Step>> steps_;  // of each datum
  std::vector<std::size_t> axes_;         // the same
  std::vector<std::size_t> lengths_;      // of each axis
  std::size_t size_ = 1;
  std::optional<Problem> known_;  // has the indenter of all, where that is not varied
};

}  // namespace steadyslide::library
