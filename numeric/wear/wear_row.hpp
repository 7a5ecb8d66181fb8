#pragma once

#include <cstddef>
#include <optional>
#include <string>

namespace steadyslide::numeric::wear {

/// The quantities of a contact that wears after a sliding distance, in the user's units.
struct WearRow {
  double distance = 0;
  double left = 0, right = 0;  ///< the ends of the contact
  std::size_t zones = 0;
  double effective_friction = 0;
  double centre_of_pressure = 0;
  std::optional<double> tilt;         ///< absent if the attitude is given
  double largest_pressure = 0;        ///< the largest mean over a cell
  double wear_rate = 0;               ///< int k p dx
  double wear_volume = 0;             ///< int w dx
  std::optional<double> from_run_in;  ///< int |p - p_run_in| dx/P; absent if p_run_in is not known
  double step_error = 0;              ///< estimated error of the step in w, int |error| dx over the wear volume
  std::string failed_condition;       ///< the reason why the next step is not solved; empty if it is
};

}  // namespace steadyslide::numeric::wear
