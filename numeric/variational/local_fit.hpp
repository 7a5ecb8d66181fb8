#pragma once
// Fits of the traction on cells next to a singular point: they measure the exponent without knowing it, and the
// intensity if the exponent is known. Signs and factors as in contact_solution.hpp:
//
//   ends:   t = -theta d^lambda (1 + c_1 d + ...)
//   jumps:  t = D(x)/(s+ - s-) - theta cos(pi alpha) |x-c|^beta (1 + b_1 (x-c) + ...), D = 0 without wedge
//   wedge:  t = D(x)/(1+s^2) (log|x-c|/pi + s H(x-c)) + analytic;  intensity D(c)/(1+s^2), constant the analytic
//           part at c, with lengths in the unit of the cells
//
// Each result is the median over a family of fits, which differ in window and in number of terms. The error is the
// spread of the family; for exponents it also contains the effect of noise from cell to cell on one fit. It is an
// estimate, not a bound, and it is the error of the fit only. An intensity may have a larger error if the ends of
// contact on the cells are displaced by a fraction of a cell; a second mesh shows this. An exponent does not, because
// it depends only on the local equation. If there are too few cells for the family, the result is `stalled` with an
// infinite error. This file uses no problems and no solvers.

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
// theorems 2, 3 and 9]; the c_k are the same on both sides. The terms k < 0 also solve the homogeneous equation next to
// c, but their energy is too large for a solution. Errors of the cells next to c appear in farther cells as such terms,
// with c_k of the order of the cells' length to the power -k. An error delta of the place gives c_-1 = +-lambda delta
// c_0.

/// Means of t over cells, in any unit. mean.size() + 1 == edges.size(), edges increasing.
struct Cells {
  std::span<const double> edges;
  std::span<const double> mean;
};

/// A mean over the cells of one side of c with near <= |y| <= far. Neighbouring cells are combined if they are short
/// compared with their distance.
struct Bin {
  Side side;
  double near;
  double far;
  double mean;
  double weight;  ///< smooth, zero at the ends of the window
};

/// The distances from c of the cells that a fit uses.
struct Window {
  double from;
  double to;
};

/// Returns the cells that lie completely in the window. Empty unless they are shorter than half their distance.
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
  double square = std::numeric_limits<double>::infinity();       ///< weighted sum of squared residuals
  long freedom = 0;                                              ///< number of bins minus number of coefficients
};

/// Returns the fit. Rows are divided by |y|^scaling; with scaling = lambda, errors are relative to the singular term.
/// There is no fit unless there are more bins than coefficients.
SeriesFit fitted(std::span<const Bin> bins, const LocalSeries& series, double scaling);

/// The place of the point, and the distances to the next singular points on both sides. They determine the radius of
/// convergence of the local form and the ends of the windows. Ends of other contact are such points, and so is every
/// place of the contact where the profile changes its polynomial, with or without a wedge.
struct LocalPlace {
  double x;
  double left = std::numeric_limits<double>::infinity();
  double right = std::numeric_limits<double>::infinity();
};

/// The accuracy of the place: exact, or a free end that the cells locate to about one cell length.
enum class PlaceIs { exact, to_one_cell };

/// Returns the result of a family of fits: their median, with an error from their spread and from the noise of the
/// median fit. `deviations` are the standard deviations of the fits. Stalled if fewer than three values, or fewer than
/// two thirds of them, are finite.
Estimate<double> of_family(std::vector<double> values, std::vector<double> deviations = {});

struct FittedExponent {
  Estimate<double> exponent;
  Estimate<double> place;  ///< the fitted place, if it was known to one cell
};

/// Returns the power lambda of t on one side of c, for t = d^lambda (c_0 + c_1 y + ...): in ]-1, 1[ for t of one sign;
/// or with a polynomial of degree `remainder`, as at a jump with a wedge: |lambda| < 1/2. If the leading term exceeds
/// the next one only within a few cells of c, it is not found, and lambda is one too large.
FittedExponent fitted_exponent(const Cells& cells, const LocalPlace& place, Side side, int remainder = -1,
                               PlaceIs known = PlaceIs::exact);

struct FittedIntensity {
  Estimate<double> intensity;
  Estimate<double> constant;  ///< zero if there is none
  Estimate<double> place;
};

/// Returns theta at an end whose contact lies on the given side.
FittedIntensity fitted_end(const Cells& cells, const LocalPlace& place, Side contact, double exponent,
                           PlaceIs known = PlaceIs::exact);

/// Returns theta, and the constant with a wedge, whose slope jump D is a polynomial of degree `wedge` (-1: none).
FittedIntensity fitted_jump(const Cells& cells, const LocalPlace& place, double exponent, double cos_left,
                            double cos_right, int wedge = -1);

/// Returns the coefficient of log|x-c|/pi, and the constant.
FittedIntensity fitted_wedge(const Cells& cells, const LocalPlace& place, double s, int wedge);

}  // namespace steadyslide::numeric::variational
