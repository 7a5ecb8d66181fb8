#include "proofs_checks/instruments/operators/displacement_operator.hpp"

namespace steadyslide::proofs_checks {
namespace {

using numeric::Power;

/// Returns a - b, computed from the distances to the nearer end.
template <Real R>
R apart(const Node<R>& a, const Node<R>& b) {
  return a.from_left < a.from_right ? R(a.from_left - b.from_left) : R(b.from_right - a.from_right);
}

/// Returns the nodes of a rule on [-1, 1].
template <Real R>
std::vector<Node<R>> nodes_of(const numeric::UnitRule<R>& rule) {
  std::vector<Node<R>> nodes;
  for (std::size_t i = 0; i < rule.size(); ++i) {
    const R left = 2 * rule.from_left[i];
    const R right = 2 * rule.from_right[i];
    nodes.push_back({left < right ? R(left - 1) : R(1 - right), left, right});
  }
  return nodes;
}

}  // namespace

template <class R>
void DisplacementOperator<R>::place_nodes(const Rational& s, int n) {
  const Exponent angle = Exponent::angle(s);
  const auto rule = numeric::jacobi_rule<R>(Power<R>::of(-(half + angle)), Power<R>::of(-(half - angle)), n);
  nodes_ = nodes_of(rule);
  // The powers of t_0 have the sum -1. Therefore the integral over an interval of twice the length is the same.
  const R amplitude = cos_pi_alpha<R>(s) / numeric::pi<R>();
  for (const R& weight : rule.weights) tau_.push_back(amplitude * weight);
}

template <class R>
std::vector<R> DisplacementOperator<R>::barycentric_weights() const {
  std::vector<R> weights(size(), R(1));
  for (std::size_t i = 0; i < size(); ++i) {
    for (std::size_t j = 0; j < size(); ++j) {
      // Scaled to an interval of length 4, on which the products neither grow nor fall.
      if (j != i) weights[i] /= 2 * apart(nodes_[i], nodes_[j]);
    }
  }
  return weights;
}

template <class R>
std::vector<R> DisplacementOperator<R>::derivatives(const std::vector<R>& weights) const {
  std::vector<R> slope(size() * size(), R(0));
  for (std::size_t i = 0; i < size(); ++i) {
    R sum = 0;
    for (std::size_t j = 0; j < size(); ++j) {
      if (j == i) continue;
      slope[i * size() + j] = weights[j] / weights[i] / apart(nodes_[i], nodes_[j]);
      sum += slope[i * size() + j];
    }
    slope[i * size() + i] = -sum;
  }
  return slope;
}

template <class R>
DisplacementOperator<R>::DisplacementOperator(const Rational& s, int n, const InverseVariant& variant) {
  using std::pow;
  place_nodes(s, n);
  const std::size_t count = size();
  const Rational told = variant.friction * s;
  const Exponent angle = Exponent::angle(told);
  const auto left = Power<R>::of(variant.printed ? half : half + angle);
  const auto right = Power<R>::of(half - angle);
  const R cosine = cos_pi_alpha<R>(s);
  const R factor = variant.amplitude ? cosine : R(cosine * cosine);

  const auto w_rule = numeric::jacobi_rule<R>(left, right, std::max(n - 1, 1));
  const std::vector<Node<R>> y = nodes_of(w_rule);
  const R stretch = pow(R(2), R(left.value + right.value + 1));
  const numeric::Panel<R> whole{R(-1), R(1), R(2)};
  const trapezoidal::Grid<R> w({{whole, left, right, [](const Node<R>&) { return R(1); }}});

  const std::vector<R> barycentric = barycentric_weights();
  const std::vector<R> slope = derivatives(barycentric);
  // The values of u' at y_k, from those at the nodes.
  std::vector<R> slope_at_y(y.size() * count, R(0));
  for (std::size_t k = 0; k < y.size(); ++k) {
    R sum = 0;
    std::vector<R> share(count);
    for (std::size_t m = 0; m < count; ++m) {
      share[m] = barycentric[m] / apart(y[k], nodes_[m]);
      sum += share[m];
    }
    for (std::size_t m = 0; m < count; ++m) {
      const R part = share[m] / sum;
      for (std::size_t j = 0; j < count; ++j) slope_at_y[k * count + j] += part * slope[m * count + j];
    }
  }

  force_.assign(count * count, R(0));
  for (std::size_t i = 0; i < count; ++i) {
    const R kernel = w.hilbert({0, nodes_[i]});
    const R at_node = pow(nodes_[i].from_left, left.value) * pow(nodes_[i].from_right, right.value);
    for (std::size_t j = 0; j < count; ++j) {
      const R& here = slope[i * count + j];
      R sum = 0;
      for (std::size_t k = 0; k < y.size(); ++k) {
        sum += w_rule.weights[k] * (slope_at_y[k * count + j] - here) / apart(y[k], nodes_[i]);
      }
      const R integral = stretch * sum / numeric::pi<R>() + here * kernel;
      force_[i * count + j] = factor * (to_real<R>(told) * here + variant.integral * integral / at_node);
    }
    // L(u)/t_0 times the weight. This uses the true W, also for a wrong variant of (10).
    const Exponent true_angle = Exponent::angle(s);
    const R scale = tau_[i] * numeric::pi<R>() / cosine * pow(nodes_[i].from_left, to_real<R>(half + true_angle)) *
                    pow(nodes_[i].from_right, to_real<R>(half - true_angle));
    for (std::size_t j = 0; j < count; ++j) force_[i * count + j] *= scale;
  }
}

template <class R>
std::vector<R> DisplacementOperator<R>::forces(const std::vector<R>& u) const {
  std::vector<R> result(size(), R(0));
  for (std::size_t i = 0; i < size(); ++i) {
    for (std::size_t j = 0; j < size(); ++j) result[i] += force(i, j) * u[j];
  }
  return result;
}

template <class R>
R DisplacementOperator<R>::form(const std::vector<R>& v, const std::vector<R>& u) const {
  const std::vector<R> all = forces(u);
  R sum = 0;
  for (std::size_t i = 0; i < size(); ++i) sum += v[i] * all[i];
  return sum;
}

template class DisplacementOperator<double>;
template class DisplacementOperator<Real50>;
template class DisplacementOperator<Real100>;

}  // namespace steadyslide::proofs_checks
