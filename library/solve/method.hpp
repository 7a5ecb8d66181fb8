#pragma once
// Chooses the method that solves a problem, and its precision.

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "library/problem_file/problem_file.hpp"
#include "model/contact_problem.hpp"
#include "numeric/solution/contact_solution.hpp"

namespace steadyslide::library {

enum class Method { automatic, closed_form, riemann_hilbert, variational };

/// Returns the method called "auto", "closed-form", "riemann-hilbert" or "variational". Throws InvalidData (field
/// empty).
Method method_named(std::string_view name);

struct Choice {
  bool on_cells;       ///< the variational method
  std::string reason;  ///< the rule that chose, with the number that decided
};

/// Returns the choice between the variational method and the others: Method::variational always takes it.
/// Method::automatic takes it if the profile has more breaks or the friction has more values than the other methods
/// accept, or than they can prove. For 16 digits without a proof it also takes it if the Riemann-Hilbert method is
/// predicted to take more than a second for gaps. That method finds a gap over each concave corner inside the contact,
/// 0.1 s each; a solution on 1024 cells predicts how many of them double can represent. On a profile of more than 1000
/// pieces without corners, each change of the contact set costs a time that grows with the number of pieces. There it
/// takes cells if 4096 of them show more than ten zones.
Choice choice_of(Method method, const ContactProblem& problem, bool certify, int digits = 16);
inline bool takes_variational(Method method, const ContactProblem& problem, bool certify, int digits = 16) {
  return choice_of(method, problem, certify, digits).on_cells;
}

/// The rule for the relative error that is wanted of a solution on cells.
inline constexpr const char* accuracy_rule = "an accuracy is at least 1e-9, and less than 1";
/// The accuracy of a solution on cells if the user chose neither it nor the cells: 0.001 for a measured profile, 0
/// (none) elsewhere.
inline double default_accuracy(const Problem& problem) { return problem.measured ? 1e-3 : 0; }
inline bool is_accuracy(const Rational& accuracy) { return accuracy >= Rational(1, 1000000000) && accuracy < 1; }

/// The rule for more than 16 digits.
inline constexpr const char* digits_on_cells = "the variational method works in double, 16 digits at most";

/// True if the variational method may replace a Riemann-Hilbert solve that failed: 16 digits or fewer, and no method
/// chosen by the user.
inline bool may_fall_back(Method method, int digits) { return method == Method::automatic && digits <= 16; }

/// The warning of a solution on cells after the Riemann-Hilbert method failed; `why` gives the reason of the failure.
std::string fallen_back(const std::string& why);

/// Solves by the closed form if it is chosen or applies, otherwise by Riemann-Hilbert, from the solution `start` if it
/// is not null.
template <numeric::Real R>
numeric::Attempt<R> attempt(Method method, const ContactProblem& problem, const numeric::ContactSolution<R>* start);

/// True if all data and the places `at` have a size with which double calculates without overflow.
bool fits_double(const ContactProblem& problem, const std::vector<Rational>& at);

/// True if a bad answer in double may be replaced by one with more digits. False for profiles with many pieces, as
/// measured ones have: that would take minutes, and every number has its error beside it.
bool may_take_more_digits(const ContactProblem& problem);

/// Returns what `solve_in.operator()<R>()` returns. For 16 digits or fewer R is double, unless double does not fit the
/// problem, or the answer is not `good` and more digits may be taken. In these cases, and for more digits, R is the
/// type that has the digits.
template <class SolveIn, class Good>
auto in_precision(int digits, const ContactProblem& problem, const std::vector<Rational>& at, SolveIn solve_in,
                  Good good) {
  numeric::Digits precision = numeric::precision_for(digits);
  if (precision == numeric::Digits::sixteen) {
    if (fits_double(problem, at)) {
      auto found = solve_in.template operator()<double>();
      if (good(found) || !may_take_more_digits(problem)) return found;
    }
    precision = numeric::Digits::fifty;
  }
  return numeric::at_precision(precision, solve_in);
}

}  // namespace steadyslide::library
