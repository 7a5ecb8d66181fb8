#pragma once
// Closed forms on one contact component [e_0, e_n], for profiles that need no integrals. With Y of
// fundamental_solution.hpp and a constant N,
//
//   u'/c = psi'/c - N Y outside the contact,   t = -|N| cos(pi alpha) |Y| on it.
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

/// The largest number of friction values for a solution by powers. Its cost grows in proportion to this number in
/// double, and to its square in higher precision.
inline constexpr std::size_t max_friction_pieces = 1'000'000;
inline constexpr std::size_t max_friction_pieces_in_digits = 1000;
/// Returns why the problem has too many friction values for a solution by powers; empty if it has not.
std::string too_many_friction_pieces(const ContactProblem& problem, Digits digits);

/// The data of a closed form.
template <Real R>
struct ClosedFormData {
  Rational origin;
  SingularKind ends;                           ///< `edge` or `free`, the same for both ends
  std::size_t first_piece;                     ///< the friction piece at the left end
  std::vector<Exponent> exponents;             ///< at e_0..e_n
  std::vector<std::optional<Rational>> exact;  ///< e_0..e_n, measured from the origin; absent if not a datum
  R end_error;                                 ///< estimated absolute error of e_0 and e_n
  R factor;                                    ///< N
  PowerTraction<R> traction;
};

/// Returns the data of the closed form that applies, or the reason why none applies.
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
  /// Returns e_0..e_n in the user's x.
  std::vector<Rational> points() const;
  R relative_error(std::size_t panel, int times) const;
  Estimate<R> intensity(std::size_t j) const;
  R profile_slope(const R& from_origin) const;
  /// Returns the slope of the surface in the contact, which is the slope of the profile, in the user's units.
  Estimate<R> slope_in_contact(const R& from_origin) const;
  /// A place x: a panel and the distances from its ends, or a singular point, or a distance beyond an end.
  struct LocatedPoint {
    std::size_t panel;  ///< the panel, or the index of the point, or the panel at the end
    std::optional<Node<R>> inside{};
    std::optional<Side> beyond{};
    R distance = 0;

    bool is_point() const { return !inside && !beyond; }
  };
  LocatedPoint locate(const Rational& x) const;
  /// Returns the places of samples(), with tractions for places inside panels.
  std::vector<std::pair<LocatedPoint, R>> places(int count) const;
  Sample<R> at(const LocatedPoint& place) const;
  Sample<R> inside(std::size_t panel, const Node<R>& node, const R& traction) const;
  Sample<R> at_point(std::size_t j) const;
  Sample<R> outside(Side side, const R& distance) const;
  Estimate<R> below_profile(Side side, const R& distance) const;
  R relative_error_beyond(Side side, const R& distance) const;
  Sample<R> sample(const std::pair<LocatedPoint, R>& at) const;
  Estimate<R> limit_at_point(std::size_t j, Side side) const;
  R gap_length(Side side) const;
  /// Returns the traction sampled by the rule for residuals, which is also the fastest rule for loads in high
  /// precision.
  const SurfaceCheck<R>& check() const;
  /// Returns int t over each panel.
  const std::vector<Estimate<R>>& loads() const;
  const TractionIntegrals<R>& integrals() const;
  /// Returns u + C at a place. Its error is that of the gap.
  Estimate<R> height(const LocatedPoint& place) const;
  DetailedSample<R> detailed(const LocatedPoint& place, const Sample<R>& sample) const;

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
