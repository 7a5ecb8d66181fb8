#pragma once
// The contact of one indenter for all loads between two given loads: intervals in which the contact set is proved for
// every load (load_interval.hpp), and between them events, as narrow as required.
//
//   proved    one topology, one zero in a box for each load. Two consecutive proved stretches are one branch: a
//             single zero at their common load lies in both boxes.
//   closing   the same for a gap that can only close (closing_gap.hpp): one branch, from a solution at the first load.
//   event     the contact sets on its two sides differ, both are proved, and the change lies in between.
//   open      anything else that is not proved, with the reason; also a single load, of width 0, at which two proved
//             stretches meet that are two solutions there, or of which it is not known whether they are one branch.
//
// Together they are the whole interval, from the smaller load to the larger one. About the loads inside an event only
// its two sides are known.
//
// The search is not part of the proof. It starts from a load at which a solver found the contact and makes steps in
// both directions. After some proved steps the length doubles; after a failed step it is halved, until it is shorter
// than the width of an event. Then the solver is called for the loads that remain.

#include <functional>

#include "enclosure/loads/load_interval.hpp"

namespace steadyslide::enclosure {

struct LoadStretch {
  enum class Kind { proved, closing, event, open };

  Kind kind;
  Rational from;  ///< loads in the user's unit
  Rational to;
  /// For a proved stretch its interval; for a closing one the proof at its first load.
  std::optional<LoadInterval> interval;
  /// For an event the change; for an open stretch the reason why it is not proved.
  std::string words;
};

/// A function that returns a solver's result at a load; absent if it finds no solution.
using ContactAtLoad = std::function<std::optional<ApproximateContact>(const Rational& load)>;

struct LoadPathOptions {
  /// The largest relative width of loads of an event. An event is wider if the loads beside it can only be proved in
  /// intervals shorter than an eighth of this (for a gap that is a high power of the distance from the event), or not
  /// everywhere: unproved loads closer to each other than this are one stretch.
  Rational width = Rational(1, 1000000);
  Bits bits = load_interval_bits;
  /// No interval is longer than this fraction of its load, because another program must decide the same signs with its
  /// own bounds.
  Rational longest = Rational(1, 32);
  /// True to prove closing gaps by intervals too, so that another program can prove the result again.
  bool intervals_alone = false;
  /// The number of threads. The result does not depend on it. Each thread may call the solver.
  unsigned threads = 1;
  /// The work budget for all loads. Loads that are not proved when it is spent stay open.
  std::int64_t work = 500 * WorkBudget::usual;
};

/// Returns the stretches in order of load, all in one frame. Throws InvalidData unless 0 < from < to and 0 < width.
std::vector<LoadStretch> follow_loads(const ContactProblem& problem, const Rational& from, const Rational& to,
                                      const ContactAtLoad& contact_at, const LoadPathOptions& options = {});

}  // namespace steadyslide::enclosure
