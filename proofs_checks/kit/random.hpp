#pragma once
// Random rational parameters, the same on every machine for the same seed.

#include <cstdint>
#include <random>
#include <string_view>
#include <vector>

#include "model/rational.hpp"

namespace steadyslide::proofs_checks {

class Random {
 public:
  /// Takes the seed and the name of a stream. Each claim has its own stream, so that its cases do not depend on the
  /// other claims of a run.
  Random(std::uint64_t seed, std::string_view stream);

  /// Returns a number from 0, ..., count - 1.
  std::size_t below(std::size_t count);
  /// Returns a rational strictly between low and high, with one of several denominators.
  Rational between(const Rational& low, const Rational& high);
  /// Returns `count` such rationals.
  std::vector<Rational> between(const Rational& low, const Rational& high, std::size_t count);
  /// Returns a Poisson's ratio nu in ]-1, 1/2[, sometimes close to an end.
  Rational poisson();
  /// Returns a coefficient of friction f in [0, largest], sometimes 0. Small values are as frequent as large ones.
  Rational friction(const Rational& largest);

 private:
  // The C++ standard prescribes the numbers of the engine, but not those of its distributions.
  std::mt19937_64 engine_;
};

}  // namespace steadyslide::proofs_checks
