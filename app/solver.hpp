#pragma once
// Problems solved: the method that is asked for, in the precision that it takes.

#include <memory>
#include <tuple>
#include <vector>

#include "app/options.hpp"
#include "app/solve_report.hpp"

namespace steadyslide::app {

/// Solves one problem after the other; the solver that iterates starts each from the solution before it, so that
/// neighbouring problems in a row cost less and stay on one branch.
class Solver {
 public:
  struct Wanted {
    Method method = Method::automatic;
    int digits = 16;
    std::vector<Rational> at;  ///< samples at these places,
    int samples = 0;           ///< and so many a component and a gap
  };

  explicit Solver(Wanted wanted) : wanted_(std::move(wanted)) {}

  /// 16 digits are found in double; where double is not enough, 50 digits are found and 16 of them told.
  SolveReport solve(const Problem& problem);

 private:
  template <numeric::Real R>
  using Solution = std::shared_ptr<const numeric::ContactSolution<R>>;

  template <numeric::Real R>
  SolveReport solve_in(const Problem& problem);

  Wanted wanted_;
  std::tuple<Solution<double>, Solution<numeric::Real50>, Solution<numeric::Real100>> last_;
};

}  // namespace steadyslide::app
