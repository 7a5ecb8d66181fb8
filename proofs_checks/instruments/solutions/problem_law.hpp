#pragma once
// Changes of a contact problem that change its solution in a known way, and the check that they do: for the
// Riemann-Hilbert solver, and for the one on cells.

#include "proofs_checks/instruments/tractions/surface.hpp"
#include "proofs_checks/kit/claim_builder.hpp"

namespace steadyslide::proofs_checks {

/// The problem in y = scale x + shift, profile height psi + lift, load times `load`, perhaps sliding the other way,
/// with a jump of friction more; and what it is said to have: traction times `traction`, gap times `gap`, at y.
struct Law {
  Rational scale = 1;
  Rational shift = 0;
  Rational height = 1;
  Polynomial lift = Polynomial();
  Rational load = 1;
  bool turned = false;
  bool keeps_friction = false;                  ///< in place, where x is mirrored
  std::optional<Rational> jump = std::nullopt;  ///< its height
  Rational traction = 1;
  Rational gap = 1;

  // Near misses, by what is allowed at the precision of the check.
  Rational Law::*missed = nullptr;  ///< one of the factors, by ten times as much
  bool missed_jump = false;         ///< a jump of a thousand times as much
  bool missed_on_cells = false;     ///< the traction on cells, by ten times as much
};

/// On random problems.
FormulaClaim<ContactProblem, Law> law_claim(std::string id, const Law& law);

}  // namespace steadyslide::proofs_checks
