// error_estimates [FAMILY] FIRST COUNT: compares COUNT random problems from number FIRST on in double with 50 digits.
// They are from the usual list or from a family of support/random_contact.hpp. Prints a line for every estimate smaller
// than the true error, then a table. Exit code 1 if the estimates have a fault.

#include <cstdlib>
#include <iostream>

#include "known_limits/error_estimates.hpp"
#include "support/random_contact.hpp"

int main(int count, char** arguments) {
  using namespace steadyslide::testing;
  const auto family = count == 4 ? contact_family(arguments[1]) : ContactFamily::usual;
  if ((count != 3 && count != 4) || !family) {
    std::cerr << "usage: error_estimates [FAMILY] FIRST COUNT\nfamilies:";
    for (const auto& [number, name] : contact_families) std::cerr << ' ' << name;
    std::cerr << '\n';
    return 2;
  }
  arguments += count - 3;
  const std::uint64_t first = first_listed_seed + std::strtoull(arguments[1], nullptr, 10);
  const std::uint64_t last = first + std::strtoull(arguments[2], nullptr, 10);
  EstimateAudit audit;
  std::size_t told = 0, different = 0;
  for (std::uint64_t seed = first; seed < last; ++seed) {
    audit_estimates(seed, audit, *family);
    for (; told < audit.dishonest.size(); ++told) std::cout << audit.dishonest[told] << std::endl;
    for (; different < audit.different.size(); ++different) std::cout << audit.different[different] << std::endl;
  }
  std::cout << audit.text();
  const std::string failure = audit.failure(largest_median(*family));
  if (failure.empty()) return 0;
  std::cout << failure << '\n';
  return 1;
}
