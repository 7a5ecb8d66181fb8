#pragma once
// What cells say about a singular point of the traction: the exponent itself by one who does not know it, and, where it
// is known, the intensity. Signs and factors as in contact_solution.hpp:
//
//   ends:   t = -theta d^lambda (1 + c_1 d + ...)
//   jumps:  t = D(x)/(s+ - s-) - theta cos(pi alpha) |x-c|^beta (1 + b_1 (x-c) + ...), D = 0 without wedge
//   wedge:  t = D(x)/(1+s^2) (log|x-c|/pi + s H(x-c)) + analytic;  intensity D(c)/(1+s^2), constant the analytic
//           part at c, with lengths in the unit of the cells
//
// Each result is the median over a family of fits, which differ in window and in number of terms; the error is the
// spread of the family, for exponents plus what noise from cell to cell does to one fit: an estimate, no bound. It is
// the error of reading. An intensity may be off by more, if the cells hold a contact whose ends are a part of a cell
// away; a second mesh shows that. An exponent is not: it depends on nothing but the equation nearby. Where the cells
// are too few for the family, `stalled` with an infinite error. Nothing here knows of problems or solvers.

#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "model/direction.hpp"
#include "numeric/number/estimate.hpp"

namespace steadyslide::numeric::variational {

// The local forms of the traction next to a singular point c, fitted to means over cells by linear least squares. With
// y = x - c, d = |y|, H(y) = 1 for y > 0 and 0 for y < 0:
//
//   power:      t = a |y|^lambda sum c_k y^k + sum r_j y^j,             k = -poles..terms, j = 0..remainder
//   logarithm:  t = sum c_k y^k + sum r_j y^j (log|y|/pi + s H(y)),     the same
//
// a = left_factor for y < 0, right_factor for y > 0. The terms k >= 0 are the local form of the solution [Bal16,
// theorems 2, 3 and 9], the c_k the same on both sides. The terms k < 0 solve the equation without load next to c as
// well, with too much energy for a solution: what cells make wrong next to c reaches further cells as such terms, with
// c_k of the order of the cells' length to the power -k. A place that is wrong by delta is c_-1 = +-lambda delta c_0.

/// Means of t over cells, in any unit. mean.size() + 1 == edges.size(), edges increasing.
struct Cells {
  std::span<const double> edges;
  std::span<const double> mean;
};

/// The cells of one side of c between two distances, neighbours gathered where they are short beside their distance: a
/// mean over near <= |y| <= far.
struct Bin {
  Side side;
  double near;
  double far;
  double mean;
  double weight;  ///< smooth, zero at the ends of the window
};

/// The distances of cells from c that a fit looks at.
struct Window {
  double from;
  double to;
};

/// The cells wholly within the window. Empty unless they are shorter than half their distance.
std::vector<Bin> gathered(const Cells& cells, double place, Side side, const Window& window);

struct LocalSeries {
  std::optional<double> exponent = std::nullopt;  ///< absent: the logarithm
  double left_factor = 1;
  double right_factor = 1;
  double s = 0;
  int poles = 0;
  int terms = 0;
  int remainder = -1;  ///< -1: none
};

struct SeriesFit {
  double amplitude = std::numeric_limits<double>::quiet_NaN();   ///< c_0
  double first_pole = std::numeric_limits<double>::quiet_NaN();  ///< c_-1
  double remainder = std::numeric_limits<double>::quiet_NaN();   ///< r_0
  double square = std::numeric_limits<double>::infinity();       ///< weighted sum of the squares left
  long freedom = 0;                                              ///< bins less coefficients
};

/// Rows are divided by |y|^scaling: with scaling = lambda errors are relative to the singular term. Bins that are no
/// more than the coefficients are not fitted.
SeriesFit fitted(std::span<const Bin> bins, const LocalSeries& series, double scaling);

/// Where the point is, and how far on either side the next singular point lies: what the radius of convergence of the
/// local form depends on, and where the windows end. Ends of other contact are such points, and so is every place of
/// the contact where the profile changes its polynomial, with a wedge or without.
struct LocalPlace {
  double x;
  double left = std::numeric_limits<double>::infinity();
  double right = std::numeric_limits<double>::infinity();
};

/// Is the place as given, or is it a free end which cells know to about one cell's length only?
enum class PlaceIs { exact, to_one_cell };

/// The result of a family of fits: their median, the error their spread and what noise does to the median fit,
/// `deviations` the standard deviation of each. Stalled where more than a third are no numbers.
Estimate<double> of_family(std::vector<double> values, std::vector<double> deviations = {});

struct FittedExponent {
  Estimate<double> exponent;
  Estimate<double> place;  ///< as found if it was known to one cell
};

/// The power lambda of t on one side of c, if t = d^lambda (c_0 + c_1 y + ...): in ]-1, 1[, t of one sign; or beside a
/// polynomial of degree `remainder`, as at a jump with a wedge: |lambda| < 1/2.
/// A leading term that outweighs the next one only within a few cells of c is not seen: lambda is then one too large.
FittedExponent fitted_exponent(const Cells& cells, const LocalPlace& place, Side side, int remainder = -1,
                               PlaceIs known = PlaceIs::exact);

struct FittedIntensity {
  Estimate<double> intensity;
  Estimate<double> constant;  ///< zero where there is none
  Estimate<double> place;
};

/// theta at an end whose contact lies on the side given.
FittedIntensity fitted_end(const Cells& cells, const LocalPlace& place, Side contact, double exponent,
                           PlaceIs known = PlaceIs::exact);

/// theta, and the constant with a wedge, whose jump of slope D is a polynomial of degree `wedge` (-1: none).
FittedIntensity fitted_jump(const Cells& cells, const LocalPlace& place, double exponent, double cos_left,
                            double cos_right, int wedge = -1);

/// The coefficient of log|x-c|/pi, and the constant.
FittedIntensity fitted_wedge(const Cells& cells, const LocalPlace& place, double s, int wedge);

}  // namespace steadyslide::numeric::variational
