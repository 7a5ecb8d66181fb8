#include "library/problem_file/smoothing.hpp"

#include <gsl/gsl_linalg.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace steadyslide::library {
namespace {

using std::numbers::pi;

/// Sums of weights and of weights times heights.
struct WeightedSums {
  double weights = 0;
  double heights = 0;

  double mean() const { return heights / weights; }
};

class GaussFilter {
 public:
  GaussFilter(const std::vector<double>& x, const std::vector<double>& heights, double cutoff)
      : x_(x), heights_(heights), width_(std::sqrt(std::numbers::ln2 / pi) * cutoff) {
    for (std::size_t i = 0; i < x.size(); ++i) {
      trapezoids_.push_back((x[std::min(i + 1, x.size() - 1)] - x[i > 0 ? i - 1 : 0]) / 2);
    }
  }

  WeightedSums at(double place) const {
    // Beyond this distance the weight is below the rounding of the weight at 0.
    const double reach = 3.5 * width_;
    WeightedSums sums;
    auto i = static_cast<std::size_t>(std::lower_bound(x_.begin(), x_.end(), place - reach) - x_.begin());
    for (; i < x_.size() && x_[i] <= place + reach; ++i) {
      const double u = (x_[i] - place) / width_;
      const double weight = trapezoids_[i] * std::exp(-pi * u * u);
      sums.weights += weight;
      sums.heights += weight * heights_[i];
    }
    return sums;
  }

 private:
  const std::vector<double>& x_;
  const std::vector<double>& heights_;
  double width_;
  std::vector<double> trapezoids_;
};

/// The sums on an interval of at most half a cutoff, interpolated between Chebyshev points. There the sums are so
/// smooth that the error is below the rounding of double.
class InterpolatedSums {
 public:
  static constexpr std::size_t degree = 24;

  InterpolatedSums(const GaussFilter& filter, double left, double right)
      : middle_((left + right) / 2), radius_((right - left) / 2) {
    for (std::size_t k = 0; k <= degree; ++k) {
      places_.push_back(std::cos(pi * static_cast<double>(k) / degree));
      sums_.push_back(filter.at(middle_ + radius_ * places_[k]));
    }
  }

  /// The barycentric formula.
  WeightedSums at(double place) const {
    const double t = (place - middle_) / radius_;
    WeightedSums above;
    double below = 0;
    for (std::size_t k = 0; k <= degree; ++k) {
      if (t == places_[k]) return sums_[k];
      const double half = k == 0 || k == degree ? 0.5 : 1;
      const double factor = (k % 2 == 0 ? half : -half) / (t - places_[k]);
      above.weights += factor * sums_[k].weights;
      above.heights += factor * sums_[k].heights;
      below += factor;
    }
    return {above.weights / below, above.heights / below};
  }

 private:
  double middle_;
  double radius_;
  std::vector<double> places_;
  std::vector<WeightedSums> sums_;
};

}  // namespace

std::vector<double> gauss_filtered(const std::vector<double>& x, const std::vector<double>& heights, double cutoff) {
  const GaussFilter filter(x, heights, cutoff);
  std::vector<double> result;
  for (auto first = x.begin(); first != x.end();) {
    const auto end = std::lower_bound(first + 1, x.end(), *first + cutoff / 2);
    const auto add_all = [&](const auto& sums) {
      for (; first != end; ++first) result.push_back(sums.at(*first).mean());
    };
    // Interpolation makes the work grow only in proportion to the number of points.
    if (static_cast<std::size_t>(end - first) > InterpolatedSums::degree) {
      add_all(InterpolatedSums(filter, *first, *(end - 1)));
    } else {
      add_all(filter);
    }
  }
  return result;
}

std::vector<double> spline_slopes(const std::vector<double>& distances, const std::vector<double>& lines) {
  // The second derivatives on both sides of point i agree if
  // m[i-1]/h[i-1] + 2 (1/h[i-1] + 1/h[i]) m[i] + m[i+1]/h[i] = 3 (d[i-1]/h[i-1] + d[i]/h[i]); at an end one side is 0.
  const std::size_t pieces = distances.size();
  std::vector<double> beside, diagonal(pieces + 1), right_side(pieces + 1), slopes(pieces + 1);
  for (std::size_t i = 0; i < pieces; ++i) {
    const double inverse = 1 / distances[i];
    beside.push_back(inverse);
    for (const std::size_t k : {i, i + 1}) {
      diagonal[k] += 2 * inverse;
      right_side[k] += 3 * inverse * lines[i];
    }
  }
  const auto diagonal_view = gsl_vector_const_view_array(diagonal.data(), diagonal.size());
  const auto beside_view = gsl_vector_const_view_array(beside.data(), beside.size());
  const auto right_view = gsl_vector_const_view_array(right_side.data(), right_side.size());
  auto slopes_view = gsl_vector_view_array(slopes.data(), slopes.size());
  gsl_linalg_solve_symm_tridiag(&diagonal_view.vector, &beside_view.vector, &right_view.vector, &slopes_view.vector);
  return slopes;
}

}  // namespace steadyslide::library
