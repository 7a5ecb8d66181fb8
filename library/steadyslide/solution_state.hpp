#pragma once
// The data behind the facade's classes Problem and Solution.

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "library/problem_file/problem_file.hpp"
#include "library/solve/method.hpp"
#include "library/steadyslide/steadyslide.hpp"
#include "model/approximate_contact.hpp"
#include "numeric/variational/variational_inequality.hpp"

namespace steadyslide {

struct Problem::Data {
  library::Problem problem;
  std::string text;
};
inline const Problem::Data& data_of(const Problem& problem) { return *problem.data_; }
inline const ContactProblem& contact_problem(const Problem& problem) { return data_of(problem).problem.contact; }

/// Returns parse_rational() of the text. Throws InvalidData that names `field`.
Rational rational(const Exact& number, const std::string& field);

/// Throws InvalidData that names `option` unless least <= value <= most.
void check(const char* option, int value, int least, int most);

/// Returns the exponent e rounded to `digits` >= 1. The error is |e| 10^(1 - digits): it covers the rounding of `digits`,
/// and up to 16 digits that of `value`.
Number number_of(const Exponent& exponent, int digits);

/// The solution in the precision that has it.
using AnySolution =
    std::variant<const numeric::ContactSolution<double>*, const numeric::ContactSolution<numeric::Real50>*,
                 const numeric::ContactSolution<numeric::Real100>*>;

/// A solution in one precision, with its numbers as the facade shows them.
struct Solution::State {
  Problem problem;
  int digits = 16;
  std::string method;
  std::string instead;  ///< the first warning, if another method had failed before
  std::string failed_condition;

  explicit State(Problem of) : problem(std::move(of)) {}
  virtual ~State() = default;

  /// True if its numbers have a size with which double calculates without overflow.
  virtual bool is_in_range() const = 0;
  virtual std::vector<std::string> warnings() const = 0;
  virtual std::vector<ContactComponent> contact() const = 0;
  virtual std::vector<SolvedPoint> singular_points() const = 0;
  virtual std::vector<UnresolvedGap> unresolved_gaps() const = 0;
  virtual Residuals residuals() const = 0;
  virtual EstimatedError estimated_error() const = 0;
  virtual Resultants resultants() const = 0;
  /// Returns displacement, shear slope and load only if `detailed`.
  virtual SurfaceSample at(const Rational& x, bool detailed) const = 0;
  /// Normal and tangential tractions.
  virtual std::pair<std::vector<double>, std::vector<double>> tractions(std::span<const double> x) const = 0;
  /// z >= 0.
  virtual Stress stress(const Rational& x, const Rational& z) const = 0;
  virtual std::vector<Stress> stress(std::span<const double> x, std::span<const double> z) const = 0;
  virtual Displacement displacement(const Rational& x, const Rational& z) const = 0;
  virtual LargestStress max_stress(const std::optional<Rational>& depth, const std::optional<Rational>& over) const = 0;
  virtual std::vector<InterfaceStress> interface_stress() const = 0;
  virtual std::vector<NodalForce> nodal_forces(const Mesh& mesh) const = 0;
  virtual ApproximateContact approximate_contact() const = 0;
  virtual AnySolution solution() const = 0;
  /// The pressures of the cells in contact, for a solution on cells; otherwise absent.
  virtual std::optional<std::vector<double>> touching_pressures() const = 0;
};

inline const Solution::State& data_of(const Solution& solution) { return *solution.state_; }

/// SolveOptions after they were checked.
struct SolveWanted {
  library::Method method;
  int digits;  ///< also chooses the precision
  numeric::VariationalOptions variational;
  std::optional<Rational> over;
};

/// Throws InvalidData if the method does not apply. `start`: null, or a state from which the Riemann-Hilbert method
/// starts if it has the same precision.
std::shared_ptr<const Solution::State> solved_state(const Problem& problem, const SolveWanted& wanted,
                                                    const Solution::State* start = nullptr);

}  // namespace steadyslide
