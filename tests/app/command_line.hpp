#pragma once
// The fixture of command-line tests: runs the program in a folder of its own, and checks its answers.

#include <initializer_list>
#include <iomanip>
#include <utility>

#include "app/process.hpp"
#include "support/test.hpp"

namespace steadyslide::testing {

using Arguments = std::vector<std::string>;

/// Returns one list of arguments after the other.
inline Arguments joined(Arguments first, const Arguments& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

/// Returns one of the problems of the tests.
inline std::string problem_text(const std::string& name) {
  return file_text(STEADYSLIDE_TESTS "/app/commands/problems/" + name + ".toml");
}

/// Splits a command line, without the program's name.
inline Arguments arguments_of(const std::string& line) {
  std::istringstream words(line);
  Arguments arguments;
  for (std::string word; words >> std::quoted(word);) arguments.push_back(word);
  return {arguments.begin() + 1, arguments.end()};
}

/// Returns the cells of a CSV line without quotes.
inline std::vector<std::string> cells_of(std::string line) {
  std::ranges::replace(line, ',', '\n');
  return lines(line + '\n');
}

/// Runs `steadyslide ARGUMENTS` in an empty folder.
inline Finished run_alone(const Arguments& arguments, const std::string& input = "") {
  const TemporaryFolder folder;
  return folder.run(arguments, input);
}

/// Runs `steadyslide solve - ARGUMENTS` with the problem on the standard input.
inline Finished run(const std::string& problem, const Arguments& arguments = {}) {
  return run_alone(joined({"solve", "-"}, arguments), problem);
}

/// Runs `steadyslide solve FILE ARGUMENTS` for one of the examples.
inline Finished run_example(const std::string& file, const Arguments& arguments = {}) {
  return run_program(joined({"solve", file}, arguments), STEADYSLIDE_EXAMPLES);
}

/// Returns the output of a run. Checks that it succeeds, with nothing on the standard error.
inline std::string out_of(const Finished& finished) {
  CHECK(finished.err == "");
  REQUIRE(finished.code == 0);
  return finished.out;
}

/// Returns the output of `solve - ARGUMENTS`.
inline std::string output(const std::string& problem, const Arguments& arguments = {}) {
  return out_of(run(problem, arguments));
}

/// Checks that there is one line on the standard error, and nothing on the standard output.
inline void check_refused(const Finished& finished, const std::string& message, int code = 2) {
  CHECK(finished.err == "steadyslide: " + message + "\n");
  CHECK(finished.code == code);
  CHECK(finished.out == "");
}

inline void check_holds(const std::string& text, std::initializer_list<const char*> parts) {
  for (const char* part : parts) CHECK_MESSAGE(holds(text, part), part);
}

inline std::string replaced(std::string text, const std::string& what, const std::string& with) {
  return text.replace(text.find(what), what.size(), with);
}

/// Expands a text with {a,b} to two texts, one with a and one with b. Returns each with the chosen name.
inline std::vector<std::pair<std::string, std::string>> choices(const std::string& text) {
  const std::size_t open = text.find('{'), close = text.find('}');
  if (open == std::string::npos) return {{text, ""}};
  std::vector<std::pair<std::string, std::string>> result;
  for (const std::string& name : cells_of(text.substr(open + 1, close - open - 1))) {
    result.emplace_back(text.substr(0, open) + name + text.substr(close + 1), name);
  }
  return result;
}

/// Puts the chosen name in the place of {}.
inline std::string filled(const std::string& text, const std::string& name) {
  return name.empty() || !holds(text, "{}") ? text : replaced(text, "{}", name);
}

/// Checks that a progress bar was `shown` on a terminal, in one line, and was erased.
inline void check_erased(const Finished& finished, const std::string& shown) {
  const std::string erased = "\r\x1b[K";
  CHECK(holds(finished.err, shown));
  CHECK(finished.err.ends_with(erased));
  CHECK_FALSE(holds(finished.err, "\n"));
}

}  // namespace steadyslide::testing
