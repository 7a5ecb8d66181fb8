#include "enclosure/quadrature/jacobi_starts.hpp"

#include <algorithm>
#include <cmath>

namespace steadyslide::enclosure {
namespace {

struct Values {
  double p;
  double slope;
};

/// P_k normalised by P_k(0) = a, from differences in which nothing cancels next to y = 0:
///   P_{k+1} - P_k = h_k (P_k - P_{k-1}) - y g_k P_k,   g, h > 0.
class Differences {
 public:
  Differences(int count, double a, double b) {
    const double total = a + b;
    g_.push_back(total / a);
    h_.push_back(0);
    for (int k = 1; k < count; ++k) {
      const double denominator = (a + k) * (total + (k - 1));
      g_.push_back((total + (2 * k - 1)) * (total + 2 * k) / denominator);
      h_.push_back(k * ((b + (k - 1)) / (total + (2 * k - 2))) * (total + 2 * k) / denominator);
    }
    first_ = a;
  }

  Values at(double y) const {
    double p = first_;
    double slope = 0;
    double change = 0;
    double slope_change = 0;
    for (std::size_t k = 0; k < g_.size(); ++k) {
      slope_change = h_[k] * slope_change - g_[k] * (p + y * slope);
      change = h_[k] * change - y * g_[k] * p;
      p += change;
      slope += slope_change;
    }
    return {p, slope};
  }

 private:
  double first_;
  std::vector<double> g_;
  std::vector<double> h_;
};

}  // namespace

std::vector<double> jacobi_starts(int count, int wanted, double a, double b) {
  const Differences differences(count, a, b);
  const double total = a + b;
  const double eigenvalue = count * (total + (count - 1));
  std::vector<double> zeros;
  // Newton's step from y = 0 does not pass the first zero.
  double y = a / eigenvalue;
  while (static_cast<int>(zeros.size()) < wanted) {
    // Laguerre's method on what is left when the zeros found are divided out: all zeros are real, so that steps from the
    // left of them end at the first one. Convergence is cubic.
    for (int step = 0; step < 60; ++step) {
      const auto [p, slope] = differences.at(y);
      if (p == 0) break;
      const double newton = slope / p;
      const double second = -((a - total * y) * newton + eigenvalue) / (y * (1 - y));
      double g = newton;
      double h = newton * newton - second;
      for (const double zero : zeros) {
        const double inverse = 1 / (y - zero);
        g -= inverse;
        h -= inverse * inverse;
      }
      const double left = count - static_cast<double>(zeros.size());
      const double root = std::sqrt(std::max(0.0, (left - 1) * (left * h - g * g)));
      const double change = -left / (g < 0 ? g - root : g + root);
      if (!std::isfinite(change)) break;
      y += change;
      if (std::abs(change) <= 1e-5 * (zeros.empty() ? y : std::min(y, y - zeros.back()))) break;
    }
    const double gap = zeros.empty() ? y : y - zeros.back();
    zeros.push_back(y);
    // Gaps grow towards the middle. The first zero may be tiny by itself: the next one is beyond the first zero of P', which
    // is a Jacobi polynomial again.
    y += gap / 1024;
    if (zeros.size() == 1 && count > 1) y = std::max(y, (a + 1) / ((count - 1) * (total + count)));
  }
  return zeros;
}

}  // namespace steadyslide::enclosure
