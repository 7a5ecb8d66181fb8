#pragma once
// Changes of a contact problem that change its solution in a known way, and the check that they do: for the
// Riemann-Hilbert solver, and for the one on cells.

#include <functional>
#include <optional>
#include <string>

#include "model/contact_problem.hpp"
#include "proofs_checks/kit/claim.hpp"

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
  /// For near misses: changes the law by so much, or what is said on cells.
  std::function<void(Law&, const Rational&)> miss = nullptr;
  bool missed_on_cells = false;
};

std::vector<Evidence> check_law(const Context& context, const Law& law);

/// Plain, not compared: the law is what is put to the solvers, and a wrong one is another problem.
Claim law_claim(std::string_view id, const Law& right, std::vector<Wrong<Law>> wrong);

/// The law with something in it changed.
template <class Change>
Wrong<Law> variant(std::string name, Law law, Change change) {
  change(law);
  return {std::move(name), law};
}

// Near misses: what is moved.
void miss_on_cells(Law& law);
void miss_of_load(Law& law);
void miss_of_height(Law& law);
void miss_of_traction(Law& law);
void miss_of_jump(Law& law);

}  // namespace steadyslide::proofs_checks
