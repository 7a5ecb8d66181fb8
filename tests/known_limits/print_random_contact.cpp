// random_contact SEED: a problem of the random list, as a problem file.

#include <cstdlib>
#include <iostream>

#include "support/problem_toml.hpp"
#include "support/random_contact.hpp"

int main(int count, char** arguments) {
  if (count != 2) {
    std::cerr << "usage: random_contact SEED\n";
    return 2;
  }
  const std::uint64_t seed = std::strtoull(arguments[1], nullptr, 10);
  std::cout << "# random_contact " << seed << '\n'
            << steadyslide::testing::problem_toml(steadyslide::testing::random_contact(seed));
}
