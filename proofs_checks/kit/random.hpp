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
  /// `stream` keeps the claims' parameters apart: a claim's cases do not depend on which others run.
  Random(std::uint64_t seed, std::string_view stream);

  /// 0, ..., count - 1.
  std::size_t below(std::size_t count);
  /// A rational strictly between low and high, with one of several denominators.
  Rational between(const Rational& low, const Rational& high);
  /// So many of them.
  std::vector<Rational> between(const Rational& low, const Rational& high, std::size_t count);
  /// nu in ]-1, 1/2[, now and then close to an end.
  Rational poisson();
  /// f in [0, largest], with its small values as often as its large ones, sometimes 0.
  Rational friction(const Rational& largest);

 private:
  // The standard fixes the engine's numbers; it does not fix those of its distributions.
  std::mt19937_64 engine_;
};

}  // namespace steadyslide::proofs_checks
