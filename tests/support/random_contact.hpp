#pragma once
// Random exact contact problems for the solvers. They depend only on the seed and are the same on every platform.
//
// One to six friction jumps, f from 0 to 20, nu from -0.9 to 0.499, plane strain and stress, both directions of
// sliding, profiles of up to five polynomial pieces of degree at most six, loads over six decades of (height of the
// profile)/c. Out of a hundred problems
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

// Besides this list there are families with features that the list lacks. Their other data are drawn as in the list.

#include <cstdint>
#include <optional>
#include <string_view>
#include <utility>

#include "model/contact_problem.hpp"

namespace steadyslide::testing {

/// Seeds of the list by which the solver is measured: first_listed_seed + i, i < listed_problems.
inline constexpr std::uint64_t first_listed_seed = 20160000;
inline constexpr int listed_problems = 2000;

enum class ContactFamily {
  usual,                   ///< the list itself
  neighbouring_frictions,  ///< f changes by 1e-4 to 1e-16 at every jump
  short_gaps,              ///< pieces of 1e-4 to 1e-10 of the profile's length, beside a step; slots as narrow
  notches,                 ///< contact that ends beside a notch, or leaves an almost closed gap over it
  many_wedges,             ///< six to twenty bumps with wedges, friction jumps on them
  limits_of_poisson,       ///< nu within 1e-2 to 1e-9 of 1/2, 0 and -1, more of them with an indenter that may tilt
  large_frictions,         ///< f mostly from 20 to 50
  falling_frictions        ///< s = gamma f falls towards +x at every jump, from at most 5; one in five has a notch
};

inline constexpr std::pair<ContactFamily, std::string_view> contact_families[] = {
    {ContactFamily::usual, "usual"},
    {ContactFamily::neighbouring_frictions, "neighbouring-frictions"},
    {ContactFamily::short_gaps, "short-gaps"},
    {ContactFamily::notches, "notches"},
    {ContactFamily::many_wedges, "many-wedges"},
    {ContactFamily::limits_of_poisson, "limits-of-poisson"},
    {ContactFamily::large_frictions, "large-frictions"},
    {ContactFamily::falling_frictions, "falling-frictions"}};

/// Returns the family of this name; absent for other names.
std::optional<ContactFamily> contact_family(std::string_view name);

ContactProblem random_contact(std::uint64_t seed, ContactFamily family = ContactFamily::usual);

}  // namespace steadyslide::testing
