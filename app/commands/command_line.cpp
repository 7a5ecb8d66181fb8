#include "app/commands/command_line.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <cstdio>

#include "app/embedded.hpp"
#include "app/problem_file/list_parser.hpp"
#include "app/terminal/interrupt.hpp"

namespace steadyslide::app {
namespace {

/// CLI11 ends the line itself.
std::string last_line_open(std::string_view text) {
  return std::string(text.substr(0, text.find_last_not_of('\n') + 1));
}

}  // namespace

/// Reads one command line.
class CommandLine {
 public:
  explicit CommandLine(const Program& program)
      : program_(program), app_(program.description, program.name), given_(program.commands.size()) {
    app_.set_help_flag("-h,--help", "Print this help and exit");
    app_.set_version_flag("--version", fmt::format("steadyslide {}", version));
    app_.require_subcommand(0, 1);
    app_.footer(last_line_open(embedded::help_program));
    app_.get_formatter()->column_width(28);
    for (std::size_t k = 0; k < given_.size(); ++k) add(program.commands[k], given_[k].values_);
  }

  ExitCode run(int argc, const char* const* argv) {
    try {
      app_.parse(argc, argv);
    } catch (const CLI::CallForHelp&) {
      return print(app_.help());
    } catch (const CLI::CallForVersion& call) {
      return print(std::string(call.what()) + "\n");
    } catch (const CLI::ExtrasError&) {
      throw unexpected(app_.remaining(true).front());
    } catch (const CLI::ParseError& error) {
      throw bad_command_line(error.what());
    }
    for (std::size_t k = 0; k < given_.size(); ++k) {
      const Command& command = program_.commands[k];
      if (app_.got_subcommand(command.name)) return command.run(given_[k]);
    }
    throw bad_command_line("no command; " + commands_rule() + "; see --help");
  }

 private:
  void add(const Command& command, std::map<std::string, Given::Value>& values) {
    const std::size_t end = command.help.find("\n\n");
    CLI::App* added = app_.add_subcommand(command.name, command.help.substr(0, end));
    added->footer(last_line_open(command.help).substr(end + 2));
    for (const Option& option : command.options) {
      // "--output" of "-o,--output"
      Given::Value& value = values[option.name.substr(option.name.find(',') + 1)];
      if (option.kind == Option::Kind::flag) {
        added->add_flag(option.name, value.given, option.help);
      } else if (option.kind == Option::Kind::repeatable) {
        added->add_option(option.name, value.texts, option.help)
            ->type_name(option.value)
            ->expected(1)
            ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
      } else {
        added
            ->add_option_function<std::string>(
                option.name,
                [&value](const std::string& text) {
                  value = {true, text, {}};
                },
                option.help)
            ->type_name(option.value)
            ->required(option.kind == Option::Kind::required);
      }
    }
  }

  static ExitCode print(const std::string& text) {
    Output output(std::nullopt);
    output.write(text);
    output.commit();
    return ExitCode::done;
  }

  std::string commands_rule() const {
    std::vector<std::string> names;
    for (const Command& command : program_.commands) names.push_back(command.name);
    return fmt::format("it is one of {}", fmt::join(names, ", "));
  }

  Failure unexpected(const std::string& argument) const {
    const bool option = argument.starts_with('-');
    const std::vector<CLI::App*> commands = app_.get_subcommands();
    if (commands.empty() && !option) return bad_command_line("unknown command", commands_rule(), argument);
    const std::string help = commands.empty() ? "--help" : commands.front()->get_name() + " --help";
    return bad_command_line(option ? "unknown option" : "one argument too many", help + " lists them", argument);
  }

  const Program& program_;
  CLI::App app_;
  std::vector<Given> given_;
};

namespace {

std::vector<std::string> names_of(std::initializer_list<Format> formats) {
  std::vector<std::string> names;
  for (const Format format : formats) names.emplace_back(format_name(format));
  return names;
}

ExitCode end_with(ExitCode code, const std::string& message) {
  fmt::print(stderr, "steadyslide: {}\n", one_line(message));
  return code;
}

ExitCode run_to_the_end(const Program& program, int argc, const char* const* argv) {
  try {
    return CommandLine(program).run(argc, argv);
  } catch (const Failure& failure) {
    return end_with(failure.code(), failure.what());
  } catch (const std::bad_alloc&) {
    return end_with(ExitCode::failed, "out of memory");
  } catch (const std::exception& error) {
    return end_with(ExitCode::failed, fmt::format("internal failure: {}", error.what()));
  }
}

}  // namespace

std::optional<int> Given::count(const std::string& option, int least, int most) const {
  if (!has(option)) return std::nullopt;
  return parse_count(option, text(option), least, most);
}

std::optional<std::string> Given::name(const std::string& option, const std::string& thing) const {
  if (!has(option)) return std::nullopt;
  if (text(option).empty()) throw bad_command_line(option + ": no " + thing, "it has a name", "");
  return text(option);
}

CommonOptions Given::common(int digits_otherwise, std::initializer_list<Format> formats) const {
  const int wanted = digits(digits_otherwise);
  const std::string& name = has("--format") ? text("--format") : "text";
  const auto format = std::ranges::find(formats, name, format_name);
  if (format == formats.end()) {
    throw bad_command_line("--format: unknown format",
                           fmt::format("it is one of {}", fmt::join(names_of(formats), ", ")), name);
  }
  return {wanted, *format, this->name("--output", "file")};
}

std::optional<unsigned long long> Given::seed() const {
  if (!has("--seed")) return std::nullopt;
  unsigned long long seed = 0;
  const std::string& digits = text("--seed");
  const char* const end = digits.data() + digits.size();
  const auto [after, error] = std::from_chars(digits.data(), end, seed);
  if (error != std::errc() || after != end) {
    throw bad_command_line("--seed: out of range", "it is a whole number from 0 to 2^64-1", digits);
  }
  return seed;
}

Option problem_argument() { return {"PROBLEM", "", "Problem file, or -", Option::Kind::required}; }
Option seed_option() { return {"--seed", "N", "Seed of the random parameters, a whole number"}; }
Option folder_option() { return {"-o,--output", "DIR", "Write into DIR, which is made if need be; default: here"}; }

std::vector<Option> with_common(std::vector<Option> options, const std::string& digits,
                                std::initializer_list<Format> formats) {
  std::vector<std::string> names = names_of(formats);
  const std::string last = names.back();
  names.pop_back();
  options.push_back({"--digits", "N", digits});
  options.push_back({"--format", "FORMAT", fmt::format("{} or {}", fmt::join(names, ", "), last)});
  options.push_back({"-o,--output", "FILE", "Write to FILE, whole or not at all; default: standard output"});
  return options;
}

int run_program(const Program& program, int argc, const char* const* argv) {
  handle_signals();
  return static_cast<int>(run_to_the_end(program, argc, argv));
}

}  // namespace steadyslide::app
