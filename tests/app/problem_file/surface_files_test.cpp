// Tables of points, nodes and places. Bad ones: the whole message of each, and no output. Good ones: the allowed forms.

#include "app/command_line.hpp"
#include "support/rows.hpp"

namespace {

const std::string plain_punch =
    "load = 1\n[half_space]\npoisson = 0.3\n[friction]\nvalues = [0.2]\n[indenter]\nprofile = 0\n";

/// Checks the rows of a list: the text of a table, and the message after "t.csv:".
void check_bad_tables(const std::string& option, const std::string& list) {
  for (const auto& row : rows_of(STEADYSLIDE_TESTS "/app/problem_file/" + list)) {
    CAPTURE(row.first);
    const TemporaryFolder folder{{"p.toml", plain_punch}, {"t.csv", row.first}};
    check_refused(folder.run({"solve", "p.toml", option, "t.csv", "-o", "result"}), "t.csv:" + row.second);
    CHECK(folder.names() == std::vector<std::string>{"p.toml", "t.csv"});
  }
}

Finished run_on(const std::string& option, const std::string& table, const Arguments& more = {}) {
  const TemporaryFolder folder{{"p.toml", plain_punch}, {"t.csv", table}};
  return folder.run(joined({"solve", "p.toml", option, "t.csv"}, more));
}

}  // namespace

TEST_CASE("bad tables of points: message, exit code, no output") { check_bad_tables("--stress-at", "bad_points.json"); }

TEST_CASE("bad meshes: message, exit code, no output") { check_bad_tables("--loads-on", "bad_meshes.json"); }

TEST_CASE("bad tables of places: message, exit code, no output") { check_bad_tables("--at-file", "bad_places.json"); }

TEST_CASE("long lines, too many lines and files that are no tables are refused") {
  const auto refused = [](const std::string& option, const std::string& table, const std::string& message) {
    check_refused(run_on(option, table), message);
  };
  refused("--stress-at", "0," + std::string(1000, '1'),
          "t.csv:1: line too long; a line of a table of points has at most 1000 characters; 1002 characters");
  refused("--at-file", "0\n" + std::string(1001, ' ') + "\n",
          "t.csv:2: line too long; a line of a table of places has at most 1000 characters; 1001 characters");
  std::string nodes, places;
  for (int k = 0; k <= 1000000; ++k) nodes += std::to_string(k) + "\n";
  refused("--loads-on", nodes, "t.csv:1000001: too many nodes; there are at most 1000000; more");
  for (int k = 0; k <= 100000; ++k) places += "0\n";
  refused("--at-file", places, "t.csv:100001: too many places; there are at most 100000; more");
  const TemporaryFolder folder{{"p.toml", plain_punch}};
  for (const char* option : {"--stress-at", "--at-file"}) {
    check_refused(folder.run({"solve", "p.toml", option, "none.csv"}),
                  "none.csv: cannot be read: No such file or directory", 3);
  }
  check_refused(folder.run({"solve", "p.toml", "--loads-on", "."}), ".: cannot be read: Is a directory", 3);
}

TEST_CASE("headers, comments, semicolons, blanks, CRLF and a byte order mark are allowed") {
  const std::string plain = out_of(run_on("--stress-at", "0,0.5\n1/2,1\n", {"--format", "csv"}));
  for (const char* same :
       {"x,z\n0,0.5\n1/2,1", "\xef\xbb\xbfx;z\r\n0;0.5 # first\r\n\r\n0.5;1\r\n", "0 0.5\n5e-1\t1\n"}) {
    CHECK(out_of(run_on("--stress-at", same, {"--format", "csv"})) == plain);
  }
  CHECK(lines(plain).size() == 3);
  CHECK(lines(plain)[0] ==
        "x,z,sxx,szz,sxz,syy,von_mises,largest_shear,sxx_error,szz_error,sxz_error,syy_error,von_mises_error,"
        "largest_shear_error");
}
