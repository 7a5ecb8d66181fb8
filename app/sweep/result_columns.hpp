#pragma once
// Columns of results by name. A name is a path into the output of `solve --format json`: contact[0].left.x,
// contact.size (the length of a list); "resultants." may be left out. The name of a number, or of a table with a value,
// means that value; with "_error" behind it, singular_points[1].intensity_error, it means the error.

#include <optional>
#include <string>
#include <vector>

#include "app/results/solution_text.hpp"
#include "library/sweep/path.hpp"
#include "library/sweep/sweep_file.hpp"

namespace steadyslide::app {

class ResultColumns {
 public:
  /// Throws Failure for a name that no solution has, and for a name with several values.
  explicit ResultColumns(const std::vector<Word>& names);

  /// The columns if the sweep names none.
  static std::vector<Word> usual();

  std::vector<std::string> names() const;
  /// The entries of the result from which the columns come (solve_json.hpp).
  std::vector<std::string> entries() const;
  /// Returns the text of each column; empty if this solution has no such entry, or no number there.
  std::vector<std::string> cells(const SolutionText& solution) const;

 private:
  struct Column {
    std::string name;
    std::size_t start;        // index in starts_
    std::vector<Step> steps;  // from the start to the value
    const char* part;         // for a number: "value" or "error"
  };
  /// The start of columns: the JSON of this part of the result is made once for all columns with the same start.
  struct Start {
    std::string entry;
    std::optional<Step> next;
    bool operator==(const Start&) const = default;
  };

  std::vector<Start> starts_;
  std::vector<Column> columns_;
};

}  // namespace steadyslide::app
