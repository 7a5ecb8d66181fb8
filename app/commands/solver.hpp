#pragma once
// Solves problems with the chosen method, in the precision that it needs.

#include <functional>
#include <memory>
#include <tuple>
#include <vector>

#include "app/results/solution_text.hpp"
#include "library/proof/certificate.hpp"
#include "library/proof/proved_contact.hpp"
#include "library/solve/method.hpp"
#include "numeric/variational/variational_inequality.hpp"

namespace steadyslide::app {

/// Solves one problem after the other. The iterative solver starts each problem from the solution before it:
/// neighbouring problems then cost less and stay on one branch.
class Solver {
 public:
  struct Wanted {
    Method method = Method::automatic;
    SolutionWanted solution;
    numeric::VariationalOptions variational;
    bool cells_chosen = false;  ///< the number of cells or their accuracy was chosen
    bool certify = false;       ///< make a proof, and enclose the numbers
    bool certificate = false;   ///< write data with which another program can repeat the proof
    unsigned jobs = 1;          ///< number of threads of a proof
  };

  explicit Solver(Wanted wanted) : wanted_(std::move(wanted)) {}

  /// 16 digits are computed in double. If double is not enough, 50 digits are computed and 16 of them shown. If that
  /// fails too, Method::automatic solves on cells. The variational method works only in double.
  SolutionText solve(const Problem& problem);

  /// Proves the solutions for all loads between two. Returns the stretches from left to right
  /// (enclosure/loads/load_path.hpp).
  std::vector<StretchText> certify_load_range(const Problem& problem, const Rational& from, const Rational& to);
  /// Returns the certificate of all stretches so far. They have to be proved and consecutive.
  std::string loads_certificate(const Problem& problem) const { return certificate(problem.contact, intervals_); }

 private:
  template <numeric::Real R>
  using Solution = std::shared_ptr<const numeric::ContactSolution<R>>;

  template <numeric::Real R>
  SolutionText solve_in(const Problem& problem);
  /// Proves the solution that the solver finds; repeats with more digits if it cannot be proved
  /// (library/proof/proved_contact.hpp).
  SolutionText solve_certified(const Problem& problem);
  /// Returns the contact that the solver finds, and sets `text` to a function that makes the solution's text; it refers
  /// to `problem`. If the solver finds none, returns nothing, and the text gives the reason.
  template <numeric::Real R>
  std::optional<library::FoundContact> contact_in(const Problem& problem, std::function<SolutionText()>& text);
  SolutionText solve_on_cells(const Problem& problem) const;

  Wanted wanted_;
  std::vector<enclosure::LoadInterval> intervals_;
  std::tuple<Solution<double>, Solution<numeric::Real50>, Solution<numeric::Real100>> last_;
};

}  // namespace steadyslide::app
