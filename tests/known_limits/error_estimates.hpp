#pragma once
// Is what a solution in double says of its errors true? Every number of it beside the one with 50 digits.
//
// An estimate is honest if the value is off by no more. How much larger it is than that is a ratio of its own.

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "numeric/solution/contact_solution.hpp"
#include "support/random_contact.hpp"

namespace steadyslide::testing {

/// The numbers of one kind, of many solutions.
struct EstimatedNumbers {
  std::size_t count = 0, honest = 0;
  double worst = 0;               ///< the largest (true error)/estimate
  std::vector<double> too_large;  ///< estimate/(true error), where there is an error

  double median_too_large() const;
};

/// Of all problems that both solutions solve.
struct EstimateAudit {
  std::size_t problems = 0, compared = 0;
  std::map<std::string, EstimatedNumbers> numbers;  ///< by their kind
  std::vector<std::string> dishonest;               ///< one a line: seed, kind, place, value, what it is off by
  std::vector<std::string> different;               ///< seeds with contacts that differ in kind, and how

  std::size_t sum_of(std::size_t EstimatedNumbers::*part) const;
  std::size_t all() const { return sum_of(&EstimatedNumbers::count); }
  std::size_t honest() const { return sum_of(&EstimatedNumbers::honest); }
  double median_too_large() const;
  std::string text() const;
  /// Empty, or the first of these faults: an estimate that is not honest; a median of estimate/(true error) above
  /// `largest_median`; too few numbers compared.
  std::string failure(double largest_median = 1000) const;
};

/// The largest admissible median of estimate/(true error). It is larger for problems with many contact zones. There the
/// estimates add the rounding errors of 6 to 20 coupled equations; the true errors mostly cancel.
double largest_median(ContactFamily family);

/// One number of a kind, said as a line of `what` where it is not honest.
void compare_estimate(const std::string& kind, const numeric::Estimate<double>& value,
                      const numeric::Estimate<numeric::Real50>& truth, EstimateAudit& audit,
                      const std::string& what = "");

/// A solution in double beside the same one with 50 digits.
void audit_solution(const std::string& name, const ContactProblem& problem,
                    const numeric::ContactSolution<double>& found,
                    const numeric::ContactSolution<numeric::Real50>& truth, bool detailed, EstimateAudit& audit);
/// A problem by the Riemann-Hilbert method, and by its closed form where it has one; `detailed`: with what integrals of the
/// traction say of places.
void audit_solutions(const std::string& name, const ContactProblem& problem, bool detailed, EstimateAudit& audit);
/// Problem number `seed` of a family.
void audit_estimates(std::uint64_t seed, EstimateAudit& audit, ContactFamily family = ContactFamily::usual);

}  // namespace steadyslide::testing
