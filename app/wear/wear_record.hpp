#pragma once
// The record of a run of wear: its rows so far, profiles at some distances, and the state from which it goes on. Its
// bytes stand in FILE.part while FILE is not finished.

#include <string>
#include <vector>

#include "app/terminal/failure.hpp"
#include "numeric/wear/wear_run.hpp"

namespace steadyslide::app {

/// The profiles after one distance, in the user's units: means over equal parts of the support.
struct WornProfile {
  double distance;
  std::vector<double> pressure;
  std::vector<double> depth;
};

struct WearRecord {
  std::string rows;  ///< CSV
  int steps = 0;
  double step_error = 0;  ///< of the last step
  numeric::wear::WearState state;
  std::vector<WornProfile> profiles;

  /// Adds the row and, if this is the first one or the distance has doubled, the profiles.
  void add(const numeric::wear::WearRun& run);
  /// Adds the profiles of the last state, if they are not there.
  void add_last_profile(const numeric::wear::WearProcess& process);
};

/// "distance,left,...\n"
std::string wear_header();
/// One line for the run's current state.
std::string wear_line(const numeric::wear::WearRow& row);
/// Returns the means of the cells' values over at most 4096 equal parts of the support.
std::vector<double> means_over_parts(const std::vector<double>& cells);
/// Returns the x of the parts' ends.
std::vector<double> profile_edges(const numeric::wear::WearProcess& process);
/// Returns a CSV table: distance, x, pressure and depth at every place with pressure or depth.
std::string profile_table(const WearRecord& record, const std::vector<double>& edges);

/// Returns the contents of FILE.part: the title, which is its first line, and the record as CBOR.
std::string bytes_of(const WearRecord& record, const std::string& title);
/// Reads them. Throws Failure (exit code 2) for another title, and for bytes that are not whole.
WearRecord record_of(const std::string& bytes, const std::string& title, const std::string& file);

}  // namespace steadyslide::app
