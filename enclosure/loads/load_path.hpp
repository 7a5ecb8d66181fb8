#pragma once
// The contact of one indenter over all loads between two: intervals in each of which the contact set is proved for every
// load (load_interval.hpp), and between them events, as narrow as asked for.
//
//   proved    one topology, one zero in a box for each load. Two proved stretches that follow each other are one branch: a
//             single zero at their common load lies in both boxes.
//   closing   the same of a gap that can but close (closing_gap.hpp): one branch, from a solution at the first load on.
//   event     the contact sets on its two sides differ, both are proved, and what happens lies in between.
//   open      anything else that is not proved, with the reason; also a single load, of width 0, at which two proved
//             stretches meet that are two solutions there, or of which it is not known whether they are one branch.
//
// Together they are the whole interval, from the smaller load to the larger one. Nothing is said of an event's own loads but
// what its two sides say.
//
// How they are found has no part in the proof: from a load at which a solver knows the contact, steps go both ways, twice
// as long after some that were proved, half as long after one that was not, until they are shorter than an event may be; the
// solver is then asked about what is left, between.

#include <functional>

#include "enclosure/loads/load_interval.hpp"

namespace steadyslide::enclosure {

struct LoadStretch {
  enum class Kind { proved, closing, event, open };

  Kind kind;
  Rational from;  ///< loads in the user's unit
  Rational to;
  /// Of a proved stretch; of a closing one the proof at its first load.
  std::optional<LoadInterval> interval;
  /// What happens in an event; why an open stretch is not proved.
  std::string words;
};

/// What a solver finds at a load; nothing where it finds no solution.
using ContactAtLoad = std::function<std::optional<ApproximateContact>(const Rational& load)>;

struct LoadPathOptions {
  /// The relative width of loads that an event may have; it comes out wider where the loads beside it are proved in
  /// intervals shorter than an eighth of that alone (a gap that is a high power of the distance from the event), or not
  /// everywhere: unproved loads closer to each other than this are one stretch.
  Rational width = Rational(1, 1000000);
  Bits bits = load_interval_bits;
  /// No interval is longer than this part of its load: another program, with bounds of its own, has to decide the same signs.
  Rational longest = Rational(1, 32);
  /// Closing gaps by intervals, too: what another program can be given to prove again.
  bool intervals_alone = false;
  /// That work at a time; what is found does not depend on it. The solver is asked by each of them.
  unsigned threads = 1;
  /// For all loads; what is not proved when it is spent stays open.
  std::int64_t work = 500 * WorkBudget::usual;
};

/// Left to right, all of them in one frame. Throws InvalidData unless 0 < from < to and 0 < width.
std::vector<LoadStretch> follow_loads(const ContactProblem& problem, const Rational& from, const Rational& to,
                                      const ContactAtLoad& contact_at, const LoadPathOptions& options = {});

}  // namespace steadyslide::enclosure
