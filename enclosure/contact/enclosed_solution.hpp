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
#include "model/singular_point.hpp"

namespace steadyslide::enclosure {

class EnclosedSolution {
 public:
  /// `proof` is one: proved.
  EnclosedSolution(ContactProblem problem, const ContactProof& proof);

  struct End {
    Ball x;
    SingularKind kind;
    Exponent exponent;
    Ball intensity;
  };
  std::vector<std::pair<End, End>> contact() const;

  struct Point {
    Ball x;
    SingularKind kind;
    std::optional<Exponent> exponent;  ///< absent: logarithm
    Ball intensity;
    Ball constant;
  };
  /// Those inside the contact, left to right.
  std::vector<Point> singular_points() const;

  struct Resultants {
    Ball normal;
    Ball tangential;
    Ball centre_of_pressure;
    Ball effective_friction;
    std::vector<Ball> load_share;
  };
  Resultants resultants() const;
  /// The slope added to psi where the indenter may tilt.
  std::optional<Ball> tilt() const;

  struct TwoSided {
    Ball left;
    Ball right;
  };
  /// t at x; 0 off the contact, not finite where it is singular or where x may be an end.
  TwoSided traction(const Rational& x) const;
  /// u' at x in the support.
  TwoSided slope(const Rational& x) const;

 private:
  const ContactSet& set() const { return form_.set(); }
  Ball user(const Ball& xi) const;
  Ball from_unit(const Ball& power) const;
  End end(std::size_t j) const;
  /// eps cos(pi alpha) prod' |x - x_j|^p B without its singular term, in the segment's limit at its point j.
  Ball amplitude(std::size_t j, std::size_t segment) const;
  std::optional<Place> place(const Rational& x, Side side) const;
  Ball traction_at(const Place& place) const;
  Ball slope_at(const Place& place) const;

  ContactProblem problem_;
  Bits bits_;
  std::shared_ptr<const ReducedProblem> reduced_;  ///< the form points to it
  std::shared_ptr<JacobiRules> rules_;
  Ball unit_;
  Ball origin_;
  ContactForm form_;
  Ball tilt_;
};

}  // namespace steadyslide::enclosure
