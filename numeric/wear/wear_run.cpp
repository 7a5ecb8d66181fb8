#include "numeric/wear/wear_run.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "model/invalid_data.hpp"

namespace steadyslide::numeric::wear {
namespace {

/// Returns the factor for the next step. The error of a step is like its square.
double step_factor(double error, double accuracy) {
  constexpr double margin = 0.9, least = 0.2, most = 3;
  return error > 0 ? std::clamp(margin * std::sqrt(accuracy / error), least, most) : most;
}

void check_range(const char* field, bool fits, const char* rule, double value) {
  if (fits) return;
  std::ostringstream text;
  text << value;
  throw InvalidData(field, "out of range", rule, text.str());
}

const WearWanted& checked(const WearWanted& wanted) {
  check(wanted);
  return wanted;
}

}  // namespace

void check(const WearWanted& wanted) {
  const auto& [distance, steps, accuracy, cells, until] = wanted;
  check_range("distance", distance > 0 && distance <= 1e300, "a sliding distance is positive, at most 1e300", distance);
  check_range("steps", steps >= 0 && steps <= 1000000, "there are 1 to 1000000 steps", steps);
  check_range("accuracy", accuracy >= 1e-6 && accuracy <= 1, "the error of a step is 1e-6 to 1", accuracy);
  check_range("until", until >= 0 && until < 1, "a part of the load is in [0, 1[", until);
  check_range("cells", cells >= fewest_cells && cells <= most_cells, "there are 16 to 4194304 cells",
              static_cast<double>(cells));
}

WearRun::WearRun(const ContactProblem& problem, const Wear& wear, const WearWanted& wanted)
    : wanted_(checked(wanted)),
      process_(problem, wear, wanted.cells),
      state_(process_.start()),
      row_(process_.row(state_, 0)),
      first_step_(std::min(wanted.accuracy * process_.natural_distance(), wanted.distance)) {
  if (wanted.until > 0 && !row_.from_run_in) {
    throw InvalidData("until", "no run-in pressure",
                      "the cells that do not wear carry the load at its place in the end", "they cannot");
  }
  state_.next_step = first_step_;
  row_.failed_condition = process_.failed_condition();
}

bool WearRun::is_over() const {
  if (!row_.failed_condition.empty() || state_.distance >= wanted_.distance) return true;
  return wanted_.until > 0 && *row_.from_run_in <= wanted_.until;
}

void WearRun::advance() {
  ++steps_;
  const double end = wanted_.distance * steps_ / std::max(wanted_.steps, 1);
  WearProcess::Step step = wanted_.steps > 0 ? process_.advanced(state_, end - state_.distance) : automatic_step();
  if (!step.failed_condition.empty()) {
    row_.failed_condition = step.failed_condition;
    return;
  }
  state_ = std::move(step.state);
  if (wanted_.steps > 0) state_.distance = end;
  row_ = process_.row(state_, step.error);
}

WearProcess::Step WearRun::automatic_step() {
  double step = state_.next_step;
  while (true) {
    const double rest = wanted_.distance - state_.distance;
    const bool is_last = step >= rest;
    WearProcess::Step result = process_.advanced(state_, is_last ? rest : step);
    if (!result.failed_condition.empty()) return result;
    const double factor = step_factor(result.error, wanted_.accuracy);
    if (result.error > wanted_.accuracy) {
      step = std::min(step, rest) * std::min(factor, 0.9);
      continue;
    }
    if (is_last) result.state.distance = wanted_.distance;
    result.state.next_step = step * factor;
    return result;
  }
}

void WearRun::go_on(WearState state, int steps, double step_error) {
  state_ = std::move(state);
  steps_ = steps;
  row_ = process_.row(state_, step_error);
}

double WearRun::progress() const {
  if (wanted_.steps > 0) return state_.distance / wanted_.distance;
  // Automatic steps grow with the distance.
  const double whole = std::log1p(wanted_.distance / first_step_);
  return std::log1p(state_.distance / first_step_) / whole;
}

}  // namespace steadyslide::numeric::wear
