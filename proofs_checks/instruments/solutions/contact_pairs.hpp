#pragma once
// Two solved contacts on the same support, compared place by place. q = p_1 - p_2 is the difference of their pressures.

#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "numeric/solution/contact_solution.hpp"
#include "proofs_checks/kit/numbers.hpp"

namespace steadyslide::proofs_checks {

/// Two methods that share no code.
enum class Method { riemann_hilbert, cells };
std::string_view name_of(Method method);
/// Returns the method for case number k: the two in turn.
inline Method method_of(std::size_t k) { return k % 2 == 0 ? Method::riemann_hilbert : Method::cells; }

struct SolvedContact {
  ContactProblem problem;
  Method method;
  std::shared_ptr<const numeric::ContactSolution<double>> solution;
};
/// Returns nothing if the method finds no solution that meets all conditions. In periodic contact the closed form stands
/// for the Riemann-Hilbert method.
std::optional<SolvedContact> solved_contact(const ContactProblem& problem, Method method);

/// The values of both solutions at one place.
struct PairOfSamples {
  Rational x;
  numeric::Sample<double> one;
  numeric::Sample<double> other;
};
/// Returns samples at places that are graded towards all singular points and free ends of both solutions, to 1e-11 of
/// the distance between two of them. Leaves out places next to a gap that a solution does not resolve.
std::vector<PairOfSamples> samples(const SolvedContact& one, const SolvedContact& other);
/// Returns T of both solutions at all singular points and free ends, and halfway between two of them.
std::vector<std::pair<Estimate<double>, Estimate<double>>> cumulative_loads(const SolvedContact& one,
                                                                            const SolvedContact& other);

/// Returns (a - b)/(a + b), or nothing if the errors may exceed the difference.
std::optional<double> relative_excess(const Estimate<double>& a, const Estimate<double>& b);
/// Returns -t; 0 where a solver that does not resolve a gap has tension.
Estimate<double> pressure(const numeric::Sample<double>& sample);
/// Returns the signs of q from left to right, one for each stretch of one sign, at the places of samples(). A place
/// counts if q exceeds its error. At a singular point of both solutions the leading terms decide.
std::vector<int> signs_of_difference(const SolvedContact& one, const SolvedContact& other);

}  // namespace steadyslide::proofs_checks
