#include "model/uniqueness.hpp"

#include <algorithm>

namespace steadyslide {

std::string uniqueness_theorem(const ContactProblem& problem) {
  const std::string theorem = "uniqueness theorem for ";
  // The ledger's entries: periodic-one-solution; unique-tilt and unique-attitude; layer-one-solution.
  const Body& body = problem.body();
  if (body.period()) return theorem + "periodic contact";
  if (body.is_half_plane()) return theorem + (problem.load_at() ? "a given line of action" : "a given attitude");
  const std::vector<Rational>& f = problem.friction().values();
  const bool is_constant = std::all_of(f.begin(), f.end(), [&](const Rational& value) { return value == f.front(); });
  return is_constant ? theorem + "constant friction" : "";
}

}  // namespace steadyslide
