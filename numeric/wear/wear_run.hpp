#pragma once
// A run of wear over a sliding distance, step by step. It may stop after any step and go on from that state; the steps
// are then the same, bit for bit.

#include <vector>

#include "numeric/wear/wear_process.hpp"

namespace steadyslide::numeric::wear {

struct WearWanted {
  double distance = 0;       ///< > 0
  int steps = 0;             ///< so many equal steps, at most 1000000; 0: automatic steps
  double accuracy = 1e-3;    ///< largest step_error of an automatic step, 1e-6 to 1
  std::size_t cells = 4096;  ///< equal cells on the support
  double until = 0;          ///< ends earlier if from_run_in is at most this, below 1; 0: does not
};

/// Throws InvalidData, with the name of the member as its field, for a number out of its range.
void check(const WearWanted& wanted);

class WearRun {
 public:
  /// Throws InvalidData as check() does, if the method does not apply, or if `until` is given and no run-in pressure is known.
  WearRun(const ContactProblem& problem, const Wear& wear, const WearWanted& wanted);

  const WearProcess& process() const { return process_; }
  const WearState& state() const { return state_; }
  /// Returns the row of the current state; at first that before any wear.
  const WearRow& row() const { return row_; }
  /// True after the whole distance, near the run-in pressure, or if a step is not solved.
  bool is_over() const;
  /// Takes the next step. Call only if the run is not over.
  void advance();
  /// Goes on from the state after `steps` steps of the same run.
  void go_on(WearState state, int steps, double step_error);
  /// A number from 0 to 1.
  double progress() const;

 private:
  WearProcess::Step automatic_step();

  WearWanted wanted_;
  WearProcess process_;
  WearState state_;
  WearRow row_;
  int steps_ = 0;
  double first_step_ = 0;
};

}  // namespace steadyslide::numeric::wear
