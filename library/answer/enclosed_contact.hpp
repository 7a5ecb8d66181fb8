#pragma once
// A proved solution in balls. It has the members that the formulas of the table of quantities use
// (library/answer/quantities.hpp).

#include <optional>
#include <vector>

#include "enclosure/contact/enclosed_solution.hpp"
#include "enclosure/contact/punch_core.hpp"
#include "library/answer/quantities.hpp"

namespace steadyslide::library {

class EnclosedContact {
 public:
  using Ball = enclosure::Ball;
  struct NotEnclosed {};

  EnclosedContact(const ContactProblem& problem, const enclosure::EnclosedSolution& solution)
      : problem_(problem), solution_(solution), contact_(solution.contact()), forces_(solution.resultants()) {}

  const std::vector<ContactComponentOf<Ball>>& contact() const { return contact_; }
  const enclosure::EnclosedSolution::Resultants& forces() const { return forces_; }
  std::size_t components() const { return contact_.size(); }

  /// From the first end of contact to the last.
  Ball width() const { return contact_.back().right.x - contact_.front().left.x; }
  Ball length() const {
    Ball sum(0);
    for (const auto& component : contact_) sum += component.width;
    return sum;
  }
  Ball per_length(const Ball& force) const { return force / length(); }
  NotEnclosed largest_pressure() const { return {}; }
  std::optional<Ball> tilt() const { return solution_.tilt(); }
  std::optional<Ball> average_pressure() const { return std::nullopt; }
  std::optional<Ball> average_at() const { return std::nullopt; }
  std::optional<Ball> approach() const { return std::nullopt; }
  std::optional<answer::IntervalOf<Ball>> core() const {
    const auto core = enclosure::punch_core(problem_, forces_.normal.bits());
    return core ? std::optional(answer::IntervalOf<Ball>{core->left, core->right}) : std::nullopt;
  }

 private:
  const ContactProblem& problem_;
  const enclosure::EnclosedSolution& solution_;
  std::vector<ContactComponentOf<Ball>> contact_;
  enclosure::EnclosedSolution::Resultants forces_;
};

}  // namespace steadyslide::library
