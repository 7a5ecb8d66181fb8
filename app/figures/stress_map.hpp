#pragma once
// Maps of von Mises' stress below a contact. The row at the surface is the limit from below.

#include "app/gnuplot/figure.hpp"
#include "numeric/interior/interior_stress.hpp"
#include "numeric/interior/largest_stress.hpp"
#include "numeric/solution/contact_solution.hpp"

namespace steadyslide::app {

/// The flat punch with two coatings under the map `stress-map`, and the parabola of `stress-parabola`.
ContactProblem stress_map_problem();
ContactProblem stress_parabola_problem();

/// The largest difference of sigma_zz and sigma_xz between the depth z and the surface, 0.25 away from the singular
/// points of stress_map_problem().
double surface_error(const numeric::ContactSolution<double>& solution, const ContactProblem& problem,
                     const Rational& z);

/// The region and the scales of a map: -width < x < width and 0 < z < depth in units of `length`, stresses in units of
/// `stress`.
struct MapView {
  double length = 1;
  double stress = 1;
  double width;
  double depth;
  double highest;  ///< the stress of the last colour
  std::string length_name;
  std::string stress_name;
  std::vector<double> contours;
};

Panel stress_panel(const numeric::ContactSolution<double>& solution, const ContactProblem& problem,
                   const MapView& view);

/// Marks the largest stress at depths of at least `depth` with its value, and returns it.
numeric::LargestStress<double> mark_largest(Panel& panel, const numeric::ContactSolution<double>& solution,
                                            const MapView& view, double depth);

}  // namespace steadyslide::app
