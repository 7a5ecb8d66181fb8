// The answers of commands: tests/app/commands/answers.txt and example_answers.txt. These files describe their format.

#include <regex>

#include "app/json_answers.hpp"

namespace {

/// Returns the values without their errors.
Json values_of(const Json& json) {
  if (is_number(json) || !json.is_structured()) return value_of(json);
  Json result = json;
  for (Json& part : result) part = values_of(part);
  return result;
}

std::string part_of(const Finished& answer, const std::string& what) {
  if (what == "code") return std::to_string(answer.code);
  if (what == "out") return answer.out;
  if (what == "err") return answer.err;
  const std::vector<std::string> rows = lines(answer.out);
  if (what == "lines") return std::to_string(rows.size());
  const std::string where = what.substr(what.find_first_of(":/") + (what.starts_with("/") ? 0 : 1));
  if (what.starts_with("line:")) return rows.at(std::stoul(where));
  if (what.starts_with("commas:")) return std::to_string(times(rows.at(std::stoul(where)), ","));
  const Json whole = Json::parse(answer.out).at(Json::json_pointer(where)), json = values_of(whole);
  if (what.starts_with("keys:")) return keys(whole);
  if (!what.starts_with("size:")) return json.dump();
  return std::to_string(json.is_string() ? json.get<std::string>().size() : json.size());
}

/// Reads the number in a text with or without quotes.
Rational number_of(std::string text) {
  std::erase(text, '"');
  return parse_rational(text);
}

bool holds_for(const std::string& found, const std::string& relation, const std::string& value) {
  if (relation == "=") return found == value;
  if (relation == "starts") return found.starts_with(value);
  if (relation == "ends") return found.ends_with(value);
  if (relation == "holds") return holds(found, value);
  if (relation == "lacks") return !holds(found, value);
  if (relation == "differs") return found != value;
  const std::size_t tolerance = value.find(" +- ");
  const Rational number = number_of(found), expected = number_of(value.substr(0, tolerance));
  if (relation == "<") return number < expected;
  if (relation == ">") return number > expected;
  REQUIRE((relation == "~" || relation == "off"));
  return (abs(number - expected) <= parse_rational(value.substr(tolerance + 4))) == (relation == "~");
}

/// Checks one line of answers.txt, for example "/contact/0/left/kind = ...". `that` means a part of the answer
/// `beside`.
bool is_so(const Finished& answer, const std::string& expected, const Finished& beside = {}) {
  const std::size_t space = expected.find(' '), next = std::min(expected.find(' ', space + 1), expected.size());
  const std::string what = expected.substr(0, space), relation = expected.substr(space + 1, next - space - 1);
  std::string value = next == expected.size() ? "" : expected.substr(next + 1);
  if (!holds(what, "/")) value = std::regex_replace(value, std::regex("\\\\n"), "\n");
  if (value.starts_with("that")) value = part_of(beside, what) + value.substr(4);
  return holds_for(part_of(answer, what), relation, value);
}

/// Expands "/{a,b}/{x,y}" to four parts of an answer.
std::vector<std::string> expanded(const std::string& part) {
  std::vector<std::string> parts{part};
  while (holds(parts.front(), "{")) {
    std::vector<std::string> next;
    for (const std::string& one : parts) {
      for (const auto& [chosen, name] : choices(one)) next.push_back(chosen);
    }
    parts = next;
  }
  return parts;
}

/// Checks the answers of `steadyslide COMMAND`. Returns the number of command lines.
int check_answers(const std::string& command_name, const std::string& file, const std::string& folder) {
  std::map<std::string, std::vector<std::string>> expected;
  std::vector<std::pair<std::string, std::string>> commands;
  for (const std::string& line : lines(file_text(STEADYSLIDE_TESTS "/app/commands/" + file))) {
    if (line.starts_with("steadyslide ")) commands = choices(line);
    if (!line.starts_with("    ")) continue;
    const std::size_t space = line.find(' ', 4);
    for (const auto& [command, name] : commands) {
      if (!command.starts_with("steadyslide " + command_name + " ")) continue;
      for (const std::string& part : expanded(line.substr(4, space - 4))) {
        expected[command].push_back(part + filled(line.substr(space), name));
      }
    }
  }
  for (const auto& of_line : expected) {
    const std::string& line = of_line.first;
    const std::vector<std::string>& parts = of_line.second;
    CAPTURE(line);
    const Finished answer = run_program(arguments_of(line), folder);
    const auto said = [&](const char* what) {
      return std::ranges::any_of(parts, [&](const std::string& part) { return part.starts_with(what); });
    };
    if (!said("code ")) CHECK(answer.code == 0);
    if (!said("err ")) CHECK(answer.err == "");
    Finished beside;
    for (const std::string& part : parts) {
      if (!part.starts_with("beside ")) {
        CHECK_MESSAGE(is_so(answer, part, beside), part << "; not " << part_of(answer, part.substr(0, part.find(' '))));
        continue;
      }
      beside = run_program(arguments_of(part.substr(7)), folder);
      CHECK(beside.code == 0);
    }
  }
  return static_cast<int>(expected.size());
}

int among_the_problems(const std::string& command) {
  return check_answers(command, "answers.txt", STEADYSLIDE_TESTS "/app/commands/problems");
}

}  // namespace

TEST_CASE("answers: exponents") { CHECK(among_the_problems("exponents") >= 9); }
TEST_CASE("answers: table") { CHECK(among_the_problems("table") >= 7); }
TEST_CASE("answers: design") { CHECK(among_the_problems("design") >= 10); }
TEST_CASE("answers: verify") { CHECK(among_the_problems("verify") >= 2); }
TEST_CASE("answers: solve") { CHECK(among_the_problems("solve") >= 42); }

TEST_CASE("answers: the examples, solved") {
  CHECK(check_answers("solve", "example_answers.txt", STEADYSLIDE_EXAMPLES) >= 27);
}

TEST_CASE("control: a wrong answer is noticed") {
  const Finished answer{0, "{\"a\":{\"b\":{\"value\":\"0.3\",\"error\":\"1\"}},\"c\":[1]}\n", ""};
  CHECK(is_so(answer, "/a/b ~ 0.31 +- 0.01"));
  for (const char* wrong :
       {"/a/b ~ 0.311 +- 0.01", "/a/b off 0.31 +- 0.01", "/a/b = \"0.31\"", "/a/b > 0.3", "/a/b < 0.3",
        "/a/b/error < 1", "keys: = a", "size:/c = 2", "size:/a/b = 5", "/a differs {\"b\":\"0.3\"}", "out starts {}",
        "out ends }", "out holds 0.31", "out lacks 0.3"}) {
    CHECK_FALSE_MESSAGE(is_so(answer, wrong), wrong);
  }
}
