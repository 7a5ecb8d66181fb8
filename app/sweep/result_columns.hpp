#pragma once
// Columns of results by name. A name is a path into what `solve --format json` prints: contact[0].left.x,
// contact.size (how many); "resultants." may be left out. The name of a number, or of a table with a value, is that value;
// with "_error" behind it, singular_points[1].intensity_error, the error.

#include <optional>
#include <string>
#include <vector>

#include "app/results/solution_text.hpp"
#include "library/sweep/path.hpp"
#include "library/sweep/sweep_file.hpp"

namespace steadyslide::app {

class ResultColumns {
 public:
  /// Throws Failure for a name that no solution has, and for one of several values.
  explicit ResultColumns(const std::vector<Word>& names);

  /// Where nothing is named.
  static std::vector<Word> usual();

  std::vector<std::string> names() const;
  /// The entries of the result that the columns are from (solve_json.hpp).
  std::vector<std::string> entries() const;
  /// Each column's text; empty where this solution has no such entry, or no number there.
  std::vector<std::string> cells(const SolutionText& solution) const;

 private:
  struct Column {
    std::string name;
    std::size_t start;        // of starts_
    std::vector<Step> steps;  // from there
    const char* part;         // of a number: "value" or "error"
  };
  /// Where columns begin: what an entry of the result has there is made once for all of them, and nothing else.
  struct Start {
    std::string entry;
    std::optional<Step> next;
    bool operator==(const Start&) const = default;
  };

  std::vector<Start> starts_;
  std::vector<Column> columns_;
};

}  // namespace steadyslide::app
