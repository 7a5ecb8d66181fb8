#pragma once
// Where the zeros of Jacobi polynomials are, in double: starts for what proves them (jacobi_polynomial.hpp). Nothing here
// is proved, and nothing has to be.

#include <vector>

namespace steadyslide::enclosure {

/// The first `wanted` of the `count` zeros of the polynomial orthogonal for y^(a-1) (1-y)^(b-1) on [0, 1], increasing; a
/// relative error of about 1e-14 is usual in the left half.
std::vector<double> jacobi_starts(int count, int wanted, double a, double b);

}  // namespace steadyslide::enclosure
