#pragma once
// Smooth curves through measured points, in double.
//
//   Filter: the mean of all heights with the weights of the Gaussian filter of ISO 16610-21,
//   s(x) = exp(-pi (x/(a L))^2)/(a L), a = sqrt(log 2/pi), L the cutoff. A sine of the wavelength l keeps the part
//   exp(-pi (a L/l)^2) of its amplitude, one half for l = L. The weight of a point is also its part of the trapezoidal
//   rule, so points need not be equally spaced. All weights are divided by their sum; near an end of the trace this is
//   the retention of the moment of order zero of ISO 16610-28: a constant stays a constant.
//
//   Spline: the natural cubic spline. Its second derivative is continuous, and 0 at both ends.

#include <vector>

namespace steadyslide::library {

/// Takes points with increasing x, and a cutoff > 0. Returns the filtered heights.
std::vector<double> gauss_filtered(const std::vector<double>& x, const std::vector<double>& heights, double cutoff);

/// Takes the distances between neighbouring points, normal numbers > 0, and the slopes of the straight lines between
/// them. Returns the slopes of the spline at the points, one more than distances. They are not finite if double
/// overflows.
std::vector<double> spline_slopes(const std::vector<double>& distances, const std::vector<double>& lines);

}  // namespace steadyslide::library
