#pragma once
// Intervals of load shares and friction for all data within a tolerance, as texts.

#include <string>
#include <vector>

#include "library/answer/quantities.hpp"
#include "library/text/number_format.hpp"
#include "model/contact_problem.hpp"

namespace steadyslide::app {

/// The tolerances of `solve --tolerance-profile` and `--tolerance-friction`.
struct Tolerance {
  Rational profile;   ///< largest change of the profile, in units of length
  Rational friction;  ///< largest change of the friction coefficient
};

/// The ends of an interval, rounded outwards.
struct IntervalText {
  std::string from;
  std::string to;
};

struct ToleranceText {
  std::string profile;
  std::string friction;
  bool proved = false;  ///< false: the intervals rest on estimates of the solution
  std::string energy;   ///< E, an upper bound (enclosure/loads/tolerance_band.hpp)
  std::vector<IntervalText> load_share;
  IntervalText friction_force;
  IntervalText effective_friction;
};

/// Returns the intervals around the solved quantities. A quantity that is not known does not narrow its interval. Throws
/// InvalidData if s = +-gamma f decreases towards +x.
ToleranceText tolerance_text(const ContactProblem& problem, const Tolerance& tolerance,
                             const answer::ResultantsOf<library::NumberText, std::string>& solved);

}  // namespace steadyslide::app
