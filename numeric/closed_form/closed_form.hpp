#pragma once
// Closed forms on one contact component [e_0, e_n], for profiles that leave no integral: with Y of
// fundamental_solution.hpp and N a constant,
//
//   u'/c = psi'/c - N Y off the contact,   t = -|N| cos(pi alpha) |Y| on it.
//
//   flat punch: the whole support in contact, edges at both ends, N = -P/pi. [Bal16, (4), (5)-(7)]
//   parabola:   free ends, N = 1/R. Contains Galin's parabola [Bal16, section 2].
//
// Lengths are measured from an exact origin (the punch's centre, the parabola's vertex).

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "numeric/cauchy/power_traction.hpp"
#include "numeric/cauchy/residuals.hpp"
#include "numeric/cauchy/traction_integrals.hpp"

namespace steadyslide::numeric {

/// Values of friction that a solution by powers is for: in double its cost grows like their number, and in more digits
/// like its square.
inline constexpr std::size_t max_friction_pieces = 1'000'000;
inline constexpr std::size_t max_friction_pieces_in_digits = 1000;
/// Empty, or why a solution by powers is not for this problem.
std::string too_many_friction_pieces(const ContactProblem& problem, Digits digits);

/// What a closed form consists of.
template <Real R>
struct ClosedFormData {
  Rational origin;
  SingularKind ends;                           ///< edge or free, both alike
  std::size_t first_piece;                     ///< the friction piece at the left end
  std::vector<Exponent> exponents;             ///< at e_0..e_n
  std::vector<std::optional<Rational>> exact;  ///< e_0..e_n from the origin, where they are data
  R end_error;                                 ///< estimated absolute error of e_0 and e_n
  R factor;                                    ///< N
  PowerTraction<R> traction;
};

/// The data of the closed form that applies, or the reason why none does.
template <Real R>
std::variant<ClosedFormData<R>, std::string> closed_form_data(const ContactProblem& problem);

template <Real R>
class ClosedForm : public ContactSolution<R> {
 public:
  ClosedForm(ContactProblem problem, ClosedFormData<R> data);

  const ClosedFormData<R>& data() const { return data_; }
  R traction(std::size_t panel, const Node<R>& node) const { return data_.traction(panel, node); }

  std::string method() const override { return "closed-form"; }
  std::vector<ContactComponent<R>> contact() const override;
  ApproximateContact approximate_contact() const override;
  std::vector<SolvedSingularPoint<R>> singular_points() const override;
  Resultants<R> resultants() const override;
  LargestPressure<R> largest_pressure() const override;
  EstimatedError<R> estimated_error() const override;
  Residuals<R> residuals() const override;
  Sample<R> at(const Rational& x) const override;
  void tractions(std::span<const R> x, std::span<R> normal, std::span<R> shear) const override;
  PiecewiseTraction<R> piecewise_traction() const override;
  std::vector<Sample<R>> samples(int count) const override;
  DetailedSample<R> details_at(const Rational& x) const override;
  std::vector<DetailedSample<R>> detailed_samples(int count) const override;

 private:
  const FundamentalSolution<R>& weight() const { return data_.traction.weight; }
  Estimate<R> coordinate(std::size_t j) const;
  /// e_0..e_n in the user's x.
  std::vector<Rational> points() const;
  R relative_error(std::size_t panel, int times) const;
  Estimate<R> intensity(std::size_t j) const;
  R profile_slope(const R& from_origin) const;
  /// The slope of the surface in the contact: the profile's, in the user's units.
  Estimate<R> slope_in_contact(const R& from_origin) const;
  /// What of x is known: the panel it is inside of, by its distances, the singular point it is, or the distance beyond an
  /// end.
  struct Place {
    std::size_t panel;  ///< or the point, or the panel at the end
    std::optional<Node<R>> inside{};
    std::optional<Side> beyond{};
    R distance = 0;

    bool is_point() const { return !inside && !beyond; }
  };
  Place locate(const Rational& x) const;
  /// Those of samples(): inside panels with the tractions there.
  std::vector<std::pair<Place, R>> places(int count) const;
  Sample<R> at(const Place& place) const;
  Sample<R> inside(std::size_t panel, const Node<R>& node, const R& traction) const;
  Sample<R> at_point(std::size_t j) const;
  Sample<R> outside(Side side, const R& distance) const;
  Estimate<R> below_profile(Side side, const R& distance) const;
  R relative_error_beyond(Side side, const R& distance) const;
  Sample<R> sample(const std::pair<Place, R>& at) const;
  Estimate<R> limit_at_point(std::size_t j, Side side) const;
  R gap_length(Side side) const;
  /// The traction sampled by the rule that residuals come from, which is also the cheapest for loads in high precision.
  const SurfaceCheck<R>& check() const;
  /// int t over each panel.
  const std::vector<Estimate<R>>& loads() const;
  const TractionIntegrals<R>& integrals() const;
  /// u + C at a place; its error is that of the gap.
  Estimate<R> height(const Place& place) const;
  DetailedSample<R> detailed(const Place& place, const Sample<R>& sample) const;

  ContactProblem problem_;
  R compliance_;
  ClosedFormData<R> data_;
  Once<SurfaceCheck<R>> check_;
  Once<Resultants<R>> resultants_;
  Once<std::vector<Estimate<R>>> loads_;
  Once<TractionIntegrals<R>> integrals_;
  Once<Estimate<R>> height_at_origin_;
};

}  // namespace steadyslide::numeric
