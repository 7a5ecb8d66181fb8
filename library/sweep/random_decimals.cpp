#include "library/sweep/random_decimals.hpp"

namespace steadyslide::library {
namespace {

std::uint64_t next_of(std::uint64_t& state) {
  std::uint64_t z = state += 0x9e3779b97f4a7c15U;
  z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
  z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
  return z ^ (z >> 31U);
}

}  // namespace

std::uint64_t fnv1a(std::string_view bytes, std::uint64_t hash) {
  for (const char byte : bytes) hash = (hash ^ static_cast<unsigned char>(byte)) * 0x100000001b3U;
  return hash;
}

std::vector<Rational> random_decimals(std::string_view name, std::uint64_t seed, const Rational& from,
                                      const Rational& to, std::size_t count) {
  const Integer parts = 1000000000000;
  std::uint64_t state = seed ^ fnv1a(name);
  std::vector<Rational> result;
  while (result.size() < count) {
    const Integer part = (Integer(next_of(state)) * parts) >> 64;
    result.push_back(from + (to - from) * Rational(part, parts));
  }
  return result;
}

}  // namespace steadyslide::library
