#pragma once

#include <rapidcheck.h>

/// A whole number from low to high, both included, evenly. (rc::gen::inRange alone stays near `low` in early tests.)
inline int uniform(int low, int high) { return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(low, high + 1)); }
