#include "app/commands/command_line.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <cstdio>

#include "app/commands/manual.hpp"
#include "app/embedded.hpp"
#include "app/terminal/interrupt.hpp"
#include "library/problem_file/file_error.hpp"
#include "library/problem_file/list_parser.hpp"

namespace steadyslide::app {
namespace {

/// Returns the text without its last line end: CLI11 adds one.
std::string last_line_open(std::string_view text) {
  return std::string(text.substr(0, text.find_last_not_of('\n') + 1));
}

std::string commands_rule(const Program& program) {
  std::vector<std::string> names;
  for (const Command& command : program.commands) names.push_back(command.name);
  return fmt::format("it is one of {}", fmt::join(names, ", "));
}

/// `only`: the program has no other command, and the command needs no name.
void add(CLI::App& app, const Program& program, const Command& command, bool only) {
  const std::size_t end = command.help.find("\n\n");
  CLI::App* added = only ? &app : app.add_subcommand(command.name, command.help.substr(0, end));
  std::string below = last_line_open(command.help).substr(end + 2);
  if (!command.manual.empty()) {
    below +=
        fmt::format("\n\nThe problem file, every result, unit and column: {} --generate man | man -l -", program.name);
  }
  added->footer(below);
  for (const Option& option : command.options) {
    if (option.kind == Option::Kind::flag) {
      added->add_flag(option.name, option.help);
      continue;
    }
    CLI::Option* taken = added->add_option(option.name, CLI::callback_t(), option.help)->type_name(option.value);
    taken->required(option.kind == Option::Kind::required);
    if (option.kind == Option::Kind::repeatable) {
      taken->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)->allow_extra_args();
    }
  }
}

ExitCode print(const std::string& text) {
  write_whole(std::nullopt, text);
  return ExitCode::done;
}

Failure unexpected(const CLI::App& app, const Program& program) {
  const std::string argument = app.remaining(true).front();
  const bool option = argument.starts_with('-');
  const std::vector<CLI::App*> commands = app.get_subcommands();
  if (commands.empty() && std::ranges::find(program.absent, argument) != program.absent.end())
    return bad_command_line("not in this build", "run ./verify", argument);
  if (program.commands.size() > 1 && commands.empty() && !option)
    return bad_command_line("unknown command", commands_rule(program), argument);
  const std::string help = commands.empty() ? "--help" : commands.front()->get_name() + " --help";
  return bad_command_line(option ? "unknown option" : "one argument too many", help + " lists them", argument);
}

std::string generated(const Program& program, const std::string& kind) {
  if (kind == "man") return manual_page(program);
  if (kind == "bash") return bash_completion(program);
  throw bad_command_line("--generate: unknown kind", "it is one of man, bash", kind);
}

ExitCode run_command(const Program& program, int argc, const char* const* argv) {
  CLI::App app(program.description, program.name);
  app.set_help_flag("-h,--help", "Print this help and exit");
  std::string generate;
  app.set_version_flag("--version", fmt::format("steadyslide {}", version));
  app.require_subcommand(0, 1);
  app.footer(last_line_open(embedded::help_program));
  app.get_formatter()->column_width(28);
  const bool only = program.commands.size() == 1;
  if (!only) {
    app.add_option("--generate", generate, "Print the manual page (man) or completions (bash), and exit")
        ->type_name("KIND");
  }
  for (const Command& command : program.commands) add(app, program, command, only);
  try {
    app.parse(argc, argv);
    if (only) return program.commands.front().run(Given(app));
    if (app.count("--generate") > 0) return print(generated(program, generate));
    for (const Command& command : program.commands) {
      if (app.got_subcommand(command.name)) return command.run(Given(*app.get_subcommand(command.name)));
    }
  } catch (const CLI::CallForHelp&) {
    return print(app.help());
  } catch (const CLI::CallForVersion& call) {
    return print(std::string(call.what()) + "\n");
  } catch (const CLI::ExtrasError&) {
    throw unexpected(app, program);
  } catch (const CLI::ParseError& error) {
    throw bad_command_line(error.what());
  }
  throw bad_command_line("no command; " + commands_rule(program) + "; see --help");
}

std::vector<std::string> names_of(std::initializer_list<Format> formats) {
  std::vector<std::string> names;
  for (const Format format : formats) names.emplace_back(format_name(format));
  return names;
}

}  // namespace

bool Given::has(const std::string& option) const {
  const CLI::Option& given = *options_.get_option(option);
  const bool is_flag = given.get_expected_max() == 0;  // --quick=false counts as absent
  return !given.empty() && (!is_flag || given.as<bool>());
}

std::vector<std::string> Given::texts(const std::string& option) const {
  return options_.get_option(option)->results();
}

std::string Given::text(const std::string& option) const {
  const std::vector<std::string> all = texts(option);
  return all.empty() ? "" : all.front();
}

std::optional<int> Given::count(const std::string& option, int least, int most) const {
  if (!has(option)) return std::nullopt;
  return checked(option, [&] { return parse_count(text(option), least, most); });
}

std::optional<std::string> Given::name(const std::string& option, const std::string& thing) const {
  if (!has(option)) return std::nullopt;
  if (text(option).empty()) throw bad_command_line(option + ": no " + thing, "it has a name", "");
  return text(option);
}

CommonOptions Given::common(int digits_otherwise, std::initializer_list<Format> formats, int most) const {
  const int wanted = digits(digits_otherwise, most);
  const std::string name = has("--format") ? text("--format") : "text";
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
  const std::string digits = text("--seed");
  const char* const end = digits.data() + digits.size();
  const auto [after, error] = std::from_chars(digits.data(), end, seed);
  if (error != std::errc() || after != end) {
    throw bad_command_line("--seed: out of range", "it is a whole number from 0 to 2^64-1", digits);
  }
  return seed;
}

Option problem_argument() { return {"PROBLEM", "", "Problem file, or -", Option::Kind::required}; }
Option certify_option(const std::string& what) { return {"--certify", "", what, Option::Kind::flag}; }
Option seed_option() { return {"--seed", "N", "Seed of the random parameters, a whole number"}; }
Option jobs_option(const std::string& what) {
  return {"--jobs", "N", fmt::format("{} at a time, 1 to {}; default: one on each core", what, most_jobs)};
}
Option folder_option() { return {"-o,--output", "DIR", "Write into DIR, which is made if need be; default: here"}; }

std::vector<Option> with_common(std::vector<Option> options, const std::string& digits,
                                std::initializer_list<Format> formats) {
  std::vector<std::string> names = names_of(formats);
  const std::string choices = fmt::format("{}", fmt::join(names, " "));
  const std::string last = names.back();
  names.pop_back();
  options.push_back({"--digits", "N", digits});
  options.push_back(
      {"--format", "FORMAT", fmt::format("{} or {}", fmt::join(names, ", "), last), Option::Kind::text, choices});
  options.push_back({"-o,--output", "FILE", "Write to FILE, whole or not at all; default: standard output"});
  return options;
}

std::vector<Rational> parse_list(const std::string& option, std::string_view text, std::size_t most) {
  return checked(option, [&] { return library::parse_list(text, most); });
}

int run_program(const Program& program, int argc, const char* const* argv) {
  const auto failed = [](ExitCode code, const std::string& message) {
    print_message(message);
    return static_cast<int>(code);
  };
  handle_signals();
  try {
    return static_cast<int>(run_command(program, argc, argv));
  } catch (const Failure& failure) {
    return failed(failure.code(), failure.what());
  } catch (const InvalidFile& invalid) {
    return failed(ExitCode::bad_input, invalid.what());
  } catch (const UnreadableFile& file) {
    return failed(ExitCode::failed, file.what());
  } catch (const std::bad_alloc&) {
    return failed(ExitCode::failed, "out of memory");
  } catch (const std::exception& error) {
    return failed(ExitCode::failed, fmt::format("internal failure: {}", error.what()));
  }
}

}  // namespace steadyslide::app
