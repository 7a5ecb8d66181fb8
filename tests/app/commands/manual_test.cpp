// --generate: the manual page and the completions have all the content of --help.

#include <regex>

#include "app/command_line.hpp"

namespace {

const std::vector<std::string> command_names = words("verify exponents table solve design sweep wear figures report");

/// Returns the options in --help of a command.
std::set<std::string> options_of(const std::string& command) {
  const std::string help = out_of(run_alone({command, "--help"}));
  const std::string list = help.substr(help.find("\nOptions:\n"), help.find("\n\n", help.find("\nOptions:\n")));
  std::set<std::string> options;
  static const std::regex name("(--[a-z-]+|-[a-z])[ ,]");
  for (const std::string& line : lines(list)) {
    if (!line.starts_with("  -")) continue;
    const std::string names = line.substr(0, 28);
    for (std::sregex_iterator at(names.begin(), names.end(), name), end; at != end; ++at) options.insert((*at)[1]);
  }
  return options;
}

/// Returns bash's completions of these words; the last word is incomplete.
std::set<std::string> offered(const TemporaryFolder& folder, const std::string& words, int last) {
  const std::string script = "source ./completion; COMP_WORDS=(" + words + "); COMP_CWORD=" + std::to_string(last) +
                             "; _steadyslide; printf '%s\\n' \"${COMPREPLY[@]}\"";
  const std::vector<std::string> found = lines(out_of(run_other({"bash", "-uc", script}, folder.path())));
  std::set<std::string> result(found.begin(), found.end());
  result.erase("");
  return result;
}

}  // namespace

TEST_CASE("the manual page has every command, its options and the text below them") {
  const std::string page = out_of(run_alone({"--generate", "man"}));
  CHECK(std::regex_search(page, std::regex("^\\.TH STEADYSLIDE 1 [-0-9]{10} \"steadyslide " STEADYSLIDE_VERSION "\"")));
  std::string plain = std::regex_replace(page, std::regex("\\\\f[BIR]"), "");
  for (const auto& [sign, meant] : {std::pair("\\\\-", "-"), {"\\\\&", ""}, {"\\\\e", "\\"}}) {
    plain = std::regex_replace(plain, std::regex(sign), meant);
  }
  for (const std::string& command : command_names) {
    CAPTURE(command);
    const std::size_t begin = plain.find("\n.SS " + command + "\n");
    REQUIRE(begin != std::string::npos);
    const std::string section = plain.substr(begin, plain.find("\n.S", begin + 1) - begin);
    const std::set<std::string> options = options_of(command);
    CHECK(options.size() >= 3);
    for (std::string option : options) {
      if (option == "-h" || option == "--help") continue;
      CHECK_MESSAGE((holds(section, "\n" + option) || holds(section, ", " + option)), option);
    }
    // Every line of the help that is not an option, in order.
    const std::string help = out_of(run_alone({command, "--help"}));
    CHECK(lines(help).size() <= 80);  // two screens
    const std::size_t below = help.find("\n\n", help.find("\nOptions:\n"));
    const std::size_t pointer =
        help.find("\n\nThe problem file, every result, unit and column: steadyslide --generate man");
    CHECK((pointer != std::string::npos) == (command == "solve"));
    const std::size_t end = std::min(pointer, help.find_last_not_of('\n') + 1);
    CHECK(holds(section, help.substr(below + 2, end - below - 2)));
  }
  check_holds(plain, {"\n.SH CONVENTIONS\n", "Exit code  0 done", "until_load, status, event"});
  // No line of text is taken for a request of roff.
  for (const std::string& line : lines(page)) {
    if (line.starts_with("."))
      CHECK_MESSAGE(std::regex_search(line, std::regex("^\\.(TH|SH|SS|TP|PP|B|br|nf|fi)\\b")), line);
  }
}

TEST_CASE("bash completes commands, options, and the values of an option") {
  const TemporaryFolder folder{{"completion", out_of(run_alone({"--generate", "bash"}))}};
  std::set<std::string> first(command_names.begin(), command_names.end());
  first.insert({"--help", "--version", "--generate"});
  CHECK(offered(folder, "steadyslide ''", 1) == first);
  CHECK(offered(folder, "steadyslide sol", 1) == std::set<std::string>{"solve"});
  for (const std::string& command : command_names) {
    CAPTURE(command);
    std::set<std::string> options = options_of(command);
    options.erase("-h");
    CHECK(offered(folder, "steadyslide " + command + " -", 2) == options);
  }
  CHECK(offered(folder, "steadyslide solve f.toml --format ''", 4) == std::set<std::string>{"text", "json", "csv"});
  CHECK(offered(folder, "steadyslide solve --method v", 3) == std::set<std::string>{"variational"});
  CHECK(offered(folder, "steadyslide --generate ''", 2) == std::set<std::string>{"man", "bash"});
  // bash itself completes file names.
  CHECK(offered(folder, "steadyslide solve two", 2).empty());
}
