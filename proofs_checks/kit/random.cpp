#include "proofs_checks/kit/random.hpp"

#include <array>

namespace steadyslide::proofs_checks {

Random::Random(std::uint64_t seed, std::string_view stream) {
  // FNV-1a hash of the stream's name.
  std::uint64_t hash = 14695981039346656037U;
  for (const char c : stream) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211U;
  engine_.seed(seed * 0x9E3779B97F4A7C15U + hash);
}

std::size_t Random::below(std::size_t count) { return static_cast<std::size_t>(engine_() % count); }

Rational Random::between(const Rational& low, const Rational& high) {
  constexpr std::array<std::size_t, 4> denominators{7, 64, 1000, 9973};
  const std::size_t q = denominators[below(denominators.size())];
  const std::size_t p = 1 + below(q - 1);
  return low + (high - low) * Rational(static_cast<long>(p), static_cast<long>(q));
}

std::vector<Rational> Random::between(const Rational& low, const Rational& high, std::size_t count) {
  std::vector<Rational> all;
  while (all.size() < count) all.push_back(between(low, high));
  return all;
}

Rational Random::poisson() {
  switch (below(8)) {
    case 0: return Rational(-1) + between(0, Rational(1, 1000));
    case 1: return Rational(1, 2) - between(0, Rational(1, 1000));
    default: return between(-1, Rational(1, 2));
  }
}

Rational Random::friction(const Rational& largest) {
  constexpr std::array<int, 3> parts{50, 10, 1};
  const std::size_t kind = below(10);
  return kind == 0 ? Rational(0) : between(0, largest / parts[kind % 3]);
}

}  // namespace steadyslide::proofs_checks
