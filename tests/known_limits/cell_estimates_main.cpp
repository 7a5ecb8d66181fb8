// cell_estimates FIRST COUNT [CELLS]: solves COUNT random problems from number FIRST on, on CELLS cells (default:
// 4096), and compares them with the Riemann-Hilbert method. Prints a line for every estimate smaller than the true
// error, then a table. Exit code 1 if the estimates have a fault (cell_failure).

#include <cstdlib>
#include <iostream>

#include "known_limits/cell_estimates.hpp"
#include "support/random_contact.hpp"

int main(int count, char** arguments) {
  using namespace steadyslide::testing;
  if (count != 3 && count != 4) {
    std::cerr << "usage: cell_estimates FIRST COUNT [CELLS]\n";
    return 2;
  }
  const std::uint64_t first = first_listed_seed + std::strtoull(arguments[1], nullptr, 10);
  const std::uint64_t last = first + std::strtoull(arguments[2], nullptr, 10);
  const std::size_t cells = count == 4 ? std::strtoull(arguments[3], nullptr, 10) : 4096;
  EstimateAudit audit;
  for (std::uint64_t seed = first; seed < last; ++seed) audit_cell_estimates(seed, cells, audit);
  for (const std::string& line : audit.dishonest) std::cout << line << '\n';
  std::cout << audit.text();
  const std::string failure = cell_failure(audit);
  if (failure.empty()) return 0;
  std::cout << failure << '\n';
  return 1;
}
