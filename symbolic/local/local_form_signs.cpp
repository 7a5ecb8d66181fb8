#include "symbolic/local/local_form_signs.hpp"

#include "symbolic/field/expression.hpp"

namespace steadyslide::symbolic {
namespace {

using GiNaC::ex;
using Sign = LocalCondition::Sign;

Side contact_side(const LocalForm& form) { return form.place.contact == ContactSide::left ? Side::left : Side::right; }

/// Returns the coefficient in u_bar' ~ coefficient d^lambda for t = -theta d^lambda.
ex outside_coefficient(const LocalForm& form, const LocalFrame& frame, const AngleForm& lambda) {
  const Side contact = contact_side(form);
  const LocalDensity image = act({{{contact, true, 0, 0}, -form.theta}}, frame.constants(lambda));
  return frame.field().canonical(image.at({opposite(contact), true, 0, 0}));
}

Truth decided(const ex& expression, Sign sign) {
  if (!GiNaC::is_a<GiNaC::numeric>(expression)) return Truth::unknown;
  const auto& value = GiNaC::ex_to<GiNaC::numeric>(expression);
  const bool holds = sign == Sign::zero          ? value.is_zero()
                     : sign == Sign::nonnegative ? !value.is_negative()
                                                 : !value.is_positive();
  return holds ? Truth::yes : Truth::no;
}

void add(LocalForm& form, const std::string& words, const ex& expression, Sign sign, const Formula& name) {
  const std::string text = sign == Sign::zero ? " = 0" : sign == Sign::nonnegative ? " >= 0" : " <= 0";
  const std::string latex = sign == Sign::zero ? " = 0" : sign == Sign::nonnegative ? " \\ge 0" : " \\le 0";
  const Formula formula{name.text + text, name.latex + latex};
  form.conditions.push_back({words, expression, sign, formula, decided(expression, sign)});
  form.derivation.conclude(words, formula);
  if (form.conditions.back().holds == Truth::no) {
    form.derivation.conclude("For these data that does not hold: there is no such contact at this point.");
  }
}

const Formula theta{"theta", "\\theta"};

/// Returns psi_bar'(c+) - psi_bar'(c-) at the order n.
ex slope_jump(const LocalForm& form, std::size_t n) { return form.place.right.slopes[n] - form.place.left.slopes[n]; }

Formula slope_jump_text(const LocalForm& form, const LocalFrame& frame, std::size_t n) {
  const std::string name = n == 0 ? "psi_bar'" : "psi_bar''";
  const std::string latex = n == 0 ? "\\bar\\psi'" : "\\bar\\psi''";
  const Formula value = frame.text(slope_jump(form, n));
  return {"[" + name + "] = " + value.text, "[" + latex + "] = " + value.latex};
}

void add_jump_conditions(LocalForm& form, const LocalFrame& frame) {
  const bool blows_up = *frame.floor(*form.exponent, form.place.friction_increases) == -1;
  const ex friction_jump = form.place.right.friction - form.place.left.friction;
  const ex jump = slope_jump(form, 0);
  const ex constant = frame.field().canonical(jump / friction_jump);
  const Formula quotient = frame.text(constant);
  const Formula name{"A = [psi_bar']/[s] = " + quotient.text, "A = [\\bar\\psi']/[s] = " + quotient.latex};
  if (blows_up) {
    add(form, "`s` increases: the power dominates, and `t <= 0` asks for one sign of its amplitude.", form.theta,
        Sign::nonnegative, theta);
    if (form.kind == SingularKind::wedge_and_jump) {
      form.derivation.conclude(
          "The constant `A = [psi_bar']/[s]` stays below the power wherever `theta > 0`: the wedge may be re-entrant.",
          name);
    }
    return;
  }
  add(form,
      "`s` decreases: the power vanishes at the point and the constant leads; `t <= 0` asks for its sign, so that "
      "`[s] < 0` asks for `[psi_bar'] >= 0`: no contact around a re-entrant wedge.",
      constant, Sign::nonpositive, name);
  if (frame.field().is_identically_zero(constant).holds) {
    add(form, "The constant is zero, and the power leads.", form.theta, Sign::nonnegative, theta);
    if (!frame.field().is_identically_zero(slope_jump(form, 1)).holds) {
      form.derivation.conclude(
          "`theta = 0` is excluded: the term that led then, `x [psi_bar'']/[s]`, would change its sign at the point.",
          slope_jump_text(form, frame, 1));
    }
  } else {
    form.derivation.conclude("Where `A < 0` the amplitude `theta` may have either sign; where `A = 0`, `theta >= 0`.");
  }
}

void add_end_conditions(LocalForm& form, const LocalFrame& frame) {
  add(form, "The leading power has the sign of `t`.", form.theta, Sign::nonnegative, theta);
  if (form.kind == SingularKind::free) {
    add(form,
        "Beyond the end the gap is `[psi_bar'] d` to first order, and must not be negative: no contact ends at a "
        "re-entrant wedge.",
        slope_jump(form, 0), Sign::nonnegative, slope_jump_text(form, frame, 0));
  }
  if (form.kind == SingularKind::step) {
    form.derivation.conclude(
        "The indenter steps away from the body beyond the end: the gap there begins with the height of the step, and "
        "asks for nothing. On the other side of the step contact cannot end: the surface would have to jump.");
  }
}

}  // namespace

bool penetrates(LocalForm& form, const LocalFrame& frame, const AngleForm& lambda) {
  const Side contact = contact_side(form);
  const ex sign = contact == Side::right ? 1 : -1;
  const ex coefficient = outside_coefficient(form, frame, lambda);
  const ex size = form.theta * frame.friction(contact).r;
  const bool enters = frame.field().are_equal(sign * coefficient, -size).holds;
  if (!enters && !frame.field().are_equal(sign * coefficient, size).holds) {
    throw std::domain_error("local form: the sign of the slope outside is not decided");
  }
  const Formula power = frame.text(lambda);
  const Formula slope = frame.times(coefficient, {"d^(" + power.text + ")", "d^{" + power.latex + "}"});
  form.derivation.act(enters ? "Where `t = -theta d^lambda` with `theta >= 0`, the slope beyond the end is unbounded "
                               "and drives the surface into the indenter, which goes on there: `theta = 0`, and the "
                               "next power leads."
                             : "The next power: the gap it leaves beyond the end is not negative.",
                      {"t = -theta d^(" + power.text + "),  u_bar' = " + slope.text + " + ...",
                       "\\begin{gathered} t = -\\theta d^{" + power.latex + "} \\\\ \\bar u' = " + slope.latex +
                           " + \\dots \\end{gathered}"});
  if (enters) {
    form.conditions.push_back(
        {"The amplitude of the power that would penetrate vanishes.",
         ex(0),
         Sign::zero,
         {"amplitude of d^(" + power.text + ") = 0", "\\text{amplitude of } d^{" + power.latex + "} = 0"},
         Truth::yes});
  }
  return enters;
}

void add_outside(LocalForm& form, const LocalFrame& frame) {
  const ex coefficient = outside_coefficient(form, frame, *form.exponent);
  const Formula power = frame.text(*form.exponent);
  const Formula text = frame.times(coefficient, {"d^(" + power.text + ")", "d^{" + power.latex + "}"});
  form.outside =
      OutsideSlope{coefficient, {"u_bar' = " + text.text + " + ...", "\\bar u' = " + text.latex + " + \\dots"}};
  form.derivation.act(
      "The slope of the surface beyond the end, by `1/sin(pi lambda)`; the rest is `psi_bar'` of the contact "
      "side, continued, and higher powers.",
      form.outside->text);
}

void add_conditions(LocalForm& form, const LocalFrame& frame) {
  if (form.kind && local_terms(*form.kind).is_end) return add_end_conditions(form, frame);
  if (form.kind && local_terms(*form.kind).friction_jumps) return add_jump_conditions(form, frame);
  if (form.kind && !frame.field().is_identically_zero(slope_jump(form, 0)).holds) {
    add(form,
        "`log|x|` tends to `-infinity`: `t <= 0` asks for the sign of its coefficient, so that there is no contact "
        "around a re-entrant wedge.",
        slope_jump(form, 0), Sign::nonnegative, slope_jump_text(form, frame, 0));
    return;
  }
  for (const LocalFormTerm& term : form.terms) {
    if (!term.forced && term.order == 0) {
      add(form, "`t` is continuous at the point.", term.left, Sign::nonpositive, {"a_0", "a_0"});
    }
  }
}

void describe(LocalForm& form, const LocalFrame& frame) {
  const LocalPlace& place = form.place;
  const bool both = place.contact == ContactSide::both;
  form.derivation.title =
      "Local form of `t`: " + std::string(form.kind ? local_terms(*form.kind).words : "interior point");
  if (!both)
    form.derivation.title += place.contact == ContactSide::right ? ", contact on the right" : ", contact on the left";
  form.derivation.assume(
      "`x` is measured from the point. Where there is contact, the rest of the body is felt through one "
      "analytic function `g`, the same on both sides.",
      {"H t + s t = psi_bar' - g", "Ht+st=\\bar\\psi'-g"});
  const Formula left = frame.text(place.left.friction);
  const Formula right = frame.text(place.right.friction);
  if (both && !frame.one_friction()) {
    std::string order;
    if (place.friction_increases) order = *place.friction_increases ? ", s_l < s_r" : ", s_l > s_r";
    form.derivation.assume("Contact on both sides, friction `s` on the left and on the right.",
                           {"s = " + left.text + " for x < 0, s = " + right.text + " for x > 0" + order,
                            "s_- = " + left.latex + ",\\quad s_+ = " + right.latex});
  } else if (both) {
    form.derivation.assume("Contact on both sides under one friction `s`.", {"s = " + left.text, "s = " + left.latex});
  } else {
    const Formula& s = contact_side(form) == Side::left ? left : right;
    form.derivation.assume(std::string("Contact on the ") + (contact_side(form) == Side::left ? "left" : "right") +
                               " only, `t = 0` on the other side, whose friction therefore plays no part; `d = |x|`.",
                           {"s = " + s.text, "s = " + s.latex});
  }
  if (const int derivative = form.kind ? local_terms(*form.kind).derivative : 0; derivative > 0) {
    form.derivation.assume("The slope of the indenter jumps, or a derivative of it.",
                           slope_jump_text(form, frame, static_cast<std::size_t>(derivative - 1)));
  }
}

Formula term_text(const LocalForm& form, const LocalFrame& frame, const LocalFormTerm& term) {
  const bool both = form.place.contact == ContactSide::both;
  if (!both) {
    const Formula exponent = frame.text(*form.exponent + AngleForm(2 * term.order));
    const ex mirrored = form.place.contact == ContactSide::left && term.order % 2 != 0 ? -1 : 1;
    return frame.times(mirrored * (form.place.contact == ContactSide::left ? term.left : term.right),
                       {"d^(" + exponent.text + ")", "d^{" + exponent.latex + "}"});
  }
  Formula power;
  if (term.order > 0) {
    const std::string n = std::to_string(term.order);
    power = term.order == 1 ? Formula{"x", "x"} : Formula{"x^" + n, "x^{" + n + "}"};
  }
  const auto join = [&](const Formula& factor) {
    power = {power.text + (power.text.empty() ? "" : "*") + factor.text, power.latex + factor.latex};
  };
  if (term.fractional) {
    const Formula exponent = frame.text(*form.exponent);
    join({"|x|^(" + exponent.text + ")", "|x|^{" + exponent.latex + "}"});
  }
  if (term.logs > 0) join({"log|x|/pi", "\\frac{\\log|x|}{\\pi}"});
  const ex scale = term.logs > 0 ? ex(frame.pi()) : ex(1);
  const PhaseField& field = frame.field();
  if (term.fractional) {
    join({"cos(pi*alpha(x))", "\\cos\\pi\\alpha(x)"});
    return frame.times(term.right / frame.friction(Side::right).cos, power);
  }
  if (field.are_equal(term.left, term.right).holds) return frame.times(scale * term.left, power);
  join({"H(x)", "H(x)"});
  return frame.times(scale * (term.right - term.left), power);
}

Formula form_text(const LocalForm& form) {
  Formula total;
  std::string lines;  // LaTeX does not break displayed lines itself
  std::size_t count = 0;
  for (const LocalFormTerm& term : form.terms) {
    total = sum(total, term.text);
    if (count++ > 0) lines += " \\\\ &{}";
    lines += (count > 1 && term.text.latex[0] != '-' ? "+" : "") + term.text.latex;
  }
  return {"t = " + total.text + " + ...", "\\begin{aligned} t = {}&" + lines + "+\\dots \\end{aligned}"};
}

std::string legend(const LocalForm& form) {
  if (!form.kind) return "`t` is analytic.";
  const LocalTerms& terms = local_terms(*form.kind);
  if (terms.is_end) return "`t` is `d^lambda` times one analytic function.";
  if (terms.has_logarithm) return "`H(x)` is Heaviside's function; the `a_n` are left to the whole problem.";
  if (!terms.has_constant) return "`t` is `|x|^lambda cos(pi alpha(x))` times one analytic function.";
  return "`t` is `D(x)/[s]` and `|x|^lambda cos(pi alpha(x))` times one analytic function, no logarithm at any order.";
}

}  // namespace steadyslide::symbolic
