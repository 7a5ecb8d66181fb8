#pragma once
// What stands behind the facade's Problem and Solution.

#include <memory>
#include <optional>
#include <string>
#include <utility>
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

/// What parse_rational() reads; its complaint as one about `field`.
Rational rational(const Exact& number, const std::string& field);

/// A solution in one precision, as numbers of the facade.
struct Solution::State {
  Problem problem;
  int digits = 16;
  std::string method;
  std::string instead;  ///< the first warning, where the method took the place of another one
  std::string failed_condition;

  explicit State(Problem of) : problem(std::move(of)) {}
  virtual ~State() = default;

  /// Are its numbers of a size with which double calculates without overflow?
  virtual bool is_in_range() const = 0;
  virtual std::vector<std::string> warnings() const = 0;
  virtual std::vector<ContactComponent> contact() const = 0;
  virtual std::vector<SolvedPoint> singular_points() const = 0;
  virtual std::vector<UnresolvedGap> unresolved_gaps() const = 0;
  virtual Resultants resultants() const = 0;
  /// Without displacement, shear slope and load unless `detailed`.
  virtual SurfaceSample at(const Rational& x, bool detailed) const = 0;
  /// Normal and tangential ones.
  virtual std::pair<std::vector<double>, std::vector<double>> tractions(std::span<const double> x) const = 0;
  virtual Stress stress(const Rational& x, const Rational& z) const = 0;
  virtual std::vector<Stress> stress(std::span<const double> x, std::span<const double> z) const = 0;
  virtual std::vector<NodalForce> nodal_forces(const Mesh& mesh) const = 0;
  virtual ApproximateContact approximate_contact() const = 0;
  /// Of a solution on cells.
  virtual std::optional<std::vector<double>> touching_pressures() const = 0;
};

/// Throws InvalidData where the method does not apply. `digits`: of the precision too.
std::shared_ptr<const Solution::State> solved_state(const Problem& problem, library::Method method, int digits,
                                                    const numeric::VariationalOptions& variational);

}  // namespace steadyslide
