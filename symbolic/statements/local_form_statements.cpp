#include "symbolic/statements/statements.hpp"

#include <string>

#include "symbolic/statements/local_form_check.hpp"

namespace steadyslide::symbolic {
namespace {

using GiNaC::ex;
using GiNaC::symbol;

/// Contact on both sides of a friction jump; the slopes differ by D.
class Jump {
 public:
  explicit Jump(const ex& slope_jump)
      : place_{ContactSide::both, {s_l_, {0, 0, 0}}, {s_r_, {slope_jump, 0, 0}}}, frame_(place_) {}

  ex r(Side side) const { return frame_.friction(side).r; }
  ex difference() const { return s_r_ - s_l_; }
  ex total() const { return s_r_ + s_l_; }

  /// Decides t = x^order times left |x|^lambda for x < 0 and right |x|^lambda for x > 0, plus the given density.
  ExactIdentity decide(const std::string& statement, const AngleForm& lambda, const ex& left, const ex& right,
                       int order = 0, LocalDensity more = {}) const {
    more += {{{Side::left, true, order, 0}, -theta_ * left}, {{Side::right, true, order, 0}, -theta_ * right}};
    return verify_local_form(statement, {place_, frame_, lambda, more});
  }
  ExactIdentity with_constant(const std::string& statement, const ex& left, const ex& right) const {
    return decide(statement, beta, 1 / r(Side::left), 1 / r(Side::right), 0,
                  {{{Side::left, false, 0, 0}, left}, {{Side::right, false, 0, 0}, right}});
  }

  static inline const AngleForm beta = local_exponent(0, 1, -1);
  const LocalFrame& frame() const { return frame_; }

 private:
  symbol s_l_{"s_l"};
  symbol s_r_{"s_r"};
  symbol theta_{"theta"};
  LocalPlace place_;
  LocalFrame frame_;
};

DecidedStatement theorem_2_jump() {
  const Jump jump(0);
  const ex l = jump.r(Side::left);
  const ex r = jump.r(Side::right);
  return {"theorem-2-jump",
          jump.decide("`t = -theta |x|^beta/sqrt(1+s(x)^2)`, `beta = alpha_l - alpha_r`, at a friction jump",
                      Jump::beta, 1 / l, 1 / r),
          {jump.decide("`beta` of the other sign: front and rear exchanged", local_exponent(0, -1, 1), 1 / l, 1 / r),
           jump.decide("`alpha_l + alpha_r` in place of `beta`", local_exponent(0, 1, 1), 1 / l, 1 / r),
           jump.decide("amplitudes of the sides swapped", Jump::beta, 1 / r, 1 / l),
           jump.decide("`1/sqrt(1+s^2)` missing", Jump::beta, 1, 1),
           jump.decide("`sqrt(1+s^2)` in place of its reciprocal", Jump::beta, l, r),
           jump.decide("the sign of one amplitude", Jump::beta, -1 / l, 1 / r),
           jump.decide("`|x|^(beta+1)` with amplitudes of one sign", Jump::beta, -1 / l, 1 / r, 1),
           jump.decide("1/2 added to `beta`", local_exponent(1, 1, -1), 1 / l, 1 / r)}};
}

DecidedStatement theorem_2_wedge_and_jump() {
  const symbol d("D");
  const Jump jump(d);
  const ex a = d / jump.difference();
  const ex l = jump.r(Side::left);
  const ex r = jump.r(Side::right);
  return {"theorem-2-wedge-and-jump",
          jump.with_constant("`t = [psi_bar']/[s] - theta |x|^beta/sqrt(1+s(x)^2)` at a wedge and friction jump", a, a),
          {jump.with_constant("`[s]` taken from right to left", -a, -a),
           jump.with_constant("`s_l + s_r` in place of `[s]`", d / jump.total(), d / jump.total()),
           jump.with_constant("the constant on the right side alone", 0, a),
           jump.with_constant("a factor `pi` in the constant", a / jump.frame().pi(), a / jump.frame().pi()),
           jump.with_constant("the constant without its divisor", d, d),
           jump.decide("the constant missing", Jump::beta, 1 / l, 1 / r),
           jump.decide("a logarithm with the constant", Jump::beta, 1 / l, 1 / r, 0,
                       {{{Side::left, false, 0, 0}, a},
                        {{Side::right, false, 0, 0}, a},
                        {{Side::left, false, 0, 1}, d},
                        {{Side::right, false, 0, 1}, d}})}};
}

/// Contact on both sides of a wedge under one friction.
class Wedge {
 public:
  explicit Wedge(const std::vector<ex>& slope_jumps)
      : place_{ContactSide::both, {s_, {0, 0, 0}}, {s_, slope_jumps}}, frame_(place_) {}

  /// Decides t = sum of x^n D_n (logarithm log|x| + left H(-x) + right H(x)).
  ExactIdentity decide(const std::string& statement, const ex& logarithm, const ex& left, const ex& right) const {
    LocalDensity density;
    for (int n = 0; n < 3; ++n) {
      const ex d = place_.right.slopes[static_cast<std::size_t>(n)];
      for (const Side side : {Side::left, Side::right}) {
        density[{side, false, n, 1}] = d * logarithm;
        density[{side, false, n, 0}] = d * (side == Side::left ? left : right);
      }
    }
    return verify_local_form(statement, {place_, frame_, std::nullopt, density});
  }

  DecidedStatement statement(const std::string& id, const std::string& words) const {
    const ex s = s_;
    const ex one = 1 / (1 + s * s);
    const ex log = one / frame_.pi();
    return {id,
            decide(words, log, 0, s * one),
            {decide("`pi` missing in the logarithm", one, 0, s * one),
             decide("Heaviside's function on the other side", log, s * one, 0),
             decide("the sign of `alpha`", log, 0, -s * one), decide("Heaviside's function missing", log, 0, 0),
             decide("`1/(1+s^2)` missing", 1 / ex(frame_.pi()), 0, s),
             decide("`1/sqrt(1+s^2)` in place of `1/(1+s^2)`", frame_.friction(Side::left).cos / frame_.pi(), 0,
                    s * frame_.friction(Side::left).cos),
             decide("the slopes of the sides swapped", -log, 0, -s * one),
             decide("a factor 2 in the logarithm", 2 * log, 0, s * one)}};
  }

 private:
  symbol s_{"s"};
  LocalPlace place_;
  LocalFrame frame_;
};

/// The power and the slope at an end of contact. The friction beyond the end must have no influence.
DecidedStatement end_statement(const std::string& id, const LocalEnd& end, bool free) {
  const Side contact = end.contact();
  const bool right = contact == Side::right;
  const bool one = end.frame().one_friction();
  const int halves = free ? 1 : -1;
  const int times = right ? -1 : 1;
  const ex r = end.r(contact);
  const ex slope = (right ? 1 : -1) * halves * r;
  const std::string angle = one ? "alpha" : right ? "alpha_r" : "alpha_l";
  const std::string power = std::string(free ? "1/2" : "-1/2") + (right ? " - " : " + ") + angle;
  // lambda = halves/2 + times alpha(side)
  const auto decide = [&](const std::string& words, int of_two, int angles, Side side, const ex& beyond) {
    const AngleForm lambda(of_two, {{side == Side::left ? 0 : 1, angles}});
    return verify_local_form(words, end.candidate(lambda, beyond));
  };
  DecidedStatement result{
      id,
      decide("contact on the " + std::string(right ? "right" : "left") + ": `t = -theta d^(" + power +
                 ")`, `u_bar' = " + (right == free ? "" : "-") + "theta sqrt(1+s^2) d^(" + power + ")` beyond",
             halves, times, contact, slope),
      {decide("the sign of `alpha`: front and rear exchanged", halves, -times, contact, slope),
       decide("`alpha` missing in the power", halves, 0, contact, slope),
       decide("1/2 missing in the power", 0, times, contact, slope),
       decide("`sqrt(1+s^2)` missing in the slope", halves, times, contact, slope / r),
       decide("`1/sqrt(1+s^2)` in the slope", halves, times, contact, slope / (r * r)),
       decide("the sign of the slope", halves, times, contact, -slope),
       decide("the power of the " + std::string(free ? "edge" : "free end") + " with this slope", -halves, times,
              contact, slope)}};
  if (!one) {
    const Side other = opposite(contact);
    result.controls.push_back(decide("the angle of the other side", halves, times, other, slope));
    result.controls.push_back(
        decide("`sqrt(1+s^2)` of the other side in the slope", halves, times, contact, slope / r * end.r(other)));
  }
  return result;
}

}  // namespace

std::vector<DecidedStatement> local_form_statements() {
  const symbol d("D");
  const Wedge wedge({d, 0, 0});
  const Wedge curved({symbol("D_0"), symbol("D_1"), symbol("D_2")});
  const std::string form = "`t = [psi_bar']/(1+s^2) (log|x|/pi + s H(x))` at a wedge";
  std::vector<DecidedStatement> all{theorem_2_jump(), theorem_2_wedge_and_jump(),
                                    wedge.statement("theorem-2-wedge", form + " without a friction jump")};
  for (const bool one_friction : {false, true}) {
    for (const Side contact : {Side::right, Side::left}) {
      const ex s = symbol("s");
      const LocalEnd end = one_friction ? LocalEnd(contact, s, s) : LocalEnd(contact);
      const std::string theorem = one_friction ? "theorem-10" : "theorem-3";
      const std::string side = contact == Side::right ? "-left-end" : "-right-end";
      all.push_back(end_statement(theorem + "-edge" + side, end, false));
      all.push_back(end_statement(theorem + "-free" + side, end, true));
    }
    if (!one_friction) {
      all.push_back(wedge.statement("theorem-9", form + " under constant friction"));
      all.push_back(curved.statement("theorem-9-three-orders",
                                     "`t = D(x)/(1+s^2) (log|x|/pi + s H(x))`, `D(x) = D_0 + D_1 x + D_2 x^2`"));
    }
  }
  return all;
}

}  // namespace steadyslide::symbolic
