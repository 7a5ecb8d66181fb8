// Bad problem files: the whole message and the exit code of each. There is no output file.

#include <regex>

#include "app/changed_files.hpp"
#include "app/command_line.hpp"

namespace {

const std::string good =
    "load = \"1\"\n[half_space]\npoisson = \"0.3\"\n[friction]\nvalues = [\"0.2\"]\n[indenter]\nprofile = \"0\"\n";

}  // namespace

TEST_CASE("bad problem files: message, exit code, no output") {
  auto files = changed_files(STEADYSLIDE_TESTS "/app/problem_file/bad_files.txt");
  CHECK(files.size() >= 70);
  files.emplace_back(
      "1: not TOML; a problem file is written in TOML; Error while parsing key-value pair: encountered "
      "end-of-file",
      "load = ");
  for (const auto& file : files) {
    CAPTURE(file.second);
    const TemporaryFolder folder{{"bad.toml", file.second}, {"trace.csv", "-1,1/4\n0,0\n1,1/2\n"}};
    check_refused(folder.run({"exponents", "bad.toml", "-o", "result"}), "bad.toml:" + file.first);
    CHECK(folder.names() == std::vector<std::string>{"bad.toml", "trace.csv"});
  }
}

TEST_CASE("bad input leaves the result of an earlier run alone") {
  const TemporaryFolder folder{{"bad.toml", "load = "}, {"result", "earlier"}};
  CHECK(folder.run({"solve", "bad.toml", "-o", "result"}).code == 2);
  CHECK(folder.read("result") == "earlier");
}

TEST_CASE("messages name the standard input -") {
  check_refused(run_alone({"exponents", "-"}, replaced(good, "\"1\"", "0")),
                "-:1: load: load out of range; the load is positive; 0");
}

TEST_CASE("CRLF, a byte order mark and a missing last line end are allowed") {
  const std::string plain = out_of(run_alone({"exponents", "-"}, good));
  const std::string crlf = std::regex_replace(good, std::regex("\n"), "\r\n");
  for (const std::string& same : {crlf, "\xef\xbb\xbf" + good, good.substr(0, good.size() - 1)}) {
    CHECK(run_alone({"exponents", "-"}, same).out == plain);
  }
}
