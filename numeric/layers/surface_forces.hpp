#pragma once
// The forces of a traction on the surface, gathered at Chebyshev's points on equal parts of the contact. On each part
// the integrals of polynomials up to degree 25 are those of the traction.

#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

namespace steadyslide::numeric {

struct SurfaceForces {
  static constexpr std::size_t order = 26;

  double first = 0;                ///< the left end of the first part
  double length = 1;               ///< of each part
  std::vector<double> normal;      ///< int t: `order` forces on each part; negative in compression
  std::vector<double> tangential;  ///< int t_t along +x
  double normal_error = 0;         ///< estimated error of the sum of |normal|
  double tangential_error = 0;

  std::size_t parts() const { return normal.size() / order; }
  double middle(std::size_t part) const { return first + length * (static_cast<double>(part) + 0.5); }
  /// Returns the distance of point j from the middle of its part.
  double from_middle(std::size_t j) const {
    return length / 2 * std::cos(std::numbers::pi * (static_cast<double>(j) + 0.5) / order);
  }
  double width() const { return length * static_cast<double>(parts()); }
};

}  // namespace steadyslide::numeric
