#pragma once
// Tests if the estimated errors of a solution in double are true. Compares every number with the one at 50 digits.
//
// An estimate is honest if the true error is not larger. The ratio of estimate and true error is tested separately.

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "numeric/solution/contact_solution.hpp"
#include "support/random_contact.hpp"

namespace steadyslide::testing {

/// The numbers of one kind in many solutions.
struct EstimatedNumbers {
  std::size_t count = 0, honest = 0;
  double worst = 0;               ///< the largest (true error)/estimate
  std::vector<double> too_large;  ///< estimate/(true error), if the error is not 0

  double median_too_large() const;
};

/// Results for all problems that both precisions solve.
struct EstimateAudit {
  std::size_t problems = 0, compared = 0;
  std::map<std::string, EstimatedNumbers> numbers;  ///< by kind of number
  std::vector<std::string> dishonest;               ///< one line each: seed, kind, place, value, true error
  std::vector<std::string> different;               ///< seeds with contacts that differ in kind, with the difference

  std::size_t sum_of(std::size_t EstimatedNumbers::*part) const;
  std::size_t all() const { return sum_of(&EstimatedNumbers::count); }
  std::size_t honest() const { return sum_of(&EstimatedNumbers::honest); }
  double median_too_large() const;
  std::string text() const;
  /// Returns an empty text, or the first fault: an estimate that is not honest; a median of estimate/(true error) above
  /// `largest_median`; too few numbers compared.
  std::string failure(double largest_median = 1000) const;
};

/// The largest admissible median of estimate/(true error). It is larger for problems with many contact zones. There the
/// estimates add the rounding errors of 6 to 20 coupled equations; the true errors mostly cancel.
double largest_median(ContactFamily family);

/// Compares one number of a kind. If it is not honest, adds a line that begins with `what`.
void compare_estimate(const std::string& kind, const numeric::Estimate<double>& value,
                      const numeric::Estimate<numeric::Real50>& truth, EstimateAudit& audit,
                      const std::string& what = "");

/// Compares a solution in double with the same solution at 50 digits.
void audit_solution(const std::string& name, const ContactProblem& problem,
                    const numeric::ContactSolution<double>& found,
                    const numeric::ContactSolution<numeric::Real50>& truth, bool detailed, EstimateAudit& audit);
/// Solves a problem by the Riemann-Hilbert method, and by its closed form if it has one. With `detailed`, compares also
/// integrals of the traction (details_at).
void audit_solutions(const std::string& name, const ContactProblem& problem, bool detailed, EstimateAudit& audit);
/// Tests problem number `seed` of a family.
void audit_estimates(std::uint64_t seed, EstimateAudit& audit, ContactFamily family = ContactFamily::usual);

}  // namespace steadyslide::testing
