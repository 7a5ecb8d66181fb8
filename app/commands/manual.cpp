#include "app/commands/manual.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <boost/algorithm/string/case_conv.hpp>
#include <boost/algorithm/string/replace.hpp>

#include "app/embedded.hpp"

namespace steadyslide::app {
namespace {

/// Escapes the special characters of roff, anywhere in a line.
std::string roff(std::string text) {
  boost::replace_all(text, "\\", "\\e");
  boost::replace_all(text, "-", "\\-");
  for (const char* sign : {".", "'"}) {
    boost::replace_all(text, std::string("\n") + sign, std::string("\n\\&") + sign);
    if (text.starts_with(sign)) text.insert(0, "\\&");
  }
  return text;
}

/// Returns lines, tables among them, that man shows as they are.
std::string verbatim(std::string_view text) {
  const std::size_t end = text.find_last_not_of('\n') + 1;
  return end == 0 ? "" : ".nf\n" + roff(std::string(text.substr(0, end))) + "\n.fi\n";
}

std::string entry(const Option& option) {
  const std::string value = option.value.empty() ? "" : " \\fI" + roff(option.value) + "\\fR";
  return ".TP\n\\fB" + roff(boost::replace_all_copy(option.name, ",", ", ")) + "\\fR" + value + "\n" +
         roff(option.help) + "\n";
}

bool is_option(const Option& option) { return option.name.starts_with('-'); }

/// Returns "-o" and "--output".
std::vector<std::string> names_in(const Option& option) {
  const std::size_t comma = option.name.find(',');
  if (comma == std::string::npos) return {option.name};
  return {option.name.substr(0, comma), option.name.substr(comma + 1)};
}

std::string synopsis(const Program& program, const Command& command) {
  std::string line = fmt::format(".B {} {}\n", roff(program.name), roff(command.name));
  line += "[\\fIOPTIONS\\fR]";
  for (const Option& option : command.options) {
    if (!is_option(option)) line += " \\fI" + roff(option.name) + "\\fR";
  }
  return line + "\n";
}

}  // namespace

std::string manual_page(const Program& program) {
  const std::string upper = boost::to_upper_copy(program.name);
  std::string page =
      fmt::format(".TH {} 1 {} \"steadyslide {}\" \"User Commands\"\n", roff(upper), version_date, version);
  page += fmt::format(".SH NAME\n{} \\- steady sliding contact with a discontinuous friction coefficient\n",
                      roff(program.name));
  page += ".SH SYNOPSIS\n";
  for (const Command& command : program.commands) page += synopsis(program, command) + ".br\n";
  page += fmt::format(".B {}\n\\fB\\-\\-help\\fR | \\fB\\-\\-version\\fR | \\fB\\-\\-generate\\fR \\fIKIND\\fR\n",
                      roff(program.name));
  page += ".SH DESCRIPTION\n" + roff(program.description) + "\n.SH COMMANDS\n";
  for (const Command& command : program.commands) {
    const std::size_t end = command.help.find("\n\n");
    page += ".SS " + roff(command.name) + "\n" + roff(command.help.substr(0, end)) + "\n";
    for (const Option& option : command.options) page += entry(option);
    const std::string below = verbatim(std::string_view(command.help).substr(end + 2));
    if (!below.empty()) page += ".PP\n" + below;
    if (!command.manual.empty()) page += ".PP\n" + verbatim(command.manual);
  }
  return page + ".SH CONVENTIONS\n" + verbatim(embedded::help_program);
}

std::string bash_completion(const Program& program) {
  std::vector<std::string> commands, options, words;
  for (const Command& command : program.commands) {
    commands.push_back(command.name);
    std::vector<std::string> names{"--help"};
    for (const Option& option : command.options) {
      if (!is_option(option)) continue;
      std::ranges::copy(names_in(option), std::back_inserter(names));
      if (option.choices.empty()) continue;
      words.push_back(fmt::format("    '{} {}') words='{}' ;;", command.name, names_in(option).back(), option.choices));
    }
    options.push_back(fmt::format("    {}) words='{}' ;;", command.name, fmt::join(names, " ")));
  }
  const std::string function = "_" + boost::replace_all_copy(program.name, "-", "_");
  return fmt::format(R"(# bash completion for {0} {1}
{2}() {{
  local word=${{COMP_WORDS[COMP_CWORD]}} before=${{COMP_WORDS[COMP_CWORD - 1]}} command=${{COMP_WORDS[1]}} words=''
  COMPREPLY=()
  if ((COMP_CWORD == 1)); then
    mapfile -t COMPREPLY < <(compgen -W '{3} --help --version --generate' -- "$word")
    return
  fi
  case "$command $before" in
    '--generate --generate') words='man bash' ;;
{4}
  esac
  if [[ $words == '' && $word == -* ]]; then
    case $command in
{5}
    esac
  fi
  [[ $words == '' ]] || mapfile -t COMPREPLY < <(compgen -W "$words" -- "$word")
}}
complete -o default -F {2} {0}
)",
                     program.name, version, function, fmt::join(commands, " "), fmt::join(words, "\n"),
                     fmt::join(options, "\n"));
}

}  // namespace steadyslide::app
