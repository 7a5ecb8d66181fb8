#include "enclosure/contact/interior_stress.hpp"

#include <array>
#include <cmath>

#include "model/invalid_data.hpp"

namespace steadyslide::enclosure {
namespace {

/// Re and Im of (1/pi) int t/(x'-zeta), then of the same with the square.
using Potential = std::array<Ball, 4>;

Potential no_potential(Bits bits) { return {Ball(0, bits), Ball(0, bits), Ball(0, bits), Ball(0, bits)}; }

void add(Potential& sum, const Ball& factor, const Potential& term) {
  for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += factor * term[i];
}

/// Returns the number of nodes for which 4 rho^(1-2n)/(rho-1) <= 2^-bits.
int nodes_for(Bits bits, double rho) {
  return static_cast<int>(
      std::ceil((static_cast<double>(bits) + std::log2(4 * rho / (rho - 1))) / (2 * std::log2(rho))));
}

class CauchyIntegral {
 public:
  /// All arguments are in xi.
  CauchyIntegral(const TractionRepresentation& form, JacobiRules& rules, const Rational& x, const Rational& depth)
      : form_(form), set_(form.set()), rules_(rules), bits_(set_.bits()), x_(x, bits_), depth_(depth, bits_) {}

  /// Returns int t/(x'-zeta)^n over a segment in contact.
  Potential over(std::size_t segment) const {
    Potential sum = no_potential(bits_);
    const auto near = [&](const ContactPanel::Interval& part) { return distance(part); };
    const ContactPanel::DistanceRange whole{Ball(0, bits_), set_.length(segment)};
    for (const TractionRule& rule : ContactLoad(form_).rules(segment, whole, near)) {
      const auto& nodes = rule.panel.nodes();
      for (std::size_t i = 0; i < rule.values.size(); ++i)
        add(sum, rule.values[i], kernel(segment, nodes[i].from_left));
      const Ball pole = pole_bound(distance(rule.panel.part()) - rule.panel.reach(Ellipse::far));
      widen(sum, rule.error(pole), pole);
      if (rule.singular) add(sum, Ball(1), singular_part(rule, pole));
    }
    return sum;
  }

 private:
  /// Returns 1/(x'-zeta) and its square.
  Potential kernel(std::size_t segment, const Ball& from_left) const {
    const Ball d = set_.x(segment) + from_left - x_;
    const Ball square = d * d + depth_ * depth_;
    return {d / square, depth_ / square, (d * d - depth_ * depth_) / (square * square),
            Ball(2) * d * depth_ / (square * square)};
  }

  void widen(Potential& sum, const Ball& error, const Ball& pole) const {
    for (std::size_t i = 0; i < 2; ++i) sum[i] = Ball::plus_or_minus(sum[i], error);
    for (std::size_t i = 2; i < 4; ++i) sum[i] = Ball::plus_or_minus(sum[i], error * pole);
  }

  /// Returns a lower bound of the distance from zeta to the panel.
  Ball distance(const ContactPanel::Interval& part) const {
    const Ball left = set_.x(part.segment) + part.from_left - x_;
    const Ball right = x_ - (left + x_ + part.length);
    const Ball aside = max(max(left, right), Ball(0, bits_));
    return sqrt(aside * aside + depth_ * depth_).lower();
  }

  /// Returns int (g - g_k) S/(x'-zeta)^n on a panel that touches c. With u = d/L, and log u = -int_u^1 dv/v, int_0^1
  /// f(u) log u du = -int_0^1 int_0^1 f(v w) dv dw, so the rule is applied twice.
  Potential singular_part(const TractionRule& rule, const Ball& pole) const {
    const ContactPanel::Interval& part = rule.panel.part();
    const TractionRule::Singular& term = *rule.singular;
    const bool right = part.touches == Side::right;
    const Ball two(2, bits_);
    const Ball rho(5, bits_);
    const JacobiRule& unit = rules_(nodes_for(bits_, 5), Ball(0, bits_), Ball(0, bits_));  // on [0, 2]
    const auto at = [&](const Ball& u) {
      const Ball d = part.length * u;
      Potential result = no_potential(bits_);
      add(result, value_at(term.factor, Ball(term.direction) * d),
          kernel(part.segment, right ? set_.length(part.segment) - d : d));
      return result;
    };
    Potential sum = no_potential(bits_);
    const Ball log_length = term.logarithm ? log(part.length) : Ball(1, bits_);
    for (std::size_t i = 0; i < unit.size(); ++i) {
      const Ball v = unit.from_left[i] / two;
      add(sum, log_length * unit.weights[i] / two, at(v));
      for (std::size_t j = 0; term.logarithm && j < unit.size(); ++j) {
        add(sum, -(unit.weights[i] * unit.weights[j] / Ball(4)), at(v * unit.from_left[j] / two));
      }
    }
    // The ellipse rho = 5 about [0, 1] reaches 4/5 beyond: |d| <= 9/5 L on it.
    const Ball largest = bound_within(term.factor, part.length * Ball(Rational(9, 5), 64));
    const Ball applied = term.logarithm ? abs(log_length) + Ball(2) : Ball(1);
    widen(sum, unit.remainder(largest.upper() * pole, rho) / two * applied, pole);
    for (Ball& component : sum) component *= part.length;
    return sum;
  }

  const TractionRepresentation& form_;
  const ContactSet& set_;
  JacobiRules& rules_;
  Bits bits_;
  Ball x_;
  Ball depth_;
};

}  // namespace

StressComponents interior_stress(const EnclosedSolution& solution, const Rational& x, const Rational& z) {
  if (z <= 0) throw InvalidData("z", "place not inside the body", "the depth z is positive", to_string(z));
  const TractionRepresentation& form = solution.form();
  const ContactSet& set = form.set();
  const Frame& frame = set.problem().frame;
  const Bits bits = set.bits();
  JacobiRules rules(bits);
  const CauchyIntegral cauchy(form, rules, (x - frame.origin) / frame.unit, z / frame.unit);
  Potential normal = no_potential(bits), tangential = no_potential(bits);
  for (std::size_t segment = 0; segment < set.segments(); ++segment) {
    if (!set.in_contact(segment)) continue;
    const Potential potential = cauchy.over(segment);
    add(normal, Ball(1) / Ball::pi(bits), potential);
    add(tangential, Ball(solution.shear_ratio(segment), bits) / Ball::pi(bits), potential);
  }
  const Ball depth(Rational(z / frame.unit), bits);
  const auto& [re, im, re_1, im_1] = normal;
  const auto& [re_t, im_t, re_t1, im_t1] = tangential;
  const Ball shift = depth * (re_1 - im_t1);
  return {im + Ball(2) * re_t + shift, im - shift, -im_t - depth * (im_1 + re_t1), im_t - re};
}

}  // namespace steadyslide::enclosure
