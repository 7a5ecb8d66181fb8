// error_estimates FIRST COUNT: random problems number FIRST and on, in double beside 50 digits. Every estimate that does
// not cover the true error is a line, then a table. Exit code 1 if that is not what estimates have to be.

#include <cstdlib>
#include <iostream>

#include "known_limits/error_estimates.hpp"
#include "support/random_contact.hpp"

int main(int count, char** arguments) {
  using namespace steadyslide::testing;
  if (count != 3) {
    std::cerr << "usage: error_estimates FIRST COUNT\n";
    return 2;
  }
  const std::uint64_t first = first_listed_seed + std::strtoull(arguments[1], nullptr, 10);
  const std::uint64_t last = first + std::strtoull(arguments[2], nullptr, 10);
  EstimateAudit audit;
  std::size_t told = 0, different = 0;
  for (std::uint64_t seed = first; seed < last; ++seed) {
    audit_estimates(seed, audit);
    for (; told < audit.dishonest.size(); ++told) std::cout << audit.dishonest[told] << std::endl;
    for (; different < audit.different.size(); ++different) std::cout << audit.different[different] << std::endl;
  }
  std::cout << audit.text();
  if (audit.failure().empty()) return 0;
  std::cout << audit.failure() << '\n';
  return 1;
}
