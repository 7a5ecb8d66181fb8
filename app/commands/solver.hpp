#pragma once
// Problems solved: the method that is asked for, in the precision that it takes.

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

/// Solves one problem after the other; the solver that iterates starts each from the solution before it, so that
/// neighbouring problems in a row cost less and stay on one branch.
class Solver {
 public:
  struct Wanted {
    Method method = Method::automatic;
    SolutionWanted solution;
    numeric::VariationalOptions variational;
    bool certify = false;      ///< proof, and enclosed numbers
    bool certificate = false;  ///< for another program to prove again
    unsigned jobs = 1;         ///< threads that certify
  };

  explicit Solver(Wanted wanted) : wanted_(std::move(wanted)) {}

  /// 16 digits are found in double; where double is not enough, 50 digits are found and 16 of them told. Where neither
  /// solves, `automatic` asks cells. The variational method knows double only.
  SolutionText solve(const Problem& problem);

  /// What is proved of all loads between two, left to right (enclosure/loads/load_path.hpp).
  std::vector<StretchText> between(const Problem& problem, const Rational& from, const Rational& to);
  /// Of all stretches asked for so far, which were proved and follow each other.
  std::string loads_certificate(const Problem& problem) const { return certificate(problem.contact, intervals_); }

 private:
  template <numeric::Real R>
  using Solution = std::shared_ptr<const numeric::ContactSolution<R>>;

  template <numeric::Real R>
  SolutionText solve_in(const Problem& problem);
  /// From what the solver finds, with more digits where that cannot be proved (library/proof/proved_contact.hpp).
  SolutionText solve_certified(const Problem& problem);
  /// Returns the contact that the solver finds, and sets `text` to a function that makes the solution's text; it refers to
  /// `problem`. If the solver finds none, returns nothing, and the text gives the reason.
  template <numeric::Real R>
  std::optional<library::FoundContact> contact_in(const Problem& problem, std::function<SolutionText()>& text);
  SolutionText solve_on_cells(const Problem& problem) const;

  Wanted wanted_;
  std::vector<enclosure::LoadInterval> intervals_;
  std::tuple<Solution<double>, Solution<numeric::Real50>, Solution<numeric::Real100>> last_;
};

/// The text of a variational solution, whose certificate weighs its residuals.
SolutionText text_on_cells(const Problem& problem, const numeric::ContactSolution<double>& solution,
                           SolutionWanted wanted);

}  // namespace steadyslide::app
