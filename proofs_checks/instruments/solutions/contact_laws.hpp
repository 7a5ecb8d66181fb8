#pragma once
// Laws that compare two solved contacts under one friction, one indenter or one load. A law returns numbers by name; it
// holds if none of them is above 0. By the Riemann-Hilbert method a strict law must hold by more than the errors of the
// solutions. On cells, whose errors may exceed a difference, it may not fail by more than twice these errors.
//
// s = +-gamma f is signed by the direction of sliding. An attitude is a slope omega that is added to the profile, so a
// larger omega lifts the right side of the indenter. q = p_1 - p_2 is the difference of the pressures.

#include <optional>
#include <string>
#include <vector>

#include "proofs_checks/instruments/solutions/contact_pairs.hpp"
#include "proofs_checks/kit/values.hpp"

namespace steadyslide::proofs_checks {

/// By name, how far a law fails: at most 0 if it holds.
using Shortfalls = std::vector<std::pair<std::string, double>>;
/// Returns the same for a claim.
Values values_of(const Shortfalls& shortfalls);

// Each law compares two contacts. Their data are equal, apart from the data that the law is about.

/// Under the larger load no pressure is smaller ("fall"), no contact is lost ("lost"), no gap is wider ("gap"), and
/// int |q| is the difference of the loads ("distance").
Shortfalls load_law(const SolvedContact& larger, const SolvedContact& smaller);
/// Profiles that differ by a polynomial of degree m >= 1, under any loads: the pressures cross at most m times
/// ("crossings").
Shortfalls crossing_law(const SolvedContact& one, const SolvedContact& other, int m);
/// Under the larger slope the centre of pressure lies further left ("centre"), q is positive on the left and negative
/// on the right ("order"), and no load up to a place is smaller ("cumulative").
Shortfalls attitude_law(const SolvedContact& larger, const SolvedContact& smaller);
/// s_1 >= s_2: under s_1 the centre of pressure lies further left ("centre"), int s p is larger ("mean"), and q is
/// positive next to the left end and negative next to the right one ("ends"; by the Riemann-Hilbert method alone). If
/// the indenter may tilt, its tilt is smaller ("tilt"), and nothing else is compared. Numbers are in units of
/// int (s_1 - s_2) p_2 / P; returns nothing if this is less than 1e-9, because s then differs only where no load is.
Shortfalls friction_law(const SolvedContact& larger, const SolvedContact& smaller);

/// Returns a law of two problems, solved by one method; nothing if one of them is not solved.
template <class Law>
Shortfalls compared_by(Method method, const ContactProblem& one, const ContactProblem& other, const Law& law) {
  const auto first = solved_contact(one, method);
  const auto second = solved_contact(other, method);
  return first && second ? law(*first, *second) : Shortfalls();
}

/// Returns the number of contact components. A gap counts if it is wider than the errors of its ends: on cells there is
/// a gap of one cell next to the edge of a flat punch under strong friction, which the solution does not have.
int components_of(const SolvedContact& contact);

/// Returns the tilt under which the centre of pressure is load_at, from solutions with a given attitude, by bracketing.
/// Returns nothing if one of them is not found.
std::optional<double> tilt_by_bracketing(const ContactProblem& problem, Method method);

}  // namespace steadyslide::proofs_checks
