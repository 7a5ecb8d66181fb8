#include "library/problem_file/friction_table.hpp"

#include "library/problem_file/file_error.hpp"
#include "support/test.hpp"

using namespace steadyslide::library;

namespace {

FrictionProfile read(const std::string& text, const Rational& unit = 1) {
  return parse_friction_table(text, "f.csv", {-1, 1}, unit);
}

const FrictionProfile expected({0.1_r, 0.5_r}, {0.25_r});

}  // namespace

TEST_CASE("friction holds from its x to the next; rows outside the support are left out") {
  CHECK(read("-1,0.1\n0.25,0.5\n") == expected);
  CHECK(read("x;f\n-3;0.9\n-2;1/10\n0.25;0.5 # the last one\n") == expected);
  CHECK(read("-1,0.1\n0.25,0.5\n1,0.7\n2,0.8\n") == expected);
  CHECK(read("-1000 0.1\n250 0.5\n", 0.001_r) == expected);
  CHECK(read("-1,0.1\n") == FrictionProfile({0.1_r}));
  // Equal neighbours stay, as values of a problem file do.
  CHECK(read("-1,0.1\n0,0.1\n") == FrictionProfile({0.1_r, 0.1_r}, {0_r}));
  CHECK_FALSE(read("-1,0.1\n0.25,0.4\n") == expected);
}

TEST_CASE("bad friction tables: the whole message") {
  const std::vector<std::pair<std::string, std::string>> rows{
      {"", "1: no friction value; there is at least one line x,f; 0 lines"},
      {"x,f\n", "1: no friction value; there is at least one line x,f; 0 lines"},
      {"x,f\n-0.5,0.1\n", "2: x: friction begins inside the support; the first x is at most the left end, -1; -0.5"},
      {"-1,0.1\n0,0.2\n0,0.3\n", "3: x: not increasing; x increases from line to line; 0 after 0"},
      {"-1,0.1\n0,-0.2\n", "2: f: negative friction coefficient; a friction coefficient is at least 0; -0.2"},
      {"-1,0.1\n2,-0.2\n", "2: f: negative friction coefficient; a friction coefficient is at least 0; -0.2"},
      {"-1,0.1\n0,high\n", "2: f: not a number; a number is written like 2, -0.25, 1e-3 or 1/3; 'high'"},
      {"-1,0.1,2\n", "1: wrong number of columns; a line of a friction table is x,f; 3 columns"},
  };
  for (const auto& row : rows) {
    CHECK_THROWS_WITH_AS_MESSAGE(read(row.first), ("f.csv:" + row.second).c_str(), InvalidFile, row.first);
  }
  std::string many;
  for (std::size_t k = 0; k <= max_friction_values; ++k) many += std::to_string(k) + "e-6,0.1\n";
  CHECK_THROWS_WITH_AS(parse_friction_table(many, "f.csv", {0, 1}, 1),
                       "f.csv:90001: too many rows; a friction table has at most 90000; more", InvalidFile);
}
