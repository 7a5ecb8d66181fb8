#pragma once
// True if two balls have a number in common. False if one of them is not finite.

#include "checker/ball.hpp"

inline bool overlap(const steadyslide::checker::Ball& a, const steadyslide::checker::Ball& b) {
  return a.is_finite() && b.is_finite() && arb_overlaps(a.get(), b.get()) != 0;
}
