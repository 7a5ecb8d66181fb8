#pragma once
// Integrals of a traction that is given panel by panel, at a place x of the surface: the load up to x, and
//
//   u_t'/c = r (u'/c - s t) + gamma t + sum_k (r_k - r) (1/pi) int_k t/(x'-x) dx',
//
// with r_k = t_t/t on panel k, and r, s of the panel that contains x or is next to x. If the ratio is the same
// everywhere, the principal value of t_t is r times that of t. The remaining integrals, over panels with other ratios,
// do not contain x. [Bal16, (2)]

#include <memory>
#include <optional>
#include <vector>

#include "numeric/quadrature/density.hpp"
#include "numeric/solution/contact_solution.hpp"

namespace steadyslide::numeric {

class DistantTractions;

/// A place on the line, given by its neighbours: `panels` panels end on its left, or at it.
template <Real R>
struct LinePlace {
  std::size_t panels;
  R to_left;                        ///< distance to the nearest panel on the left; infinite if there is none
  R to_right;                       ///< distance to the nearest panel on the right; infinite if there is none
  std::optional<Node<R>> inside{};  ///< panel number `panels`
};

template <Real R>
class TractionIntegrals {
 public:
  /// The data of t on a panel, besides its values.
  struct OnPanel {
    Estimate<R> load;  ///< int t
    R relative_error;  ///< the largest relative error of t, estimated
    R left_error;      ///< the error of t next to the panel's left end
    R right_error;     ///< the error of t next to the panel's right end
    R s;
    Rational ratio;  ///< t_t/t, exact, because the difference of rounded ratios would lose digits
  };
  /// All arguments belong to the reduced problem. In double, many panels with different friction are grouped in cells
  /// where they are far from a place. The cells use the traction from `solution`, whose lengths are `unit` times the
  /// lengths of the density.
  TractionIntegrals(PiecewiseDensity<R> density, std::vector<OnPanel> on_panels, const R& gamma,
                    const ContactSolution<R>& solution, const R& unit);

  /// Adds the integrals to a sample: the load up to its place, and u_t'. `compliance` is c. `end_error` is the error of
  /// the contact's ends in the reduced problem.
  void add_to(DetailedSample<R>& sample, const LinePlace<R>& place, bool is_singular_point, const R& compliance,
              const R& end_error) const;
  /// Returns u_t'/c from t and the reduced slope. The place is not a singular point.
  Estimate<R> shear_slope(const LinePlace<R>& place, const Estimate<R>& traction, const Estimate<R>& slope) const;

 private:
  /// Returns -int t over everything on the left of a place.
  Estimate<R> load_before(const LinePlace<R>& place) const;
  std::size_t nearest(const LinePlace<R>& place) const;
  Estimate<R> from_slope(std::size_t panel, const LinePlace<R>& place, const Estimate<R>& traction,
                         const Estimate<R>& slope) const;
  /// Returns the limit of shear_slope() at a place between two panels, or at the end of one, from the limits of t and
  /// of the reduced slope.
  Estimate<R> limit(const LinePlace<R>& place, Side side, const TwoSided<R>& traction, const TwoSided<R>& slope) const;
  /// Returns (1/pi) int t/(x'-x) over panel k, for x at a distance on that side of the panel.
  Estimate<R> cauchy(std::size_t k, Side side, const R& distance) const;

  PiecewiseDensity<R> density_;
  std::vector<Estimate<R>> before_;  ///< -int t over the panels before each panel; the last entry is over all panels
  std::vector<OnPanel> on_panels_;
  R gamma_;
  R unit_;
  std::shared_ptr<const DistantTractions> distant_;  ///< null if there are few panels
};

}  // namespace steadyslide::numeric
