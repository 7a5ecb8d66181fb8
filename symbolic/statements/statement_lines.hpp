#pragma once
// The lines of the texts that written_statements.hpp describes, and their parts.

#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace steadyslide::symbolic {

/// A text that cannot be read, without its place: "no such name; alhpa".
struct UnreadableStatement : std::logic_error {
  using std::logic_error::logic_error;
};
[[noreturn]] void refuse(const std::string& what, const std::string& text);

struct StatementPlace {
  std::string file;  ///< empty if the text does not name its file
  int line = 0;
};
/// "equation.txt, line 7"
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

/// `place` follows the line that is read. Throws UnreadableStatement.
std::vector<StatementSection> statement_sections(std::string_view text, StatementPlace& place);

/// Both parts around the first separator, without it; absent if it does not occur.
std::optional<std::pair<std::string, std::string>> cut(const std::string& text, const std::string& separator);
/// The parts between the separators that none of these brackets encloses.
std::vector<std::string> split(const std::string& text, const std::string& separator = ",",
                               const std::string& brackets = "([{");

}  // namespace steadyslide::symbolic
