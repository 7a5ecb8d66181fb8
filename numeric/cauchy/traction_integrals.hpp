#pragma once
// What integrals of a traction, given panel by panel, say of a place x of the surface: the load up to x, and
//
//   u_t'/c = r (u'/c - s t) + gamma t + sum_k (r_k - r) (1/pi) int_k t/(x'-x) dx',
//
// r_k = t_t/t on panel k and r, s those of the panel that x lies in or beside: with one ratio everywhere the principal
// value of t_t is r times that of t, and what is left for other ratios keeps clear of x. [Bal16, (2)]

#include <memory>
#include <optional>
#include <vector>

#include "numeric/cauchy/density.hpp"
#include "numeric/solution/contact_solution.hpp"

namespace steadyslide::numeric {

class DistantTractions;

/// A place by what lies on both sides of it: `panels` panels end on its left, or at it.
template <Real R>
struct LinePlace {
  std::size_t panels;
  R to_left;                        ///< to the nearest panel that ends on the left, and begins on the right;
  R to_right;                       ///< infinite where there is none
  std::optional<Node<R>> inside{};  ///< panel number `panels`
};

template <Real R>
class TractionIntegrals {
 public:
  /// What is known of t on a panel but its values.
  struct OnPanel {
    Estimate<R> load;  ///< int t
    R relative_error;  ///< the largest one of t, estimated
    R left_error;      ///< the error of t next to the panel's left end,
    R right_error;     ///< and next to its right end
    R s;
    Rational ratio;  ///< t_t/t, exact: rounded ratios of neighbours lose their difference
  };
  /// Of the reduced problem. Panels of various friction that are many stand together in cells where they are far from a
  /// place, in double: as `solution` tells the same traction, its lengths `unit` times those of the density.
  TractionIntegrals(PiecewiseDensity<R> density, std::vector<OnPanel> on_panels, const R& gamma,
                    const ContactSolution<R>& solution, const R& unit);

  /// Adds to a sample what integrals say of its place: the load up to there, and u_t'. `compliance` is c; `end_error`, of the
  /// reduced problem, is by how much the contact's ends may be displaced.
  void add_to(DetailedSample<R>& sample, const LinePlace<R>& place, bool is_singular_point, const R& compliance,
              const R& end_error) const;
  /// u_t'/c where t and the reduced slope are known, at no singular point.
  Estimate<R> shear_slope(const LinePlace<R>& place, const Estimate<R>& traction, const Estimate<R>& slope) const;

 private:
  /// -int t over all that lies left of a place.
  Estimate<R> load_before(const LinePlace<R>& place) const;
  std::size_t nearest(const LinePlace<R>& place) const;
  Estimate<R> from_slope(std::size_t panel, const LinePlace<R>& place, const Estimate<R>& traction,
                         const Estimate<R>& slope) const;
  /// The limit of shear_slope() at a place between two panels, or at the end of one, from those of t and of the reduced slope.
  Estimate<R> limit(const LinePlace<R>& place, Side side, const TwoSided<R>& traction, const TwoSided<R>& slope) const;
  /// (1/pi) int t/(x'-x) over panel k, x at a distance to that side of it.
  Estimate<R> cauchy(std::size_t k, Side side, const R& distance) const;

  PiecewiseDensity<R> density_;
  std::vector<Estimate<R>> before_;  ///< -int t over the panels before each, and over all
  std::vector<OnPanel> on_panels_;
  R gamma_;
  R unit_;
  std::shared_ptr<const DistantTractions> distant_;  ///< null where there are few
};

}  // namespace steadyslide::numeric
