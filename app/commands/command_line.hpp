#pragma once
// A program as a list of commands with their options and help texts. Runs the command that the user names. Only
// command_line.cpp uses the library that reads command lines.

#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/results/rows.hpp"
#include "app/terminal/failure.hpp"
#include "model/invalid_data.hpp"
#include "model/rational.hpp"

namespace CLI {
class App;
}

namespace steadyslide::app {

struct Option {
  enum class Kind { text, required, repeatable, flag };

  std::string name;   ///< "--digits", "-o,--output"; "PROBLEM" stands without a name
  std::string value;  ///< the name of its value in --help; none for a flag
  std::string help;
  Kind kind = Kind::text;
  std::string choices{};  ///< the allowed words, separated by blanks; empty if any text is allowed
};

/// The values of --digits, --format and --output.
struct CommonOptions {
  int digits;
  Format format;
  std::optional<std::string> output;  ///< absent for the standard output
};

/// The largest --digits, for estimated and for proved results.
inline constexpr int most_digits = 100;
inline constexpr int most_proved_digits = 1000;
/// The largest value of --jobs.
inline constexpr int most_jobs = 1000;

/// The options given to a command. Functions that check a text throw Failure (exit code 2), which names the option.
class Given {
 public:
  /// `options`: the command as the library has read it.
  explicit Given(const CLI::App& options) : options_(options) {}

  bool has(const std::string& option) const;
  /// Empty if the option is absent.
  std::string text(const std::string& option) const;
  /// The values of an option that may be repeated.
  std::vector<std::string> texts(const std::string& option) const;
  /// A whole number; absent if the option is absent.
  std::optional<int> count(const std::string& option, int least, int most) const;
  /// A name of a `thing`, not empty; absent if the option is absent.
  std::optional<std::string> name(const std::string& option, const std::string& thing) const;

  /// Returns `otherwise` without --digits.
  int digits(int otherwise, int most = most_digits) const { return count("--digits", 1, most).value_or(otherwise); }
  CommonOptions common(int digits, std::initializer_list<Format> formats, int most = most_digits) const;
  /// The folder of --output; the current folder without it.
  std::string folder() const { return name("--output", "folder").value_or("."); }
  std::optional<unsigned long long> seed() const;
  /// The number of parallel tasks; `otherwise` without --jobs.
  unsigned jobs(unsigned otherwise) const {
    return static_cast<unsigned>(count("--jobs", 1, most_jobs).value_or(static_cast<int>(otherwise)));
  }

 private:
  const CLI::App& options_;
};

/// The options PROBLEM, --certify, --seed, --jobs, and the folder to write into.
Option problem_argument();
Option certify_option(const std::string& what);
Option seed_option();
Option jobs_option(const std::string& what);
Option folder_option();
/// Returns a command's own options, then --digits with its help, --format and --output.
std::vector<Option> with_common(std::vector<Option> options, const std::string& digits,
                                std::initializer_list<Format> formats);

/// Returns what `parse` makes of an option's text. InvalidData becomes a Failure of the option, exit code 2.
template <class Parse>
auto checked(const std::string& option, Parse parse) {
  try {
    return parse();
  } catch (const InvalidData& invalid) {
    throw bad_command_line(option + ": " + invalid.what());
  }
}

/// Reads a list in an option's text (library/problem_file/list_parser.hpp).
std::vector<Rational> parse_list(const std::string& option, std::string_view text, std::size_t most);

struct Command {
  std::string name;
  std::string help;  ///< a description and, after an empty line, the text below the options
  std::vector<Option> options;
  ExitCode (*run)(const Given& given);
  std::string manual{};  ///< what the manual page says below the help
};

// Each is defined beside its command: solve_command.cpp, report/ledger_commands.cpp.
Command exponents_command();
Command table_command();
Command solve_command();
Command design_command();
Command sweep_command();
Command wear_command();
Command verify_command();
Command figures_command();
Command report_command();

struct Program {
  std::string name;
  std::string description;
  std::vector<Command> commands;
  std::vector<std::string> absent{};  ///< the commands of the ledger in a build without it
};

/// Runs the command that the command line names, or the only one of the program; prints --help or --version. A failure
/// is one line on the standard error. Returns the exit code.
int run_program(const Program& program, int argc, const char* const* argv);

}  // namespace steadyslide::app
