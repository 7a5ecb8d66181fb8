#pragma once
// Changes of a contact problem that change its solution by a known law, and the check of this law for the
// Riemann-Hilbert solver and for the cell solver.

#include "proofs_checks/instruments/tractions/surface.hpp"
#include "proofs_checks/kit/claim_builder.hpp"

namespace steadyslide::proofs_checks {

/// The changed problem: coordinate y = scale x + shift, profile height times `height` plus `lift`, load times `load`.
/// It may slide in the opposite direction and have one more friction jump. The law for its solution at y: traction
/// times `traction`, gap times `gap`.
struct Law {
  Rational scale = 1;
  Rational shift = 0;
  Rational height = 1;
  Polynomial lift = Polynomial();
  Rational load = 1;
  bool turned = false;
  bool keeps_friction = false;                  ///< friction stays in place, even if x is mirrored
  std::optional<Rational> jump = std::nullopt;  ///< height of the friction jump
  Rational traction = 1;
  Rational gap = 1;

  // Near misses, in units of the tolerance at the precision of the check.
  Rational Law::*missed = nullptr;  ///< the factor that changes by ten tolerances
  bool missed_jump = false;         ///< friction jump of a thousand tolerances
  bool missed_on_cells = false;     ///< traction on cells changes by ten tolerances
};

/// Returns the claim of this law on random problems.
FormulaClaim<ContactProblem, Law> law_claim(std::string id, const Law& law);

}  // namespace steadyslide::proofs_checks
