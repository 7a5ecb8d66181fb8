#include <chrono>

#include "app/command_line.hpp"

TEST_CASE("8820 rows of 30 digits in less than two seconds") {
  const auto start = std::chrono::steady_clock::now();
  const Finished finished = run_alone(arguments_of(
      "steadyslide table --poisson=-0.5:0.45:0.05 --rear 0:2:0.1 --front 0:2:0.1 --digits 30 --format csv"));
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  CHECK(finished.code == 0);
  CHECK(lines(finished.out).size() == 8821);
#ifndef __SANITIZE_ADDRESS__
  CHECK(elapsed.count() < 2);
#endif
}
