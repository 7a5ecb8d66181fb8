// Tables of places that are refused: --at-file.

#include "app/command_line.hpp"

namespace {

void check_file(const std::string& text, const std::string& message) {
  CAPTURE(text);
  const TemporaryFolder folder{{"at.txt", text}};
  const Finished finished = folder.run({"solve", "-", "--at-file", "at.txt", "-o", "out.txt"}, problem_text("punch"));
  check_refused(finished, "at.txt:" + message);
  CHECK(folder.names() == std::vector<std::string>{"at.txt"});
}

}  // namespace

TEST_CASE("files of places that are refused, with the line") {
  check_file("", "1: no places; there is at least one line x; 0 places");
  check_file("# nothing\n\nx\n", "3: no places; there is at least one line x; 0 places");
  check_file("x\n0\nhere\n", "3: x: not a number; a number is written like 2, -0.25, 1e-3 or 1/3; 'here'");
  check_file("0\nx\n", "2: x: not a number; a number is written like 2, -0.25, 1e-3 or 1/3; 'x'");
  check_file("0,1\n", "1: wrong number of columns; a line of a table of places is x; 2 columns");
  check_file("0\n1 2\n", "2: wrong number of columns; a line of a table of places is x; 2 columns");
  check_file("0\n0;5\n", "2: wrong number of columns; a line of a table of places is x; 2 columns");
  check_file(std::string("0\n1\0\n", 5), "2: not a text; a table of places has no NUL bytes; '1\\x00'");
  check_file("0\n" + std::string(1001, ' ') + "\n",
             "2: line too long; a line of a table of places has at most 1000 characters; 1001 characters");
  std::string many;
  for (int i = 0; i <= 100000; ++i) many += "0\n";
  check_file(many, "100001: too many places; there are at most 100000; more");
}

TEST_CASE("a file of places that is not there") {
  check_refused(run(problem_text("punch"), {"--at-file", "none.txt"}),
                "none.txt: cannot be read: No such file or directory", 3);
}
