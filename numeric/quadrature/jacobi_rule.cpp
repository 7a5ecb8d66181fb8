#include "numeric/quadrature/jacobi_rule.hpp"

#include <Eigen/Eigenvalues>
#include <boost/math/special_functions/beta.hpp>
#include <numeric>
#include <stdexcept>

namespace steadyslide::numeric {
namespace {

template <Real R>
struct Root {
  R distance;  ///< from the end at which the polynomial is normalised
  R slope;
};

/// The orthogonal polynomials P_k of y^(A-1) (1-y)^(B-1), normalised by P_k(0) = A. In terms of their differences
///
///   P_{k+1} - P_k = h_k (P_k - P_{k-1}) - y g_k P_k,   g, h > 0,
///
/// nothing cancels next to y = 0. So zeros have full relative precision there, also those at y ~ A for tiny A.
template <Real R>
class Polynomials {
 public:
  Polynomials(const R& a, const R& b, int n) : a_(a), total_(a + b), eigenvalue_(n * (total_ + (n - 1))) {
    g_.reserve(static_cast<std::size_t>(n));
    h_.reserve(static_cast<std::size_t>(n));
    g_.push_back(total_ / a);
    h_.push_back(R(0));
    for (int k = 1; k < n; ++k) {
      const R denominator = (a + k) * (total_ + (k - 1));
      g_.push_back((total_ + (2 * k - 1)) * (total_ + 2 * k) / denominator);
      h_.push_back(k * ((b + (k - 1)) / (total_ + (2 * k - 2))) * (total_ + 2 * k) / denominator);
    }
  }

  /// Returns all n zeros in increasing order, with an error of about 1e-15.
  Eigen::VectorXd rough_zeros() const {
    const auto n = static_cast<Eigen::Index>(g_.size());
    Eigen::VectorXd diagonal(n);
    Eigen::VectorXd beside(n - 1);
    for (std::size_t k = 0; k < g_.size(); ++k) {
      const auto row = static_cast<Eigen::Index>(k);
      diagonal[row] = static_cast<double>((1 + h_[k]) / g_[k]);
      if (k > 0) beside[row - 1] = std::sqrt(static_cast<double>(h_[k] / (g_[k] * g_[k - 1])));
    }
    if (n == 1) return diagonal;
    Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver;
    solver.computeFromTridiagonal(diagonal, beside, Eigen::EigenvaluesOnly);
    if (solver.info() != Eigen::Success) throw std::runtime_error("Gauss-Jacobi rule: no eigenvalues");
    return solver.eigenvalues();
  }

  /// Returns Newton's step from y = 0. It is not beyond the first zero, and close to it if A is small.
  R first_zero_bound() const { return a_ / eigenvalue_; }

  /// Halley's method. The differential equation y (1-y) P'' + (A - (A+B) y) P' + N P = 0 gives the higher derivatives.
  /// The last step also updates the slope.
  Root<R> zero_near(R y) const {
    const auto n = static_cast<double>(g_.size());
    for (int step = 0; step < 20; ++step) {
      const auto [p, p1] = value_and_slope(y);
      const R yz = y * (1 - y);
      const R drift = a_ - total_ * y;
      const R p2 = -(drift * p1 + eigenvalue_ * p) / yz;
      const R p3 = -((1 - 2 * y + drift) * p2 + (eigenvalue_ - total_) * p1) / yz;
      const R newton = p / p1;
      const R change = -newton / (1 - newton * p2 / (2 * p1));
      // Relative to y and to the distance between zeros.
      const double relative =
          static_cast<double>(abs(change) / y) * (1 + n * std::sqrt(static_cast<double>(y / (1 - y))));
      y += change;
      if (y <= 0 || y >= 1) break;
      if (relative * relative * relative < static_cast<double>(epsilon<R>()) / 16)
        return {y, p1 + change * (p2 + change / 2 * p3)};
    }
    throw std::runtime_error("Gauss-Jacobi rule: a node was not found");
  }

 private:
  std::pair<R, R> value_and_slope(const R& y) const {
    R p = a_;
    R p1 = 0;
    R change = 0;
    R change1 = 0;
    for (std::size_t k = 0; k < g_.size(); ++k) {
      change1 = h_[k] * change1 - g_[k] * (p + y * p1);
      change = h_[k] * change - y * g_[k] * p;
      p += change;
      p1 += change1;
    }
    return {p, p1};
  }

  R a_;
  R total_;
  R eigenvalue_;
  std::vector<R> g_;
  std::vector<R> h_;
};

/// Returns Gamma(A) Gamma(B)/Gamma(A + B), exact if it is a reciprocal.
template <Real R>
R beta(const R& a, const R& b) {
  if (b == 1) return 1 / a;
  if (a == 1) return 1 / b;
  if constexpr (std::same_as<R, double>) {
    return boost::math::beta(a, b);
  } else {
    R value;
    eval_beta(value.backend(), a.backend(), b.backend());  // number/elementary.hpp
    return value;
  }
}

}  // namespace

template <Real R>
UnitRule<R> jacobi_rule(const Power<R>& left, const Power<R>& right, int n) {
  const R& a = left.plus_one;
  const R& b = right.plus_one;
  if (n < 1 || !(a > 0 && b > 0)) throw std::invalid_argument("Gauss-Jacobi rule: n >= 1, powers > -1");
  const Polynomials<R> from_left(a, b, n);
  const Polynomials<R> from_right(b, a, n);
  const Eigen::VectorXd rough = from_left.rough_zeros();
  // The ratio of P normalised at one end to P normalised at the other.
  R ratio = 1;
  for (int k = 1; k < n; ++k) ratio *= (a + k) / (b + k);

  UnitRule<R> rule;
  for (auto* part : {&rule.from_left, &rule.from_right, &rule.weights}) part->reserve(static_cast<std::size_t>(n));
  for (int i = 0; i < n; ++i) {
    const bool left_is_near = rough[i] <= 0.5;
    const Polynomials<R>& p = left_is_near ? from_left : from_right;
    const double start = left_is_near ? rough[i] : 1 - rough[i];
    // The eigenvalues have no correct digits there.
    const bool outermost = i == (left_is_near ? 0 : n - 1) && start < 1e-9;
    const Root<R> root = p.zero_near(outermost ? p.first_zero_bound() : R(start));
    const R other = 1 - root.distance;
    rule.from_left.push_back(left_is_near ? root.distance : other);
    rule.from_right.push_back(left_is_near ? other : root.distance);
    const R slope = left_is_near ? root.slope : root.slope / ratio;
    rule.weights.push_back(1 / (root.distance * other * slope * slope));
    if (i > 0 && !(rule.from_left[static_cast<std::size_t>(i) - 1] < rule.from_left.back() ||
                   rule.from_right[static_cast<std::size_t>(i) - 1] > rule.from_right.back()))
      throw std::runtime_error("Gauss-Jacobi rule: two starts led to one node");
  }
  const R factor = beta(a, b) / std::accumulate(rule.weights.begin(), rule.weights.end(), R(0));
  for (R& weight : rule.weights) weight *= factor;
  return rule;
}

template <Real R>
const UnitRule<R>& JacobiRules<R>::get(const Power<R>& left, const Power<R>& right, int n) {
  const Key key(left.plus_one, right.plus_one, n);
  auto place = rules_.lower_bound(key);
  if (place == rules_.end() || place->first != key)
    place = rules_.emplace_hint(place, key, jacobi_rule(left, right, n));
  return place->second;
}

#define STEADYSLIDE_INSTANTIATE(R)                                                      \
  template UnitRule<R> jacobi_rule(const Power<R>& left, const Power<R>& right, int n); \
  template class JacobiRules<R>;
STEADYSLIDE_FOR_EACH_REAL(STEADYSLIDE_INSTANTIATE)
#undef STEADYSLIDE_INSTANTIATE

}  // namespace steadyslide::numeric
