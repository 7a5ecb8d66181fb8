#include "enclosure/number/chebyshev_series.hpp"

namespace steadyslide::enclosure {
namespace {

Ball error_of(const ChebyshevNodes& nodes, const std::vector<Ball>& values, const Ball& bound, const Ball& rho) {
  constexpr Bits few = 64;
  const int n = nodes.count();
  Ball widest(0, few);
  for (const Ball& value : values) widest = max(widest, value.radius().at(few));
  const Ball lebesgue = Ball(1) + Ball(2) * log(Ball(n, few)) / Ball::pi(few);
  return (Ball(4) * bound * power(rho, 1 - n) / (rho - Ball(1)) + lebesgue * widest).upper();
}

std::vector<Ball> midpoints(std::vector<Ball> values) {
  for (Ball& value : values) value = value.midpoint();
  return values;
}

}  // namespace

ChebyshevNodes::ChebyshevNodes(int count, Bits bits) : count_(count), bits_(bits) {
  for (int k = 0; k < 4 * count; ++k) cosines_.push_back(cos(Ball::pi(bits) * Ball(k) / Ball(2 * count)));
}

ChebyshevSeries::ChebyshevSeries(const ChebyshevNodes& nodes, const std::vector<Ball>& values, const Ball& bound,
                                 const Ball& rho)
    : ChebyshevSeries(nodes, midpoints(values), error_of(nodes, values, bound, rho)) {}

ChebyshevSeries::ChebyshevSeries(const ChebyshevNodes& nodes, const std::vector<Ball>& values, Ball error)
    : nodes_(&nodes), error_(std::move(error)) {
  const int n = nodes.count();
  for (int j = 0; j < n; ++j) {
    Ball sum(0, nodes.bits());
    for (int i = 0; i < n; ++i) {
      arb_addmul(sum.get(), values[static_cast<std::size_t>(i)].get(), nodes.polynomial(j, i).get(), nodes.bits());
    }
    sum *= Ball(j == 0 ? 1 : 2, nodes.bits()) / Ball(n);
    // Rounding is added to the error, because in a recurrence of balls it would grow with each restriction.
    error_ += sum.radius().at(64);
    coefficients_.push_back(sum.midpoint());
  }
}

Ball ChebyshevSeries::range() const {
  Ball radius = error_;
  for (std::size_t j = 1; j < coefficients_.size(); ++j) radius += abs(coefficients_[j].at(64));
  return Ball::plus_or_minus(coefficients_[0], radius);
}

Ball ChebyshevSeries::at(const Ball& t) const { return Ball::plus_or_minus(polynomial_at(t), error_); }

/// Clenshaw's recurrence.
Ball ChebyshevSeries::polynomial_at(const Ball& t) const {
  const Bits bits = nodes_->bits();
  const Ball twice = t + t;
  Ball next(0, bits), after(0, bits);
  for (std::size_t j = coefficients_.size(); j-- > 1;) {
    Ball now = coefficients_[j] - after;
    arb_addmul(now.get(), twice.get(), next.get(), bits);
    after = std::move(next);
    next = std::move(now);
  }
  return coefficients_[0] + t * next - after;
}

ChebyshevSeries ChebyshevSeries::restricted(const Ball& from, const Ball& to) const {
  const Ball middle = (from + to) / Ball(2), half = (to - from) / Ball(2);
  std::vector<Ball> values;
  for (int i = 0; i < nodes_->count(); ++i) values.push_back(polynomial_at(middle + half * (*nodes_)[i]));
  return {*nodes_, values, error_};
}

}  // namespace steadyslide::enclosure
