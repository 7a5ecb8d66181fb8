#pragma once
// A solution in estimates. It has the members that the formulas of the table of quantities use
// (library/answer/quantities.hpp).

#include <limits>
#include <optional>
#include <vector>

#include "library/answer/quantities.hpp"
#include "numeric/bodies/approach.hpp"
#include "numeric/flat_punch/flat_punch.hpp"
#include "numeric/solution/contact_solution.hpp"

namespace steadyslide::library {

template <numeric::Real R>
class SolvedContact {
 public:
  using Estimate = numeric::Estimate<R>;

  /// `over`: the length of the window of average pressures.
  SolvedContact(const ContactProblem& problem, const numeric::ContactSolution<R>& solution,
                const std::optional<Rational>& over = std::nullopt)
      : problem_(problem), solution_(solution), contact_(solution.contact()), forces_(solution.resultants()) {
    if (over) average_ = solution.largest_average_pressure(numeric::to_real<R>(*over));
  }

  const std::vector<numeric::ContactComponent<R>>& contact() const { return contact_; }
  const numeric::Resultants<R>& forces() const { return forces_; }
  std::size_t components() const { return contact_.size(); }

  /// From the first end of contact to the last. Without contact, width(), length(), per_length() and largest_pressure()
  /// return an unknown value.
  Estimate width() const {
    if (contact_.size() <= 1) return length();
    return contact_.back().right.x - contact_.front().left.x;
  }
  Estimate length() const { return contact_.empty() ? unknown() : numeric::real_contact_length(contact_); }
  numeric::LargestPressure<R> largest_pressure() const {
    if (contact_.empty()) return {unknown(), unknown(), std::nullopt};
    return solution_.largest_pressure();
  }
  Estimate per_length(const Estimate& force) const { return contact_.empty() ? unknown() : force / length(); }
  std::optional<Estimate> tilt() const { return solution_.tilt(); }
  std::optional<Estimate> average_pressure() const { return average_ ? std::optional(average_->value) : std::nullopt; }
  std::optional<Estimate> average_at() const { return average_ ? std::optional(average_->x) : std::nullopt; }
  std::optional<Estimate> approach() const {
    if constexpr (std::same_as<R, double>) return numeric::approach(problem_, solution_);
    return std::nullopt;
  }
  std::optional<answer::IntervalOf<Estimate>> core() const {
    const auto core = numeric::punch_core<R>(problem_);
    return core ? std::optional(answer::IntervalOf<Estimate>{core->left, core->right}) : std::nullopt;
  }

 private:
  static Estimate unknown() { return {R(std::numeric_limits<double>::quiet_NaN()), numeric::infinity<R>()}; }

  const ContactProblem& problem_;
  const numeric::ContactSolution<R>& solution_;
  std::vector<numeric::ContactComponent<R>> contact_;
  numeric::Resultants<R> forces_;
  std::optional<numeric::AveragePressure<R>> average_;
};

}  // namespace steadyslide::library
