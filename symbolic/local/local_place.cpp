#include "symbolic/local/local_place.hpp"

#include <cstdlib>
#include <stdexcept>

#include "symbolic/field/exponent_expression.hpp"
#include "symbolic/field/expression.hpp"

namespace steadyslide::symbolic {
namespace {

using GiNaC::ex;

bool is_number(const ex& s) { return GiNaC::is_a<GiNaC::numeric>(s); }
Rational number(const ex& s) { return to_rational(GiNaC::ex_to<GiNaC::numeric>(s)); }

/// alpha = arctan(s)/pi, with the sign of "minus a symbol" outside.
Formula angle_text(const ex& s) {
  if (is_number(s)) {
    const Rational slope = number(s);
    return {"arctan(" + slope.str() + ")/pi", "\\tfrac{1}{\\pi}\\arctan " + latex(slope)};
  }
  if (!GiNaC::is_a<GiNaC::symbol>(s)) {
    const Formula positive = angle_text(-s);
    return {"(-" + positive.text + ")", "(-" + positive.latex + ")"};
  }
  const std::string name = GiNaC::ex_to<GiNaC::symbol>(s).get_name();
  if (name == "s_l") return {"alpha_l", "\\alpha_-"};
  if (name == "s_r") return {"alpha_r", "\\alpha_+"};
  return {"alpha" + name.substr(1), "\\alpha" + name.substr(1)};
}

Formula times(int factor, const Formula& of) {
  const int size = std::abs(factor);
  const std::string sign = factor < 0 ? "-" : "";
  if (size == 1) return {sign + of.text, sign + of.latex};
  return {sign + std::to_string(size) + "*" + of.text, sign + std::to_string(size) + of.latex};
}

Formula power_text(const LocalMonomial& monomial) {
  const std::string n = std::to_string(monomial.order);
  Formula result;
  if (monomial.order != 0 || (!monomial.fractional && monomial.logs == 0)) {
    result = monomial.order == 1 ? Formula{"x", "x"} : Formula{"x^" + n, "x^{" + n + "}"};
  }
  if (monomial.fractional)
    result = {result.text + (result.text.empty() ? "" : " ") + "|x|^lambda", result.latex + "|x|^{\\lambda}"};
  if (monomial.logs > 0) {
    const std::string j = monomial.logs > 1 ? "^" + std::to_string(monomial.logs) : "";
    result = {result.text + (result.text.empty() ? "" : " ") + "log" + j + "|x|", result.latex + "\\log" + j + "|x|"};
  }
  return result;
}

}  // namespace

std::string suffix(Side side) { return side == Side::left ? "l" : "r"; }

bool LocalPlace::in_contact(Side side) const {
  return contact == ContactSide::both || (contact == ContactSide::left) == (side == Side::left);
}

LocalFrame::LocalFrame(const LocalPlace& place)
    : left_(place.left.friction),
      right_(place.right.friction),
      field_({place.left.friction, place.right.friction}),
      pi_("pi"),
      names_{{"pi", "\\pi"},
             {"theta", "\\theta"},
             {"theta_1", "\\theta_1"},
             {"theta_2", "\\theta_2"},
             {"s_l", "s_-"},
             {"s_r", "s_+"},
             {"i", "i"}} {
  for (const ex& s : {left_, right_}) {
    const ex positive = GiNaC::is_a<GiNaC::symbol>(s) || is_number(s) ? s : ex(-s);
    if (is_number(positive)) continue;
    const std::string name = GiNaC::ex_to<GiNaC::symbol>(positive).get_name();
    names_["r_" + name] = "\\sqrt{1+" + latex_of(name, names_) + "^{2}}";
  }
}

bool LocalFrame::one_friction() const { return field_.are_equal(left_, right_).holds; }

ex LocalFrame::phase_squared(const LocalExponent& lambda) const {
  return field_.phase(2 * lambda.halves, {{0, 2 * lambda.left}, {1, 2 * lambda.right}});
}

LocalConstants LocalFrame::constants(const LocalExponent& lambda) const {
  // sin and cos by e^{i pi lambda}: cot = i (e^2 + 1)/(e^2 - 1), 1/sin = 2 i e/(e^2 - 1).
  const ex once = field_.phase(lambda.halves, {{0, lambda.left}, {1, lambda.right}});
  const ex twice = field_.canonical(once * once);
  const ex divisor = field_.canonical(twice - 1);
  if (divisor.is_zero()) throw std::domain_error("local exponent: no integer");
  return {field_.canonical(field_.i() * (twice + 1) / divisor), field_.canonical(2 * field_.i() * once / divisor), pi_};
}

std::optional<Exponent> LocalFrame::exact(const LocalExponent& lambda) const {
  Exponent sum(Rational(lambda.halves, 2));
  for (const auto& [times, s] : {std::pair(lambda.left, left_), std::pair(lambda.right, right_)}) {
    if (times == 0) continue;
    if (!is_number(s)) return std::nullopt;
    const Exponent angle = Exponent::angle(number(s));
    for (int k = std::abs(times); k > 0; --k) sum += times > 0 ? angle : -angle;
  }
  return sum;
}

std::optional<int> LocalFrame::floor(const LocalExponent& lambda, std::optional<bool> friction_increases) const {
  if (const std::optional<Exponent> number = exact(lambda)) {
    int below = lambda.halves / 2 - std::abs(lambda.left) - std::abs(lambda.right) - 1;
    while ((*number - Exponent(below + 1)).sign() >= 0) ++below;
    return below;
  }
  // -1/2 < alpha < 1/2, and alpha_left - alpha_right lies between -1 and 1, on the side that its sign says.
  const int angles = std::abs(lambda.left) + std::abs(lambda.right);
  if (angles == 1 && lambda.halves % 2 != 0) return (lambda.halves - 1) / 2;
  if (lambda.left == -lambda.right && angles == 2 && lambda.halves % 2 == 0 && friction_increases) {
    const bool negative = (lambda.left > 0) == *friction_increases;
    return lambda.halves / 2 - (negative ? 1 : 0);
  }
  return std::nullopt;
}

Formula LocalFrame::text(const LocalExponent& lambda) const {
  if (const std::optional<Exponent> number = exact(lambda)) {
    return {steadyslide::to_string(*number), symbolic::latex(*number)};
  }
  Formula result;
  if (lambda.halves != 0 || (lambda.left == 0 && lambda.right == 0)) {
    const Rational half(lambda.halves, 2);
    result = {half.str(), symbolic::latex(half)};
  }
  if (lambda.left != 0) result = sum(result, symbolic::times(lambda.left, angle_text(left_)));
  if (lambda.right != 0) result = sum(result, symbolic::times(lambda.right, angle_text(right_)));
  return result;
}

Formula LocalFrame::text(const ex& element) const { return times(element, {}); }

Formula LocalFrame::times(const ex& element, const Formula& factor) const {
  return product(field_.text(element), factor, names_);
}

std::vector<LocalEquation> local_equations(const LocalPlace& place, const LocalConstants& constants,
                                           const LocalDensity& density) {
  LocalDensity left = act(density, constants);
  for (const auto& [monomial, coefficient] : density) {
    const ex s = monomial.side == Side::left ? place.left.friction : place.right.friction;
    left += {{monomial, s * coefficient}};
  }
  const bool both = place.contact == ContactSide::both;
  const auto jump_at = [&](const LocalMonomial& monomial) -> ex {
    ex jump = 0;
    for (const Side side : {Side::left, Side::right}) {
      const auto found = left.find({side, false, monomial.order, monomial.logs});
      if (found != left.end()) jump += side == Side::right ? found->second : ex(-found->second);
    }
    return jump;
  };
  const auto jump_name = [](const LocalMonomial& monomial) {
    const Formula power = power_text(monomial);
    return Formula{"jump of the coefficient of " + power.text, "\\text{jump of the coefficient of }" + power.latex};
  };
  std::vector<LocalEquation> equations;
  for (const auto& [monomial, coefficient] : left) {
    if (!place.in_contact(monomial.side) || (!monomial.fractional && monomial.logs == 0)) continue;
    if (both && !monomial.fractional && monomial.side == Side::left) {
      // With the right side's coefficient the jump says the same, and solves with fewer conditions.
      equations.push_back({jump_name(monomial), jump_at(monomial), 0});
      continue;
    }
    const Formula power = power_text(monomial);
    const std::string where = monomial.side == Side::left ? "x < 0" : "x > 0";
    equations.push_back({{power.text + ", " + where, power.latex + ",\\ " + where}, coefficient, 0});
  }
  if (!both) return equations;
  for (std::size_t n = 0; n < place.left.slopes.size(); ++n) {
    const LocalMonomial monomial{Side::right, false, static_cast<int>(n), 0};
    equations.push_back({jump_name(monomial), jump_at(monomial), place.right.slopes[n] - place.left.slopes[n]});
  }
  return equations;
}

}  // namespace steadyslide::symbolic
