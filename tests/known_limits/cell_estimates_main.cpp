// cell_estimates FIRST COUNT [CELLS]: random problems number FIRST and on, on 4096 cells or as many as said, beside the
// Riemann-Hilbert method. Every estimate that does not cover the true error is a line, then a table. Exit code 1 if that is not
// what estimates have to be.

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
