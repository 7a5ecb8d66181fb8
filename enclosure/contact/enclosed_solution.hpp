#pragma once
// The values of a proved contact solution as balls, in the user's units and x: the quantities that
// numeric/solution/contact_solution.hpp estimates, with the same signs and definitions of intensities and constants
// (docs/results.md, "Values at singular points").

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
  /// `proof` must be proved. `threads` is the number of threads of resultants().
  EnclosedSolution(ContactProblem problem, const ContactProof& proof, unsigned threads = 1);

  using End = ContactEndOf<Ball>;
  using Point = SingularPointOf<Ball>;
  using TwoSided = TwoSidedOf<Ball>;

  /// Returns the components from left to right.
  std::vector<ContactComponentOf<Ball>> contact() const;
  /// Returns the singular points at ends of contact and inside, from left to right.
  std::vector<Point> singular_points() const;

  struct Resultants {
    Ball normal;
    Ball tangential;
    Ball centre_of_pressure;
    Ball effective_friction;
    std::vector<Ball> load_share;
  };
  Resultants resultants() const;
  // For integrals of the traction: the form, in xi, and the part of a segment between two xi. The part is absent if
  // there is none, and not finite if an end of contact may lie at one of the two xi.
  const TractionRepresentation& form() const { return form_; }
  std::optional<ContactPanel::DistanceRange> range(std::size_t segment, const Rational& from, const Rational& to) const;
  /// Returns t_t/t on a segment.
  Rational shear_ratio(std::size_t segment) const { return problem_.shear_ratio(set().interval(segment).friction); }

  /// Returns the slope that is added to psi, if the indenter may tilt.
  std::optional<Ball> tilt() const;

  /// Returns t at x: 0 outside the contact, -infinity where it blows up. If x may be a free end, the ball contains all
  /// numbers.
  TwoSided traction(const Rational& x) const;
  /// Returns u' at x, inside or outside the support; infinite beside an edge.
  TwoSided slope(const Rational& x) const;
  /// Returns psi - u - C at x; absent outside the support.
  std::optional<Ball> gap(const Rational& x) const;

 private:
  const ContactSet& set() const { return form_.set(); }
  Ball user(const Ball& xi) const;
  /// Returns xi of a point of the data; absent for a free end.
  std::optional<Rational> exact(std::size_t j) const;
  SurfacePoint seen_from(std::size_t segment, const Rational& xi) const;
  End end(std::size_t j) const;
  /// Returns the exact terms at point j inside the contact; absent if nothing jumps there.
  std::optional<InnerTerms> inner_terms_at(std::size_t j) const;
  /// Returns theta' (2 pi)^-lambda, where lambda is the exponent at point j.
  Ball stress_intensity(std::size_t j, const Ball& coefficient) const;
  /// Returns eps cos(pi alpha) prod' |x - x_j|^p B without its singular term, as the limit in the segment at its point
  /// j.
  Ball amplitude(std::size_t j, std::size_t segment) const;
  /// Returns the place of x for one of its sides; absent if x may be a free end.
  std::optional<SurfacePoint> place(const Rational& x, Side side) const;
  bool in_contact_at(std::size_t j, Side side) const;
  Ball traction_limit(std::size_t j, Side side) const;
  Ball traction_at(const SurfacePoint& place) const;
  Ball slope_limit(std::size_t j, Side side) const;
  Ball slope_at(const SurfacePoint& place) const;
  template <class Limit, class Value>
  TwoSided two_sided(const Rational& x, Limit limit, Value value) const;

  ContactProblem problem_;
  Bits bits_;
  std::shared_ptr<const ReducedProblem> reduced_;  ///< shared, because the form points to it
  std::shared_ptr<JacobiRules> rules_;
  Ball compliance_;
  Ball unit_;
  Ball origin_;
  TractionRepresentation form_;
  Ball tilt_;
  unsigned threads_;
};

}  // namespace steadyslide::enclosure
