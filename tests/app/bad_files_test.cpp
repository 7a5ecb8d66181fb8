// Bad problem files: the whole message and the exit code of each, and no output file.

#include <regex>

#include "app/command_line.hpp"

namespace {

struct BadFile {
  std::string text;
  std::string message;  ///< after "steadyslide: bad.toml:"
};

/// problem_file/bad_files.txt, and a file that ends within a line.
std::vector<BadFile> bad_files() {
  std::vector<BadFile> files{{"load = ",
                              "1: not TOML; a problem file is written in TOML; Error while parsing key-value pair: "
                              "encountered end-of-file"}};
  for (const std::string& line : lines(file_text(STEADYSLIDE_TESTS "/app/problem_file/bad_files.txt"))) {
    if (line.starts_with("=== ")) {
      files.push_back({"", line.substr(4)});
    } else if (files.size() > 1) {
      files.back().text += line + '\n';
    }
  }
  return files;
}

const std::string good =
    "load = \"1\"\n[half_space]\npoisson = \"0.3\"\n[friction]\nvalues = [\"0.2\"]\n[indenter]\nprofile = \"0\"\n";

}  // namespace

TEST_CASE("bad problem files: message, exit code, no output") {
  const std::vector<BadFile> files = bad_files();
  CHECK(files.size() >= 67);
  for (const BadFile& bad : files) {
    CAPTURE(bad.text);
    const TemporaryFolder folder;
    folder.write("bad.toml", bad.text);
    check_refused(run_program({"exponents", "bad.toml", "-o", "result"}, folder.path()), "bad.toml:" + bad.message);
    CHECK(folder.names() == std::vector<std::string>{"bad.toml"});
  }
}

TEST_CASE("bad input leaves the result of an earlier run alone") {
  const TemporaryFolder folder;
  folder.write("bad.toml", "load = ");
  folder.write("result", "earlier");
  CHECK(run_program({"solve", "bad.toml", "-o", "result"}, folder.path()).code == 2);
  CHECK(folder.read("result") == "earlier");
}

TEST_CASE("the standard input is called -") {
  check_refused(run_alone({"exponents", "-"}, replaced(good, "\"1\"", "0")),
                "-:1: load: load out of range; the load is positive; 0");
}

TEST_CASE("files with what every file may have are read") {
  const std::string plain = out_of(run_alone({"exponents", "-"}, good));
  const std::string crlf = std::regex_replace(good, std::regex("\n"), "\r\n");
  for (const std::string& same : {crlf, "\xef\xbb\xbf" + good, good.substr(0, good.size() - 1)}) {
    CHECK(run_alone({"exponents", "-"}, same).out == plain);
  }
}
