#include "checker/traction_representation.hpp"

#include <algorithm>
#include <cmath>

#include "checker/failure.hpp"

namespace steadyslide::checker {

namespace {

/// The remainder of sums by moments is 2^-8 of the requested error.
constexpr slong far_guard = 8;

/// Converts p to Taylor coefficients about the centre.
void shift(std::vector<Ball>& p, const Ball& centre) {
  for (std::size_t i = 0; i < p.size(); ++i) {
    for (std::size_t k = p.size() - 1; k > i; --k) p[k - 1] += centre * p[k];
  }
}

}  // namespace

Ball bound_near(const std::vector<Ball>& p, const Ball& centre, const Ball& radius) {
  std::vector<Ball> shifted = p;
  shift(shifted, centre);
  Ball sum;
  for (std::size_t k = shifted.size(); k-- > 0;) sum = sum * radius.size() + shifted[k].size();
  return sum.upper();
}

Trapezoid PowerPanel::rule(slong bits, const Ball& left_reach, const Ball& right_reach) const {
  Trapezoid::Panel panel;
  panel.length = length.is_zero() ? contact.distance(i, j) - start - end : length;
  panel.degree = degree;
  const auto add = [&](const Ball& power, const std::vector<std::size_t>& points) {
    panel.factors.push_back({power, {}, {}});
    for (const std::size_t m : points) {
      if (m <= i) panel.factors.back().left.push_back(contact.distance(m, i) + start);
      if (m >= j) panel.factors.back().right.push_back(contact.distance(j, m) + end);
    }
  };
  for (const std::vector<std::size_t>& group : contact.alike()) {
    const Ball& p = contact.power_at(group.front());
    add(exponent > 0 ? p : -p, group);
  }
  if (extra != none) add(Ball(-1), {extra});
  const auto beside = [&](bool there, std::size_t segment) {
    return there ? contact.length(segment) * Ball(0.5) : panel.length;
  };
  panel.left_reach = left_reach.is_zero() ? beside(i > 0, i - 1) : left_reach;
  panel.right_reach = right_reach.is_zero() ? beside(j < contact.segments(), j) : right_reach;
  return Trapezoid(std::move(panel), bits, contact.precision());
}

TractionRepresentation::TractionRepresentation(const Contact& contact, const Unknowns& unknowns,
                                               const Problem::Loads& loads, slong bits)
    : contact_(&contact), q_(unknowns.q), bits_(bits), integrals_(contact.segments()) {
  const slong precision = contact.precision();
  const Rational& unit = contact.problem().unit;
  load_ = Ball(loads.from / unit, precision);
  if (loads.from != loads.to) load_ = hull(load_, Ball(loads.to / unit, precision));
  if (contact.degree_at_infinity() < 0) q_.push_back(load_);
  const Ball pi = Ball::pi(precision);
  for (const Polynomial& g : contact.problem().slopes) {
    std::vector<Ball>& slope = slopes_.emplace_back(balls(g, precision));
    if (slope.empty()) slope.emplace_back();
    if (!unknowns.tilt.empty()) slope[0] += unknowns.tilt[0];
    std::vector<Ball>& p = polynomials_.emplace_back();
    const int top = static_cast<int>(slope.size()) - 1 - contact.degree_at_infinity();
    for (int k = 0; k <= top; ++k) p.push_back(contact.coefficient(slope, k));
    p.resize(std::max(p.size(), q_.size()));
    for (std::size_t k = 0; k < q_.size(); ++k) p[k] -= q_[k] / pi;
  }
  std::vector<bool> asked(slopes_.size(), false);
  for (std::size_t i = 0; i < contact.segments(); ++i) {
    if (contact.in_contact(i)) asked[contact.slope_of(i)] = true;
  }
  if (std::ranges::count(asked, true) < 2) return;
  for (std::size_t i = 0; i < contact.segments(); ++i) {
    if (contact.in_contact(i)) add_integrals(i, asked);
  }
}

Ball TractionRepresentation::reach(std::size_t point) const {
  const Ball left = contact_->length(point - 1).lower();
  const Ball right = contact_->length(point).lower();
  return ((left - right).is_positive() ? right : left) * Ball(std::ldexp(0.5, -static_cast<int>(bits_)));
}

void TractionRepresentation::add_integrals(std::size_t i, const std::vector<bool>& asked) {
  const std::vector<Polynomial>& g = contact_->problem().slopes;
  std::size_t degree = 0;
  for (std::size_t k = 0; k < g.size(); ++k) degree = std::max(degree, asked[k] ? g[k].size() : 0);
  const auto reach_at = [&](std::size_t j) { return contact_->changes_slope(j) ? reach(j) : Ball(); };
  Integral integral{PowerPanel{*contact_, i, i + 1, {}, {}, -1, none, degree}.rule(bits_, reach_at(i), reach_at(i + 1)),
                    {},
                    {},
                    {},
                    {}};
  const slong precision = contact_->precision();
  const std::size_t own = contact_->slope_of(i);
  const Ball sign(contact_->sign(i));
  const Ball factor = contact_->cosine(i) / Ball::pi(precision);
  // |x - middle| = (L/2) |tanh(tau/2)| <= (L/2) sec(d/2).
  const Ball half = contact_->length(i) * Ball(0.5);
  const Ball middle = contact_->xi(i) + half;
  const std::vector<Trapezoid::Node>& nodes = integral.rule.nodes();
  std::vector<std::vector<Ball>> differences;  // differences of slopes, in (x - middle)/half
  std::size_t longest = 0;
  for (std::size_t k = 0; k < slopes_.size(); ++k) {
    std::vector<Ball>& density = integral.densities.emplace_back();
    std::vector<Ball>& difference = differences.emplace_back();
    integral.bounds.emplace_back();
    if (!asked[k] || k == own) continue;
    difference = balls(g[own] - g[k], precision);
    integral.bounds.back() = factor * bound_near(difference, middle, half * integral.rule.secant());
    for (const Trapezoid::Node& node : nodes) {
      density.push_back(sign * factor * node.weight * horner(difference, contact_->xi(i) + node.u));
    }
    shift(difference, middle);
    Ball scale = sign * factor;
    for (Ball& coefficient : difference) {
      coefficient *= scale;
      scale *= half;
    }
    longest = std::max(longest, difference.size());
  }
  Bound weights;
  mag_add(weights.get(), nodes.front().behind.get(), nodes.at(integral.rule.nodes_to_right()).behind.get());
  integral.weights = Ball(weights);
  // The moments of the weights are the same for all differences.
  integral.moments.resize(g.size());
  const auto count = static_cast<std::size_t>(2 * (bits_ + far_guard));
  std::vector<Ball> of_weights(count + longest, Ball().rounded(precision));
  Ball term;
  for (const Trapezoid::Node& node : nodes) {
    const Ball s = (node.u - half) / half;
    term = node.weight;
    for (Ball& moment : of_weights) {
      arb_add(moment.get(), moment.get(), term.get(), precision);
      arb_mul(term.get(), term.get(), s.get(), precision);
    }
  }
  for (std::size_t k = 0; k < g.size(); ++k) {
    for (std::size_t p = 0; p < count && !differences[k].empty(); ++p) {
      Ball sum;
      for (std::size_t j = 0; j < differences[k].size(); ++j) sum += differences[k][j] * of_weights[p + j];
      integral.moments[k].push_back(sum);
    }
  }
  integrals_[i] = std::move(integral);
}

bool TractionRepresentation::add_far_cauchy(std::size_t i, std::size_t k, const Ball& near, bool on_right, slong bits,
                                            Value& result) const {
  const Integral& integral = *integrals_[i];
  const std::vector<Ball>& moments = integral.moments[k];
  const Ball half = contact_->length(i) * Ball(0.5);
  const Ball distance = near + half;
  const Ball z = half / distance;
  // For a wide interval of places, the nodes' own distances give better bounds.
  const bool thin = (distance - distance.radius() * Ball(0x1p20)).is_positive();
  if (!thin || !(Ball(0.7) - z).is_positive()) return false;
  const auto count = static_cast<std::size_t>(
      std::ceil(static_cast<double>(bits + far_guard) / -std::log2(z.upper().approximately())));
  if (count > moments.size()) return false;
  const slong precision = std::min(contact_->precision(), bits + 48);
  const Ball signed_z = on_right ? -z : z;
  Ball sum;
  for (std::size_t p = count; p-- > 0;) {
    arb_mul(sum.get(), sum.get(), signed_z.get(), precision);
    arb_add(sum.get(), sum.get(), moments[p].get(), precision);
  }
  const Ball& M = integral.bounds[k];
  const Ball absolute = integral.weights / near.lower();
  Ball rest = z.rounded(64);  // bound of the omitted moments
  arb_pow_ui(rest.get(), rest.get(), count, 64);
  rest *= M * absolute;
  sum = sum / distance;
  result.value += (on_right ? -sum : sum).widened(rest);
  result.error += integral.rule.error(1, M, absolute);
  result.integrals += M * Trapezoid::integral_bound(absolute);
  return true;
}

TractionRepresentation::Value TractionRepresentation::regular(std::size_t k, const SurfacePoint& at,
                                                              std::size_t without) const {
  const Ball x = contact_->xi(at);
  const std::vector<Ball>& p = polynomials_[k];
  Value result{horner(p, x), {}, {}, {}};
  for (std::size_t l = p.size(); l-- > 1;) result.slope = result.slope * x + Ball(static_cast<int>(l)) * p[l];
  for (std::size_t i = 0; i < integrals_.size(); ++i) {
    if (without != i) add_cauchy(i, k, at, true, 2 * Ball::exact, result);
  }
  result.value = result.value.widened(result.error);
  return result;
}

TractionRepresentation::Value TractionRepresentation::regular_to(slong bits, std::size_t k,
                                                                 const SurfacePoint& at) const {
  Value result = sums_to(bits, k, at);
  result.value = result.value.widened(result.error);
  return result;
}

TractionRepresentation::Value TractionRepresentation::sums_to(slong bits, std::size_t k, const SurfacePoint& at) const {
  Value result{horner(polynomials_[k], contact_->xi(at)), {}, {}, {}};
  for (std::size_t i = 0; i < integrals_.size(); ++i) add_cauchy(i, k, at, false, bits, result);
  return result;
}

void TractionRepresentation::add_cauchy(std::size_t i, std::size_t k, const SurfacePoint& at, bool with_slope,
                                        slong bits, Value& result) const {
  if (!integrals_[i] || contact_->slope_of(i) == k) return;
  const Integral& integral = *integrals_[i];
  const std::vector<Trapezoid::Node>& nodes = integral.rule.nodes();
  const std::vector<Ball>& density = integral.densities[k];
  const auto [near, on_right] = this->near(i, at);
  if (!with_slope && add_far_cauchy(i, k, near, on_right, bits, result)) return;
  const slong precision = std::min(contact_->precision(), bits + 48);
  const Ball& length = integral.rule.panel().length;
  Bound negligible;
  if (near.is_positive()) {
    const slong closeness = std::min<slong>(near.lower().exponent() - length.exponent(), 0);
    mag_mul_2exp_si(negligible.get(), nodes.front().behind.get(), closeness - bits - 4);
  }
  Ball sum, slope, distance, inverse;
  // Upper bounds of 1/|x' - x|, of its sum, of the sum of its squares, and of the omitted weights.
  Bound pole, poles, squares, left_out;
  for (std::size_t l = 0; l < nodes.size(); ++l) {
    const Trapezoid::Node& node = nodes[l];
    if (mag_cmp(node.behind.get(), negligible.get()) < 0) {
      mag_add(left_out.get(), left_out.get(), node.behind.get());
      if (l >= integral.rule.nodes_to_right()) break;
      l = integral.rule.nodes_to_right() - 1;
      continue;
    }
    arb_add(distance.get(), near.get(), (on_right ? node.u : node.v).get(), precision);
    arb_inv(inverse.get(), distance.get(), precision);
    arb_addmul(sum.get(), inverse.get(), density[l].get(), precision);
    arb_get_mag(pole.get(), inverse.get());
    mag_addmul(poles.get(), node.above.get(), pole.get());
    if (!with_slope) continue;
    arb_mul(inverse.get(), inverse.get(), inverse.get(), precision);
    arb_addmul(slope.get(), inverse.get(), density[l].get(), precision);
    arb_get_mag(pole.get(), inverse.get());
    mag_addmul(squares.get(), node.above.get(), pole.get());
  }
  const Ball& M = integral.bounds[k];
  const Ball rest = Ball(left_out) / near.lower();
  const Ball absolute = Ball(poles) + rest;
  result.value -= (on_right ? sum : -sum).widened(M * rest);
  result.error += integral.rule.error(1, M, absolute);
  result.integrals += M * Trapezoid::integral_bound(absolute);
  if (!with_slope) return;
  const Ball rest_of_squares = rest / near.lower();
  result.slope -= slope.widened(integral.rule.error(2, M, Ball(squares) + rest_of_squares) + M * rest_of_squares);
}

TractionRepresentation::Near TractionRepresentation::near(std::size_t i, const SurfacePoint& at) const {
  if (at.right <= i) return {contact_->distance(at.right, i) + at.from_right, true};
  if (i + 1 > at.left) throw Unproved("B is needed inside a piece of contact with another polynomial");
  return {contact_->distance(i + 1, at.left) + at.from_left, false};
}

std::vector<TractionRepresentation::Piece> TractionRepresentation::other_pieces(std::size_t k,
                                                                                const SurfacePoint& at) const {
  std::vector<Piece> result;
  for (std::size_t i = 0; i < integrals_.size(); ++i) {
    if (!integrals_[i] || contact_->slope_of(i) == k) continue;
    const Integral& integral = *integrals_[i];
    result.push_back({near(i, at).near.lower(), integral.bounds[k] * Trapezoid::integral_bound(integral.weights),
                      integral.rule.relative_error(1)});
  }
  return result;
}

Ball TractionRepresentation::at_end(std::size_t j) const {
  const bool begins = contact_->layout().points[j].contact == LayoutPoint::Contact::begins;
  const std::size_t segment = begins ? j : j - 1;
  const Ball length = contact_->length(segment);
  const SurfacePoint at = begins ? SurfacePoint{j, j + 1, Ball(), length} : SurfacePoint{j - 1, j, length, Ball()};
  return regular_to(bits_ + 8, contact_->slope_of(segment), at).value;
}

Ball TractionRepresentation::polynomial_bound(std::size_t k, const Ball& centre, const Ball& radius) const {
  return bound_near(polynomials_[k], centre, radius);
}

std::vector<Ball> TractionRepresentation::moments(std::size_t count) const {
  const std::size_t k = contact_->slope_of(contact_->layout().all(LayoutPoint::Contact::begins).front());
  std::vector<Ball> result;
  for (std::size_t j = 0; j < count; ++j) {
    result.push_back(contact_->coefficient(slopes_[k], -static_cast<int>(j) - 1));
  }
  for (std::size_t i = 0; i < integrals_.size(); ++i) {
    if (count == 0 || !integrals_[i] || contact_->slope_of(i) == k) continue;
    const Integral& integral = *integrals_[i];
    std::vector<Ball> totals(count);
    Ball weights;
    for (std::size_t l = 0; l < integral.rule.nodes().size(); ++l) {
      const Ball x = contact_->xi(i) + integral.rule.nodes()[l].u;
      Ball term = integral.densities[k][l];
      for (Ball& total : totals) {
        total += term;
        term *= x;
      }
      weights += integral.rule.nodes()[l].weight;
    }
    const Ball half = contact_->length(i) * Ball(0.5);
    const Ball largest = (contact_->xi(i) + half).size() + half * integral.rule.secant();
    Ball M = integral.bounds[k];
    for (std::size_t j = 0; j < count; ++j) {
      Ball& sum = result[j];
      const Ball& total = totals[j];
      sum -= total.widened(integral.rule.error(0, M, weights));
      M *= largest;
    }
  }
  return result;
}

std::vector<Ball> TractionRepresentation::difference(std::size_t l, std::size_t k, std::size_t anchor) const {
  const ReducedProblem& problem = contact_->problem();
  return balls(composed(problem.slopes[l] - problem.slopes[k], 1, problem.anchors[anchor]), contact_->precision());
}

}  // namespace steadyslide::checker
