#pragma once
// Random decimals that are the same on every machine, in every language.
//
//   x_k = from + (to - from) floor(u_k 10^12 / 2^64) / 10^12,   k = 0, 1, ...
//
// u_k are the numbers of SplitMix64 [SLF14] that starts from seed XOR fnv1a(name): so data with the same seed have
// different numbers.

#include <cstdint>
#include <string_view>
#include <vector>

#include "model/rational.hpp"

namespace steadyslide::library {

/// Returns the 64-bit FNV-1a hash of the bytes. `hash` is the hash of the bytes before them.
std::uint64_t fnv1a(std::string_view bytes, std::uint64_t hash = 0xcbf29ce484222325U);

/// Returns `count` numbers in [from, to[, exact. They are decimals if from and to are.
std::vector<Rational> random_decimals(std::string_view name, std::uint64_t seed, const Rational& from,
                                      const Rational& to, std::size_t count);

}  // namespace steadyslide::library
