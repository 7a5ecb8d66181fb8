#pragma once
// The lines of the texts that written_statements.hpp describes, and their parts.

#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace steadyslide::symbolic {

/// The error for a text that cannot be read, such as "no such name; alhpa". It does not contain the place.
struct UnreadableStatement : std::logic_error {
  using std::logic_error::logic_error;
};
[[noreturn]] void refuse(const std::string& what, const std::string& text);

struct StatementPlace {
  std::string file;  ///< empty if the text does not name its file
  int line = 0;
};
/// Returns text such as "equation.txt, line 7".
std::string to_text(const StatementPlace& place);

struct StatementLine {
  std::string keyword;
  std::string rest;
  StatementPlace place;
};

struct StatementSection {
  std::string id;
  StatementPlace place;
  std::vector<StatementLine> lines = {};
};

/// Returns the sections of the text. `place` is always the current line. Throws UnreadableStatement.
std::vector<StatementSection> statement_sections(std::string_view text, StatementPlace& place);

/// Returns the parts before and after the first separator; absent if the separator does not occur.
std::optional<std::pair<std::string, std::string>> cut(const std::string& text, const std::string& separator);
/// Returns the parts between the separators. Separators inside these brackets do not count.
std::vector<std::string> split(const std::string& text, const std::string& separator = ",",
                               const std::string& brackets = "([{");

}  // namespace steadyslide::symbolic
