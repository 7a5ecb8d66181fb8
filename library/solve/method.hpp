#pragma once
// Which method solves a problem, and in which precision.

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "model/contact_problem.hpp"
#include "numeric/solution/contact_solution.hpp"

namespace steadyslide::library {

enum class Method { automatic, closed_form, riemann_hilbert, variational };

/// Of "auto", "closed-form", "riemann-hilbert", "variational". Throws InvalidData (field empty).
Method method_named(std::string_view name);

/// Is it the variational method that solves this problem? Always if asked for; `automatic` takes it where the profile
/// has more breaks, or the friction more values, than the other methods take, or than they prove, and, for 16 digits without a
/// proof, where the Riemann-Hilbert method is predicted to take more than a second. It finds a gap over each concave corner
/// inside the contact, 0.1 s each; how many there are that double can hold a solution on 1024 cells tells.
bool takes_variational(Method method, const ContactProblem& problem, bool certify, int digits = 16);

/// The rule for more digits than 16.
inline constexpr const char* digits_on_cells = "the variational method works in double, 16 digits at most";

/// May cells solve what the Riemann-Hilbert method has not: 16 digits or fewer, and no method asked for?
inline bool may_fall_back(Method method, int digits) { return method == Method::automatic && digits <= 16; }

/// The warning of an answer on cells, the Riemann-Hilbert method having failed before; `why` it did.
std::string fallen_back(const std::string& why);

/// The closed form where it is asked for or applies, else Riemann-Hilbert, from the solution `start` if there is one.
template <numeric::Real R>
numeric::Attempt<R> attempt(Method method, const ContactProblem& problem, const numeric::ContactSolution<R>* start);

/// Are all data, and these places, of a size with which double calculates without overflow?
bool fits_double(const ContactProblem& problem, const std::vector<Rational>& at);

/// May an answer in double that is not good enough be given up for one of more digits? Not of measured profiles: with so
/// many pieces it would take minutes, and what double does not know stands beside each number.
bool may_take_more_digits(const ContactProblem& problem);

/// What `solve_in.operator()<R>()` returns: for 16 digits or fewer in double, unless that does not fit the problem or
/// is not `good` and more digits may be taken; then, and for more digits, in the type that has them.
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
