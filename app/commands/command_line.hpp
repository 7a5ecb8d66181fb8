#pragma once
// A program as a list of commands: what each takes, its help, and which one is run. Only command_line.cpp sees the
// library that reads command lines.

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
  std::string value;  ///< what --help calls its text; none for a flag
  std::string help;
  Kind kind = Kind::text;
  std::string choices{};  ///< the words that it takes, if it takes no others, with blanks between them
};

/// What --digits, --format and --output say.
struct CommonOptions {
  int digits;
  Format format;
  std::optional<std::string> output;  ///< absent: the standard output
};

/// Of --digits, estimated and proved.
inline constexpr int most_digits = 100;
inline constexpr int most_proved_digits = 1000;
/// The largest value of --jobs.
inline constexpr int most_jobs = 1000;

/// What stands behind a command. Functions that check a text throw Failure (exit code 2), which names the option.
class Given {
 public:
  /// What the library has read of the command.
  explicit Given(const CLI::App& options) : options_(options) {}

  bool has(const std::string& option) const;
  /// Empty without the option.
  std::string text(const std::string& option) const;
  /// Of a repeatable option.
  std::vector<std::string> texts(const std::string& option) const;
  /// A whole number; absent without the option.
  std::optional<int> count(const std::string& option, int least, int most) const;
  /// The name of a `thing`, which is not empty; absent without the option.
  std::optional<std::string> name(const std::string& option, const std::string& thing) const;

  /// `otherwise` without --digits.
  int digits(int otherwise, int most = most_digits) const { return count("--digits", 1, most).value_or(otherwise); }
  CommonOptions common(int digits, std::initializer_list<Format> formats, int most = most_digits) const;
  /// --output; the current one without.
  std::string folder() const { return name("--output", "folder").value_or("."); }
  std::optional<unsigned long long> seed() const;
  /// How many things go on at a time; `otherwise` without --jobs.
  unsigned jobs(unsigned otherwise) const {
    return static_cast<unsigned>(count("--jobs", 1, most_jobs).value_or(static_cast<int>(otherwise)));
  }

 private:
  const CLI::App& options_;
};

/// PROBLEM, --certify, --seed, --jobs, and the folder to write into.
Option problem_argument();
Option certify_option(const std::string& what);
Option seed_option();
Option jobs_option(const std::string& what);
Option folder_option();
/// A command's own options, then --digits with its help, --format and --output.
std::vector<Option> with_common(std::vector<Option> options, const std::string& digits,
                                std::initializer_list<Format> formats);

/// What `parse` makes of an option's text; a complaint of it as one about the option, exit code 2.
template <class Parse>
auto checked(const std::string& option, Parse parse) {
  try {
    return parse();
  } catch (const InvalidData& invalid) {
    throw bad_command_line(option + ": " + invalid.what());
  }
}

/// A list in an option's text (library/problem_file/list_parser.hpp).
std::vector<Rational> parse_list(const std::string& option, std::string_view text, std::size_t most);

struct Command {
  std::string name;
  std::string help;  ///< what it does and, after an empty line, what stands below its options
  std::vector<Option> options;
  ExitCode (*run)(const Given& given);
  std::string manual{};  ///< what the manual page says below the help
};

// They stand beside what they command: solve_command.cpp, verify/verify_command.cpp.
Command exponents_command();
Command table_command();
Command solve_command();
Command design_command();
Command sweep_command();
Command verify_command();
Command figures_command();
Command report_command();

struct Program {
  std::string name;
  std::string description;
  std::vector<Command> commands;
};

/// Runs the command that the command line names, or the only one there is, or prints what --help and --version ask for; a failure is one line on
/// the standard error. Returns the exit code.
int run_program(const Program& program, int argc, const char* const* argv);

}  // namespace steadyslide::app
