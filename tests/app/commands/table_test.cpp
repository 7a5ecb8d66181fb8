#include <chrono>

#include "app/json_answers.hpp"

namespace {

Finished table(const Arguments& more) { return run_alone(joined({"table"}, more)); }

}  // namespace

TEST_CASE("one row per combination, poisson slowest, front fastest") {
  const Finished finished = table({"--poisson=-0.5,0", "--rear", "0,1", "--front", "0:2:1", "--format", "csv"});
  CHECK(finished.code == 0);
  const auto rows = lines(finished.out);
  REQUIRE(rows.size() == 13);
  CHECK(rows[0] == "nu,f_rear,f_front,gamma,alpha_rear,alpha_front,beta,edge_rear,edge_front,free_rear,free_front");
  CHECK(rows[1].starts_with("-0.5,0,0,"));
  CHECK(rows[2].starts_with("-0.5,0,1,"));
  CHECK(rows[4].starts_with("-0.5,1,0,"));
  CHECK(rows[7].starts_with("0,0,0,"));
  CHECK(rows[12].starts_with("0,1,2,"));
  // nu = 0: gamma = 1/2, and f = 2 makes s = 1, alpha = 1/4: every digit is known.
  CHECK(lines(table({"--poisson", "0", "--rear", "2", "--front", "0", "--digits", "50", "--format", "csv"}).out)[1] ==
        "0,2,0,0.5,0.25,0,0.25,-0.75,-0.5,0.25,0.5");
  CHECK(lines(table({"--poisson", "0", "--rear", "0", "--front", "2", "--digits", "100", "--format", "csv"}).out)[1] ==
        "0,0,2,0.5,0,0.25,-0.25,-0.5,-0.25,0.5,0.75");
}

TEST_CASE("text is aligned") {
  const Finished text = table({"--poisson", "0.3", "--rear", "0,0.2", "--front", "0.6"});
  const auto rows = lines(text.out);
  REQUIRE(rows.size() == 3);
  for (const char* column : {"f_rear", "beta", "edge_front"}) {
    const std::size_t at = rows[0].find(column);
    for (const std::string& row : rows) {
      CHECK(row[at - 1] == ' ');
      CHECK(row[at] != ' ');
    }
  }
}

TEST_CASE("8820 rows of 30 digits in less than two seconds") {
  const auto start = std::chrono::steady_clock::now();
  const Finished finished = table(
      {"--poisson=-0.5:0.45:0.05", "--rear", "0:2:0.1", "--front", "0:2:0.1", "--digits", "30", "--format", "csv"});
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  CHECK(finished.code == 0);
  CHECK(lines(finished.out).size() == 8821);
#ifndef __SANITIZE_ADDRESS__
  CHECK(elapsed.count() < 2);
#endif
}
