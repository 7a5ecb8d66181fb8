#pragma once
// The reduced problem (model/reduced_problem.hpp) rounded to numbers of one type. Each number is rounded once, from its
// exact value. No number is a difference of two rounded numbers.

#include <array>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "model/reduced_problem.hpp"
#include "numeric/cauchy/fundamental_solution.hpp"
#include "numeric/number/polynomial.hpp"

namespace steadyslide::numeric {

template <Real R>
class RoundedProblem {
 public:
  /// `most_coupled`: the number of components up to which one fundamental solution has all their powers
  /// (signed_fundamental_solution.hpp).
  RoundedProblem(const ContactProblem& problem, const Frame& frame, std::size_t most_coupled = 4);

  struct Anchor {
    R x;     ///< xi
    R step;  ///< height on the right minus height on the left; 0 at the support's ends
    int step_sign;
    bool is_break;  ///< the profile changes its polynomial here
    R s_jump;       ///< s on the right minus s on the left, from the exact difference
    ReducedProblem::Anchor exact;
  };

  const ContactProblem& problem() const { return *problem_; }
  const Frame& frame() const { return exact_.frame; }
  /// Returns the anchors. The first and the last one are the support's ends.
  const std::vector<Anchor>& anchors() const { return anchors_; }
  /// Returns the place of anchor k in the user's x.
  Rational place(std::size_t k) const { return exact_.place(k); }
  /// Returns the distance from anchor k to the next one.
  const R& spacing(std::size_t k) const { return spacing_[k]; }

  /// For interval k, from anchor k to the next one: the index into slopes(), and the friction piece.
  std::size_t slope_of(std::size_t interval) const { return exact_.intervals[interval].slope; }
  std::size_t friction_of(std::size_t interval) const { return exact_.intervals[interval].friction; }
  /// Returns the different polynomials g, as coefficients of 1, xi, xi^2, ...
  const std::vector<std::vector<R>>& slopes() const { return slopes_; }
  R slope(std::size_t index, const R& x) const { return value_of(slopes_[index], x); }
  /// Returns the slope with its rounding error.
  Estimate<R> slope_estimate(std::size_t index, const R& x) const { return estimate_of(slopes_[index], x); }
  /// Returns this error in units of epsilon.
  double slope_size(std::size_t index, const R& x) const { return rounding_size(slopes_[index], x); }
  /// Returns int g dxi over `length`, starting at `from`. The length may have more digits than the difference of two
  /// places.
  R profile_increment(std::size_t index, const R& from, const R& length) const;
  int highest_degree() const { return highest_degree_; }
  std::size_t most_coupled() const { return most_coupled_; }
  /// Returns the shortest gap over a notch or beside a step that is followed, in xi. Products with a shorter length
  /// (with many components, of two such lengths: signed_fundamental_solution.hpp) would be out of the range of double,
  /// in which the contact is found for every precision.
  const R& shortest_gap() const { return shortest_gap_; }

  const R& s(std::size_t friction) const { return s_[friction]; }
  const R& cos_alpha(std::size_t friction) const { return cos_alpha_[friction]; }
  const R& load() const { return load_; }
  /// Returns the place where the load acts, if the indenter may tilt.
  const std::optional<R>& load_at() const { return load_at_; }

  /// True if the traction may blow up where contact ends at this anchor: at the support's ends and where a step
  /// protrudes.
  bool edge_possible(End end, std::size_t anchor) const;

  /// A power of the traction, with its exact form.
  struct Singularity {
    Exponent exponent;
    Power<R> power;
  };
  const Singularity& end(End end, bool edge, std::size_t friction) const;
  /// Returns the singularity of the friction jump at an anchor; its power is 0 if the friction does not change.
  const Singularity& jump(std::size_t anchor) const;

 private:
  using Slot = std::optional<Singularity>;
  template <class Make>
  const Singularity& cached(Slot& slot, const Make& make) const;

  const ContactProblem* problem_;
  ReducedProblem exact_;
  std::vector<Anchor> anchors_;
  std::vector<R> spacing_;
  std::vector<std::vector<R>> slopes_;
  int highest_degree_ = 0;
  std::size_t most_coupled_;
  R shortest_gap_;
  std::vector<R> s_;
  std::vector<R> cos_alpha_;
  R load_;
  std::optional<R> load_at_;
  // An exponent is expensive compared with a solve, so it is computed at first use.
  std::shared_ptr<std::mutex> making_ = std::make_shared<std::mutex>();
  mutable std::vector<std::array<Slot, 4>> ends_;
  mutable std::vector<Slot> jumps_;
};

}  // namespace steadyslide::numeric
