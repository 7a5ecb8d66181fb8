#pragma once
// Random exact contact problems for the solvers, from a seed alone: the same on every platform.
//
// One to six friction jumps, f from 0 to 20, nu from -0.9 to 0.499, plane strain and stress, both ways of sliding,
// profiles of up to five polynomial pieces of degree at most six, loads over six decades of (height of the profile)/c.
// Out of a hundred problems
//
//   14 one smooth bump       18 one bump with a wedge at its tip     12 two to four smooth bumps, one piece each
//   13 two or three bumps, at least one with a wedge       13 polynomials with two or three wells
//   10 punches: flat, inclined, with rounded ends           7 convex polygons      6 steps, slots, plinths
//    7 polynomials with random coefficients
//
// and one in ten of the bumps and punches may tilt. Jumps lie where contact is expected, at wedges, and anywhere.
//
// Nothing is kept out: next to a step or a wedge, contact and gaps are as long as (small)^(1/(1/2 - |alpha|)), which
// for s = 10 can be less than the distance of two numbers. With these shares, by a coarse variational solution of the
// list, four in five problems have a free end, two in five several zones, one in three a wedge in the contact, and half
// of them a decreasing jump of s there.

#include <cstdint>

#include "model/contact_problem.hpp"

namespace steadyslide::testing {

/// Seeds of the list that the solver is measured by: first_listed_seed + i, i < listed_problems.
inline constexpr std::uint64_t first_listed_seed = 20160000;
inline constexpr int listed_problems = 2000;

ContactProblem random_contact(std::uint64_t seed);

}  // namespace steadyslide::testing
