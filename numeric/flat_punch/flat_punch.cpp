#include "numeric/flat_punch/flat_punch.hpp"

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <stdexcept>

#include "model/exponent.hpp"

namespace steadyslide::numeric {
namespace {

/// The layout outer | inner | outer. Its parameter is tau, the logarithm of the ratio of the lengths of the outer
/// strips.
template <Real R>
struct Sandwich {
  std::vector<Rational> s;
  R inner;
  R room;  ///< total length of both outer strips

  R left(const R& tau) const { return room / (1 + exp(-tau)); }
  R right(const R& tau) const { return left(-tau); }
  FrictionLayout<R> at(const R& tau) const { return {{left(tau), inner, right(tau)}, s}; }

  /// Returns w at the first jump minus w at the second one, which decreases as tau grows.
  Estimate<R> difference(const R& tau) const {
    const EffectiveFriction<R> friction(at(tau));
    return friction.derivative(left(tau), inner + right(tau)) - friction.derivative(left(tau) + inner, right(tau));
  }
};

/// The zero of the difference, and its slope there.
struct Start {
  double zero;
  double slope;
};

Start zero_in_double(const Sandwich<double>& sandwich) {
  const auto difference = [&](double tau) { return sandwich.difference(tau).value; };
  double low = -1;
  double high = 1;
  // The search ends because w has infinite limits. Close to 1/2 - alpha = 0 these limits are logarithmic.
  constexpr double furthest = 600;
  while (low >= -furthest && !(difference(low) > 0)) low *= 2;
  while (high <= furthest && !(difference(high) < 0)) high *= 2;
  if (low < -furthest || high > furthest) throw std::range_error("a strip is shorter than 1e-200 of the contact");
  boost::uintmax_t steps = 200;
  // The last digits are rounding errors of w.
  const boost::math::tools::eps_tolerance<double> tolerance(std::numeric_limits<double>::digits - 8);
  const auto [left, right] = boost::math::tools::toms748_solve(difference, low, high, tolerance, steps);
  const double zero = (left + right) / 2;
  constexpr double step = 1e-4;
  return {zero, (difference(zero + step) - difference(zero - step)) / (2 * step)};
}

/// Secant steps from the result in double. The numbers of correct digits of two steps add up.
template <Real R>
Estimate<R> zero_of(const Sandwich<R>& sandwich, const Start& start) {
  R slope = start.slope;
  R tau = start.zero;
  Estimate<R> difference = sandwich.difference(tau);
  const auto error = [&] { return R(2 * difference.error / abs(slope) + 16 * epsilon<R>() * (1 + abs(tau))); };
  constexpr int most_steps = 12;
  for (int i = 0; i < most_steps && abs(difference.value) > difference.error; ++i) {
    const R step = -difference.value / slope;
    const Estimate<R> next = sandwich.difference(tau + step);
    if (abs(step) > error()) slope = (next.value - difference.value) / step;
    tau += step;
    difference = next;
  }
  return {tau, error() + abs(difference.value / slope)};
}

template <Real R>
Sandwich<R> sandwich_of(const Rational& outer, const Rational& inner, const Rational& inner_share) {
  return {{outer, inner, outer}, to_real<R>(inner_share), to_real<R>(1 - inner_share)};
}

}  // namespace

template <Real R>
FrictionLayout<R>::FrictionLayout(const std::vector<R>& lengths, const std::vector<Rational>& s) {
  if (lengths.empty() || lengths.size() != s.size()) throw std::invalid_argument("a strip has a length and an s");
  for (std::size_t k = 0; k < s.size(); ++k) {
    if (!(lengths[k] > 0)) throw std::invalid_argument("a strip has a length > 0");
    const Exponent angle = Exponent::angle(s[k]);
    strips_.push_back(
        {lengths[k], length_, R(0), to_real<R>(angle), to_real<R>(half - angle), to_real<R>(half + angle)});
    length_ += lengths[k];
  }
  // The distance from the right is also a sum, because a difference would lose digits of a short last strip.
  R from_right = 0;
  for (auto strip = strips_.rbegin(); strip != strips_.rend(); ++strip) {
    strip->from_right = from_right;
    from_right += strip->length;
  }
}

template <Real R>
FrictionLayout<R> FrictionLayout<R>::of(const ContactProblem& problem) {
  std::vector<Rational> ends{problem.indenter().left()};
  ends.insert(ends.end(), problem.friction().jumps().begin(), problem.friction().jumps().end());
  ends.push_back(problem.indenter().right());
  std::vector<R> lengths;
  std::vector<Rational> s;
  for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
    lengths.push_back(to_real<R>(ends[k + 1] - ends[k]));
    s.push_back(problem.coupled_friction(k));
  }
  return {lengths, s};
}

template <Real R>
FrictionLayout<R> FrictionLayout<R>::periodic(const std::vector<Rational>& shares, const std::vector<Rational>& s,
                                              int periods) {
  std::vector<R> lengths;
  std::vector<Rational> all;
  for (int k = 0; k < periods; ++k) {
    for (const Rational& share : shares) lengths.push_back(to_real<R>(2 * share / periods));
    all.insert(all.end(), s.begin(), s.end());
  }
  return {lengths, all};
}

template <Real R>
R FrictionLayout<R>::moment(int j) const {
  R sum = 0;
  for (const FrictionStrip<R>& strip : strips_) {
    sum += strip.alpha * (2 * strip.length / length_) * (j == 0 ? R(1) : middle(strip));
  }
  return sum;
}

STEADYSLIDE_INSTANTIATE_CLASS(FrictionLayout)

template <Real R>
EffectiveFriction<R>::EffectiveFriction(FrictionLayout<R> layout) : layout_(std::move(layout)) {
  const R digits = -log(epsilon<R>());
  // A margin for the factor of e^(-2 pi^2/h): the poles of w lie on the edge of the strip.
  step_ = 2 * pi<R>() * pi<R>() / (digits + 6);
  const auto& strips = layout_.strips();
  const R& length = layout_.length();
  // Left of the first node, A and B differ from their limits by less than epsilon. Right of the last node, the first
  // two orders in 1/d are exact to rounding.
  const R first = log(epsilon<R>() * std::min(strips.front().length, strips.back().length));
  const R last = log(16 * length / sqrt(epsilon<R>()));
  const int count = static_cast<int>(ceil((last - first) / step_));
  nodes_.reserve(static_cast<std::size_t>(count) + 1);
  for (int i = 0; i <= count; ++i) {
    const R d = exp(first + i * step_);
    Node node{d, step_ / pi<R>() * sqrt(d / (d + length)), R(0), R(0), R(1), R(1)};
    for (const FrictionStrip<R>& strip : strips) {
      if (strip.alpha == 0) continue;
      node.a += strip.alpha * log1p(strip.length / (d + strip.from_left));
      node.b += strip.alpha * log1p(strip.length / (d + strip.from_right));
    }
    node.exp_a = exp(node.a);
    node.exp_minus_b = exp(-node.b);
    nodes_.push_back(std::move(node));
  }
}

template <Real R>
R EffectiveFriction<R>::left_tail(const R& first, const R& power) const {
  return first / expm1(step_ * power);
}

template <Real R>
R EffectiveFriction<R>::relative_error() const {
  return (16 + abs(nodes_.front().a) + abs(nodes_.front().b)) * epsilon<R>();
}

template <Real R>
Estimate<R> EffectiveFriction<R>::value() const {
  const auto term = [](const Node& node) { return R(node.weight * (expm1(node.a) - expm1(-node.b))); };
  R sum = term(nodes_.back()) / expm1(step_);  // beyond the last node terms decrease like 1/d
  for (const Node& node : nodes_) sum += term(node);
  const Node& first = nodes_.front();
  sum += left_tail(first.weight * first.exp_a, layout_.strips().front().below_half);
  sum -= left_tail(first.weight * first.exp_minus_b, layout_.strips().back().above_half);
  return Estimate<R>{sum, R(0)}.widened(relative_error());
}

template <Real R>
Estimate<R> EffectiveFriction<R>::direction_difference() const {
  R sum = 0;
  R size = 0;
  // Terms decrease like 1/d^3, so the sum beyond the last node is negligible.
  for (const Node& node : nodes_) {
    const R mean = 4 * node.weight * sinh((node.a + node.b) / 2);
    sum += mean * sinh((node.a - node.b) / 2);
    size += abs(mean) * (abs(node.a) + abs(node.b));  // A - B cancels
  }
  const auto add = [&](const R& term, const R& power) {
    const R tail = left_tail(nodes_.front().weight * term, power);
    sum += tail;
    size += abs(tail);
  };
  const Node& first = nodes_.front();
  const FrictionStrip<R>& left = layout_.strips().front();
  const FrictionStrip<R>& right = layout_.strips().back();
  add(first.exp_a, left.below_half);
  add(exp(-first.a), left.above_half);
  add(-exp(first.b), right.below_half);
  add(-first.exp_minus_b, right.above_half);
  return {sum, relative_error() * size};
}

template <Real R>
Estimate<R> EffectiveFriction<R>::derivative(const R& from_left, const R& from_right) const {
  const auto behind = [&](const Node& node) { return R(node.weight * node.exp_a / (node.d + from_left)); };
  const auto ahead = [&](const Node& node) { return R(node.weight * node.exp_minus_b / (node.d + from_right)); };
  const Node& first = nodes_.front();
  const Node& last = nodes_.back();
  R sum = (behind(last) + ahead(last)) / expm1(step_);
  for (const Node& node : nodes_) sum += behind(node) + ahead(node);
  sum += left_tail(behind(first), layout_.strips().front().below_half);
  sum += left_tail(ahead(first), layout_.strips().back().above_half);
  // dx/(x+y) has no unit. The punch has length 2 in y and the layout's length in x - 1.
  return Estimate<R>{sum * layout_.length() / 2, R(0)}.widened(relative_error());
}

STEADYSLIDE_INSTANTIATE_CLASS(EffectiveFriction)

template <Real R>
ExtremeLayout<R> extreme_layout(const Rational& s_outer, const Rational& s_inner, const Rational& inner_share) {
  if (s_outer == s_inner) throw std::invalid_argument("two coatings of one friction");
  if (inner_share <= 0 || inner_share >= 1) throw std::invalid_argument("a share is between 0 and 1");
  const auto sandwich = sandwich_of<R>(s_outer, s_inner, inner_share);
  const Start start = zero_in_double(sandwich_of<double>(s_outer, s_inner, inner_share));
  const Estimate<R> tau = zero_of(sandwich, start);
  const R left = sandwich.left(tau.value);
  const R right = sandwich.right(tau.value);
  const R error = left * right / sandwich.room * tau.error;
  FrictionLayout<R> layout = sandwich.at(tau.value);
  return {{left, error}, {right, error}, layout, EffectiveFriction<R>(layout).value()};
}

template <Real R>
FineMixture<R> fine_mixture(const std::vector<Rational>& shares, const std::vector<Rational>& s) {
  R mean = 0;
  R below_half = 0;  // 1/2 - <alpha> and 1/2 + <alpha>; as differences they would lose digits for large friction
  R above_half = 0;
  for (std::size_t k = 0; k < s.size(); ++k) {
    const Exponent angle = Exponent::angle(s[k]);
    const R share = to_real<R>(shares[k]);
    mean += share * to_real<R>(angle);
    below_half += share * to_real<R>(half - angle);
    above_half += share * to_real<R>(half + angle);
  }
  const R order = min(below_half, above_half);
  const R size = order < R(0.25) ? R(1 / tan(pi<R>() * order)) : R(tan(pi<R>() * abs(mean)));
  return {Estimate<R>{mean < 0 ? R(-size) : size, R(0)}.widened(16 * epsilon<R>()), order};
}

template <Real R>
R order_of_periods(const R& e, const R& doubled, const R& doubled_twice) {
  const R half_sum = (doubled_twice + e / 2) / doubled / 2;
  return -log(half_sum + sqrt(half_sum * half_sum - R(0.5))) / log(R(2));
}

template <Real R>
std::optional<PunchCore<R>> punch_core(const ContactProblem& problem) {
  const Indenter& punch = problem.indenter();
  const auto is_flat = [&](const Indenter::Piece& piece) {
    return piece.profile == punch.pieces().front().profile && piece.profile.degree() <= 0;
  };
  if (!problem.body().is_half_plane()) return std::nullopt;
  if (problem.elasticity().indenter() || !std::all_of(punch.pieces().begin(), punch.pieces().end(), is_flat))
    return std::nullopt;

  const FrictionLayout<R> layout = FrictionLayout<R>::of(problem);
  const auto end = [&](R FrictionStrip<R>::*weight, int side) {
    R integral = 0;
    R moment = 0;
    for (const FrictionStrip<R>& strip : layout.strips()) {
      const R part = strip.*weight * (2 * strip.length / layout.length());
      integral += part;
      moment += part * layout.middle(strip);
    }
    return R(moment / integral + side * integral / 2);
  };
  const R centre = to_real<R>((punch.left() + punch.right()) / 2);
  const R half_length = to_real<R>((punch.right() - punch.left()) / 2);
  const auto in_users_x = [&](const R& y) {
    return Estimate<R>{centre + half_length * y, 16 * epsilon<R>() * (abs(centre) + half_length)};
  };
  return PunchCore<R>{in_users_x(end(&FrictionStrip<R>::above_half, -1)),
                      in_users_x(end(&FrictionStrip<R>::below_half, 1))};
}

#define STEADYSLIDE_INSTANTIATE(R)                                                                  \
  template ExtremeLayout<R> extreme_layout(const Rational&, const Rational&, const Rational&);      \
  template FineMixture<R> fine_mixture(const std::vector<Rational>&, const std::vector<Rational>&); \
  template R order_of_periods(const R&, const R&, const R&);                                        \
  template std::optional<PunchCore<R>> punch_core(const ContactProblem&);
STEADYSLIDE_FOR_EACH_REAL(STEADYSLIDE_INSTANTIATE)
#undef STEADYSLIDE_INSTANTIATE

}  // namespace steadyslide::numeric
