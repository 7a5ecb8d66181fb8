#pragma once
// The numbers of a proved contact solution as balls, in the user's units and x: what numeric/solution/contact_solution.hpp
// estimates, with the same signs and definitions of intensities and constants.
//
//   at an end            t = -theta d^lambda
//   at a friction jump   t = constant - theta cos(pi alpha) |x-c|^beta, constant = D/[s]
//   at a wedge           t = theta (log|x-c|/pi + s H(x-c)) + constant, theta = D/(1+s^2)

#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "enclosure/contact/contact_load.hpp"
#include "enclosure/contact/contact_proof.hpp"
#include "model/contact_values.hpp"

namespace steadyslide::enclosure {

class EnclosedSolution {
 public:
  /// `proof` is one: proved. `threads`: of resultants().
  EnclosedSolution(ContactProblem problem, const ContactProof& proof, unsigned threads = 1);

  using End = ContactEndOf<Ball>;
  using Point = SingularPointOf<Ball>;
  using TwoSided = TwoSidedOf<Ball>;

  /// Left to right.
  std::vector<ContactComponentOf<Ball>> contact() const;
  /// Those at ends of contact and inside, left to right.
  std::vector<Point> singular_points() const;

  struct Resultants {
    Ball normal;
    Ball tangential;
    Ball centre_of_pressure;
    Ball effective_friction;
    std::vector<Ball> load_share;
  };
  Resultants resultants() const;
  // For what integrates tractions: the form, in xi, and the part of a segment between two xi; absent if there is none, not
  // finite where an end of contact may lie at one of them.
  const TractionRepresentation& form() const { return form_; }
  std::optional<ContactPanel::Range> range(std::size_t segment, const Rational& from, const Rational& to) const;
  /// t_t/t on a segment.
  Rational shear_ratio(std::size_t segment) const { return problem_.shear_ratio(set().interval(segment).friction); }

  /// The slope added to psi where the indenter may tilt.
  std::optional<Ball> tilt() const;

  /// t at x: 0 off the contact, -infinity where it blows up; what contains everything where x may be a free end.
  TwoSided traction(const Rational& x) const;
  /// u' at x, in the support or not; infinite beside an edge.
  TwoSided slope(const Rational& x) const;
  /// psi - u - C at x; absent outside the support.
  std::optional<Ball> gap(const Rational& x) const;

 private:
  const ContactSet& set() const { return form_.set(); }
  Ball user(const Ball& xi) const;
  /// xi of a point of the data; absent for a free end.
  std::optional<Rational> exact(std::size_t j) const;
  Place seen_from(std::size_t segment, const Rational& xi) const;
  End end(std::size_t j) const;
  /// theta' (2 pi)^-lambda, lambda the exponent at point j.
  Ball stress_intensity(std::size_t j, const Ball& coefficient) const;
  /// eps cos(pi alpha) prod' |x - x_j|^p B without its singular term, in the segment's limit at its point j.
  Ball amplitude(std::size_t j, std::size_t segment) const;
  /// Where x is, seen from one of its sides; absent where x may be a free end.
  std::optional<Place> place(const Rational& x, Side side) const;
  bool in_contact_at(std::size_t j, Side side) const;
  Ball traction_limit(std::size_t j, Side side) const;
  Ball traction_at(const Place& place) const;
  Ball slope_limit(std::size_t j, Side side) const;
  Ball slope_at(const Place& place) const;
  template <class Limit, class Value>
  TwoSided two_sided(const Rational& x, Limit limit, Value value) const;

  ContactProblem problem_;
  Bits bits_;
  std::shared_ptr<const ReducedProblem> reduced_;  ///< the form points to it
  std::shared_ptr<JacobiRules> rules_;
  Ball compliance_;
  Ball unit_;
  Ball origin_;
  TractionRepresentation form_;
  Ball tilt_;
  unsigned threads_;
};

}  // namespace steadyslide::enclosure
