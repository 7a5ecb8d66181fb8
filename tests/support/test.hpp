#pragma once
// What every test starts from.

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <map>
#include <numbers>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "model/rational.hpp"

using namespace steadyslide;

/// 0.3_r is 3/10, and not the double next to it.
inline Rational operator""_r(const char* number) { return parse_rational(number); }

/// A whole number from low to high, both included, evenly. (rc::gen::inRange alone stays near `low` in early tests.)
inline int uniform(int low, int high) { return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(low, high + 1)); }
inline bool uniform_bool() { return uniform(0, 1) == 0; }
