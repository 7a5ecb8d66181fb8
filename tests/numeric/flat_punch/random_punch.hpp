#pragma once
// Flat punches with random strips, by number; they are the same on every platform.

#include <random>

#include "support/problems.hpp"

namespace steadyslide::testing {

/// Punch number n of a list, with n % 9 jumps. One s in five is zero, one in five up to 20, the rest up to 1.
inline ContactProblem random_punch(unsigned n) {
  std::mt19937_64 engine(2016 + n);
  const auto below = [&](unsigned limit) { return static_cast<int>(engine() % limit); };
  std::set<Rational> jumps;
  while (jumps.size() < n % 9) jumps.insert(Rational(below(1999) - 999, 1000));
  std::vector<Rational> s;
  for (std::size_t k = 0; k <= jumps.size(); ++k) {
    const int kind = below(5);
    s.push_back(kind == 0 ? Rational(0) : Rational(below(1000) + 1, kind == 1 ? 50 : 1000));
  }
  return reduced(s, {jumps.begin(), jumps.end()}, one_piece(-1, 1, {0}), 1);
}

}  // namespace steadyslide::testing
