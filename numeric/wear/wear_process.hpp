#pragma once
// A contact on cells that wears (model/wear.hpp): load given, attitude given or tilt free. Implicit Euler steps,
//
//   w(S + dS) = w(S) + k dS p(S + dS),
//
// so that each step is a contact problem with the profile psi + w(S) and with k dS p added to the displacement of each
// cell: in reduced units k dS/(c unit) on the diagonal of the operator. k is its mean over the cell.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "model/wear.hpp"
#include "numeric/variational/discrete_problem.hpp"
#include "numeric/variational/variational_inequality.hpp"
#include "numeric/wear/wear_row.hpp"

namespace steadyslide::numeric::wear {

/// All that decides how a run goes on.
struct WearState {
  double distance = 0;
  double next_step = 0;                ///< for automatic steps
  std::vector<double> depth;           ///< w of each cell, in c P
  variational::DiscreteState contact;  ///< p in P/unit
};

class WearProcess {
 public:
  /// Solves the contact before any wear on `cells` equal cells. Throws InvalidData if the method does not apply.
  WearProcess(const ContactProblem& problem, const Wear& wear, std::size_t cells);

  /// The state before any wear.
  const WearState& start() const { return start_; }
  /// Returns why that is not solved; empty if it is.
  const std::string& failed_condition() const { return failed_condition_; }
  /// Returns the sliding distance after which the wear depth is about the elastic displacement.
  double natural_distance() const { return natural_distance_; }

  struct Step {
    WearState state;
    double error = 0;              ///< as WearRow::step_error
    std::string failed_condition;  ///< empty if the step is solved
  };
  /// Takes one step. A step that is not solved is taken as two halves, and so on.
  Step advanced(const WearState& state, double step, int halvings = 8) const;

  WearRow row(const WearState& state, double step_error) const;
  /// Pressures in the user's unit.
  std::vector<double> pressures(const WearState& state) const { return scaled(state.contact.pressure, stress_); }
  std::vector<double> depths(const WearState& state) const { return scaled(state.depth, height_); }
  /// Empty if it is not known.
  std::vector<double> run_in_pressures() const;
  /// Returns the ends of the cells, in the user's x.
  std::vector<double> edges() const;
  /// Returns the numbers that decide every step: two processes with the same ones are the same.
  std::vector<double> data() const;

 private:
  static std::vector<double> scaled(std::vector<double> values, double factor);
  double integral(const std::vector<double>& values) const;
  /// True if an elastic indenter touches with an edge.
  bool is_at_edge(const std::vector<double>& pressure) const;

  ContactProblem problem_;
  std::shared_ptr<const variational::DiscreteProblem> cells_;  ///< before any wear
  WearState start_;
  std::string failed_condition_;
  std::vector<double> k_;         ///< means over the cells, in c unit per distance
  std::vector<double> friction_;  ///< means of f
  std::optional<std::vector<double>> run_in_;
  double origin_, unit_, stress_, height_;
  double natural_distance_;
};

}  // namespace steadyslide::numeric::wear
