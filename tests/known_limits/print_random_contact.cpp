// random_contact [FAMILY] SEED: prints a problem of the random list, or of a family of support/random_contact.hpp, as a
// problem file.

#include <cstdlib>
#include <iostream>

#include "support/problem_toml.hpp"
#include "support/random_contact.hpp"

int main(int count, char** arguments) {
  using namespace steadyslide::testing;
  const auto family = count == 3 ? contact_family(arguments[1]) : ContactFamily::usual;
  if ((count != 2 && count != 3) || !family) {
    std::cerr << "usage: random_contact [FAMILY] SEED\n";
    return 2;
  }
  const std::uint64_t seed = std::strtoull(arguments[count - 1], nullptr, 10);
  std::cout << "# random_contact";
  for (int i = 1; i < count; ++i) std::cout << ' ' << arguments[i];
  std::cout << '\n' << problem_toml(random_contact(seed, *family));
}
