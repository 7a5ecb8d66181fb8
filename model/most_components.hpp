#pragma once
// The largest number of contact components that a solution can have, whatever the friction, the load and the tilt.
//
// Let the profile be one polynomial on [A, B], its slope with the tilt pi of degree d with leading coefficient l. A gap
// ]a,b[ with contact at a and b, A <= a < b <= B, has its largest height at some y_i. There the matrix
// (g'(y_i) - g'(y_j))/(y_i - y_j) is diagonal and <= 0. The surface's part of it is positive definite, because it is
// (1/pi) int dp/((x'-y_i)(x'-y_j)). So the profile's part is negative definite. It is V^T H V with H_ab the coefficient
// of x^(a+b+1) in pi, a, b < d. The number of gaps is at most the number of negative squares of H:
//
//   d/2 (d even), (d-1)/2 (d odd, l > 0), (d+1)/2 (d odd, l < 0), 0 (pi constant).   docs/theory.md, "Gaps"

#include "model/contact_problem.hpp"

namespace steadyslide {

/// Returns the largest number of gaps between contacts on a piece with this profile. A tilt does not change it.
std::size_t most_gaps(const Polynomial& profile);

/// Returns the sum of most_gaps() + 1 over the pieces of the profile. Neighbouring pieces with the same polynomial are
/// one piece.
std::size_t most_components(const ContactProblem& problem);

/// Returns why a state with this number of components is no solution; empty if the number is possible.
std::string too_many_components(const ContactProblem& problem, std::size_t components);

}  // namespace steadyslide
