#include "symbolic/local/local_place.hpp"

#include <stdexcept>

#include "symbolic/field/exponent_expression.hpp"
#include "symbolic/field/expression.hpp"

namespace steadyslide::symbolic {
namespace {

using GiNaC::ex;

bool is_number(const ex& s) { return GiNaC::is_a<GiNaC::numeric>(s); }
Rational number(const ex& s) { return to_rational(GiNaC::ex_to<GiNaC::numeric>(s)); }

/// Returns the text of alpha = arctan(s)/pi. If s is minus a symbol, the sign stands in front of alpha.
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
    : s_{place.left.friction, place.right.friction},
      field_({s_[0], s_[1]}),
      pi_("pi"),
      names_{{"pi", "\\pi"},
             {"theta", "\\theta"},
             {"theta_1", "\\theta_1"},
             {"theta_2", "\\theta_2"},
             {"s_l", "s_-"},
             {"s_r", "s_+"},
             {"i", "i"}} {
  for (const ex& s : s_) {
    const ex positive = GiNaC::is_a<GiNaC::symbol>(s) || is_number(s) ? s : ex(-s);
    if (is_number(positive)) continue;
    const std::string name = GiNaC::ex_to<GiNaC::symbol>(positive).get_name();
    names_["r_" + name] = "\\sqrt{1+" + latex_of(name, names_) + "^{2}}";
  }
}

bool LocalFrame::one_friction() const { return field_.are_equal(s_[0], s_[1]).holds; }

LocalConstants LocalFrame::constants(const AngleForm& lambda) const {
  const LocalConstants written = written_constants(lambda);
  return {field_.canonical(written.cot), field_.canonical(written.cosecant), pi_};
}

LocalConstants LocalFrame::written_constants(const AngleForm& lambda) const {
  // sin and cos by e^{i pi lambda}: cot = i (e^2 + 1)/(e^2 - 1), 1/sin = 2 i e/(e^2 - 1).
  const ex once = field_.phase(lambda);
  const ex twice = once * once;
  if (field_.are_equal(twice, 1).holds) throw std::domain_error("local exponent: no integer");
  return {field_.i() * (twice + 1) / (twice - 1), 2 * field_.i() * once / (twice - 1), pi_};
}

std::optional<Exponent> LocalFrame::exact(const AngleForm& lambda) const {
  std::vector<Rational> frictions(s_.size());
  for (const auto& [k, times] : lambda.times()) {
    if (!is_number(s_[k])) return std::nullopt;
    frictions[k] = number(s_[k]);
  }
  return lambda.exponent(frictions);
}

std::optional<int> LocalFrame::floor(const AngleForm& lambda, std::optional<bool> friction_increases) const {
  if (const std::optional<Exponent> number = exact(lambda)) {
    int below = lambda.twice_bounds().first / 2 - 1;
    while ((*number - Exponent(below + 1)).sign() >= 0) ++below;
    return below;
  }
  // -1/2 < alpha < 1/2. alpha_left - alpha_right lies in ]-1, 0[ or ]0, 1[, depending on its sign.
  const int halves = lambda.halves();
  const AngleForm angles = lambda - AngleForm(halves);
  if (angles.twice_bounds().second == 1 && halves % 2 != 0) return (halves - 1) / 2;
  for (const int sign : {1, -1}) {
    if (angles != local_exponent(0, sign, -sign) || halves % 2 != 0 || !friction_increases) continue;
    return halves / 2 - ((sign > 0) == *friction_increases ? 1 : 0);
  }
  return std::nullopt;
}

Formula LocalFrame::text(const AngleForm& lambda) const {
  if (const std::optional<Exponent> number = exact(lambda)) {
    return {steadyslide::to_string(*number), symbolic::latex(*number)};
  }
  return formula_of(lambda, [this](std::size_t k) { return angle_text(s_[k]); });
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
      // Given the right side's coefficient, the jump is an equivalent equation that needs fewer conditions.
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
