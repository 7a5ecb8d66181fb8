// What the surface does outside of the contact, next to an edge [Bal16, theorem 3], and which side's friction governs
// an end of contact that lies on a friction jump.

#include <algorithm>
#include <array>
#include <cmath>

#include "numeric/quadrature/tanh_sinh.hpp"
#include "numeric/quadrature/trapezoidal.hpp"
#include "proofs_checks/claims/claims.hpp"
#include "proofs_checks/instruments/near.hpp"
#include "proofs_checks/instruments/punch.hpp"

namespace steadyslide::proofs_checks {
namespace {

/// One end: u' = factor |Y| outside, and u' ~ coefficient theta d^power next to it, t ~ -theta d^power inside.
template <class R>
struct EndForm {
  R factor;
  R coefficient;
  numeric::Power<R> power;
  bool from_inside = false;  ///< the estimate is read inside of the contact
};

template <class R>
struct OutsideForm : PowerForm<R> {
  EndForm<R> rear;
  EndForm<R> front;
};
using OutsideFormula = Formula<OutsideForm, ContactProblem>;

OutsideFormula outside_formula() {
  return OutsideFormula::from([]<Real R>(const ContactProblem& p) {
    const std::size_t m = p.friction().jumps().size();
    OutsideForm<R> form{punch_form<R>(p), {}, {}};
    const R over_pi = numeric::to_real<R>(p.load()) / numeric::pi<R>();
    const R rear_root = 1 / numeric::cos_pi_alpha<R>(p.coupled_friction(0));
    const R front_root = 1 / numeric::cos_pi_alpha<R>(p.coupled_friction(m));
    form.rear = {R(-over_pi), R(-rear_root), form.powers.front()};
    form.front = {over_pi, front_root, form.powers.back()};
    return form;
  });
}

template <Real R>
void check_outside(Findings& findings, const OutsideForm<R>& form, const ContactProblem& problem) {
  using std::pow;
  const Quantity slope_1{
      "u' outside of the contact, trapezoidal rule", {"(1/pi) int t(x')/(x'-x) dx'", "-+(P/pi) |Y|"}, tolerance<R>()};
  const Quantity slope_2{
      "u' outside of the contact, tanh-sinh rule", {"(1/pi) int t(x')/(x'-x) dx'", "-+(P/pi) |Y|"}, tolerance<R>()};
  const Quantity estimate{"u' over theta d^p next to the edges", {"measured", "-+sqrt(1+s^2)"}, tolerance<R>()};
  const numeric::PowerTraction<R> traction = form.traction();
  const numeric::PiecewiseDensity<R> density = traction.density();
  const numeric::trapezoidal::Grid<R> grid(density);
  // The estimate's error is the distance over the length to the next singular point.
  const R near = R(tolerance<R>()) / 1000 * std::ranges::min(form.lengths);

  for (const Side side : {Side::left, Side::right}) {
    const EndForm<R>& end = side == Side::left ? form.rear : form.front;
    const std::size_t last = side == Side::left ? 0 : form.lengths.size() - 1;
    for (const Rational& distance : {Rational(1, 1000), Rational(1, 10), Rational(2), Rational(50)}) {
      const R d = numeric::to_real<R>(distance);
      const R expected = end.factor * traction.weight.modulus_beyond(side, d);
      findings.compare(slope_1, relative_difference<R>(grid.cauchy(side, d), expected));
      if (distance == Rational(1, 10)) {
        findings.compare(slope_2,
                         relative_difference<R>(numeric::tanh_sinh::cauchy<R>(density, side, d).value, expected));
      }
    }
    const R theta = -form.amplitudes[last] * traction.weight.amplitude(side == Side::left ? 0 : form.lengths.size());
    R slope = end.factor * traction.weight.modulus_beyond(side, near);
    if (end.from_inside) {
      const auto at = grid.midpoint_near(last, side == Side::left ? R(1) / 1'000'000 : R(999'999) / 1'000'000);
      slope = grid.hilbert(at) + numeric::to_real<R>(problem.coupled_friction(last)) * density[last](at.node);
    }
    findings.compare(estimate, relative_difference<R>(slope / (theta * pow(near, end.power.value)), end.coefficient));
  }
}

std::vector<Evidence> check(const Context& context, const OutsideFormula& formula) {
  const auto walk = [&]<Real R>() {
    std::vector<ContactProblem> grid{
        punch(Rational(3, 10), {Rational(1, 2), 2}, {Rational(1, 4)}, 3), punch(Rational(3, 10), {1}), punch(0, {0}),
        punch(Rational(-9, 10), {50, 1, 10}, {0, Rational(1, 2)}), punch(Rational(499, 1000), {3})};
    const Cases cases = punch_cases(context, "outside", std::move(grid), count_for(context, 30, 8, 3),
                                    [](Random& random) { return random.below(3); });
    Findings findings;
    for (const ContactProblem& problem : cases.problems) {
      findings.begin_case(text_of(problem), has_friction(problem));
      check_outside(findings, formula.at<R>(problem), problem);
    }
    return findings.evidence(cases.detail);
  };
  return gather([&] { return numeric::at_precision(context.digits, walk); });
}

Claim outside_slope() {
  const OutsideFormula right = outside_formula();
  return make_claim(
      claim_text("thm-03-outside-slope"), check, right,
      std::vector<Wrong<OutsideFormula>>{
          {"the printed x -> c- at the front: the estimate read inside of the contact",
           right.changed([](auto& form, const ContactProblem&) { form.front.from_inside = true; })},
          {"the other sign of u' in front", right.changed([](auto& form, const ContactProblem&) {
             form.front.factor = -form.front.factor;
             form.front.coefficient = -form.front.coefficient;
           })},
          {"sqrt(1+s^2) missing at the rear",
           right.changed([](auto& form, const ContactProblem&) { form.rear.coefficient = -1; })},
          {"sqrt(1+s^2) of the front at the rear",
           right.changed([](auto& form, const ContactProblem&) { form.rear.coefficient = -form.front.coefficient; })},
          {"the powers of both edges exchanged in the estimate",
           right.changed([](auto& form, const ContactProblem&) { std::swap(form.rear.power, form.front.power); })},
          {"the power of the other side's friction at the rear",
           right.changed([]<Real R>(OutsideForm<R>& form, const ContactProblem& p) {
             form.rear.power = numeric::Power<R>::of(-(half + alpha(p, p.friction().values().size() - 1)));
           })},
          {"near miss: the power at the front moved by ten times the tolerance",
           right.changed(
               []<Real R>(OutsideForm<R>& form, const ContactProblem&) { form.front.power.value += near_miss<R>(); })},
          {"near miss: u' behind moved by ten times the tolerance",
           right.changed(
               []<Real R>(OutsideForm<R>& form, const ContactProblem&) { form.rear.factor *= 1 + near_miss<R>(); })}});
}

/// Two flat levels that meet in a step at c = 0, where the friction jumps too: the lower one is in contact, and the
/// other is higher than the surface rises next to a punch under friction up to 50.
struct StepCase {
  Rational nu;
  Rational rear_friction;
  Rational front_friction;
  Side contact;

  static Rational height() { return 200; }
  ContactProblem problem() const {
    const Polynomial high = Polynomial::constant(height());
    const bool rear = contact == Side::left;
    return {Elasticity(Solid(nu, 1)), FrictionProfile({rear_friction, front_friction}, {0}),
            Indenter(-1, {{0, rear ? Polynomial() : high}, {1, rear ? high : Polynomial()}}), 1};
  }
  std::size_t piece() const { return contact == Side::left ? 0 : 1; }
};
using StepFormula = Formula<PowerForm, StepCase>;

std::string text_of(const StepCase& c) {
  return "nu = " + to_string(c.nu) + ", f = " + to_string(c.rear_friction) + " behind and " +
         to_string(c.front_friction) + " in front of the step, contact " +
         (c.contact == Side::left ? "behind it" : "in front of it");
}

std::vector<StepCase> step_grid() {
  return {{Rational(3, 10), Rational(1, 2), 2, Side::right},
          {Rational(3, 10), Rational(1, 2), 2, Side::left},
          {Rational(-9, 10), 10, 1, Side::right},
          {Rational(-9, 10), 10, 1, Side::left}};
}

/// The grid's first.
std::vector<StepCase> step_cases(const Context& context) {
  std::vector<StepCase> cases = step_grid();
  Random random(context.seed, "contact-side");
  const std::size_t count = context.quick ? 2 : count_for(context, 30, 10, 4);
  for (std::size_t k = 0; k < count; ++k) {
    const Rational rear = random.friction(50);
    const Rational front = random.friction(50);
    cases.push_back({random.poisson(), rear, front, k % 2 == 0 ? Side::left : Side::right});
  }
  return cases;
}

/// The problem solved with its step and its friction jump, at some distances from the step.
constexpr std::array<double, 3> step_distances{1e-9, 0.125, 0.75};
template <class R>
struct SolvedStep {
  std::size_t components;
  R far_end;  ///< of the contact
  std::array<R, step_distances.size()> traction;
  std::optional<numeric::Estimate<double>> power_on_cells;
};
template <class R>
using SolvedSteps = std::vector<SolvedStep<R>>;

numeric::Estimate<double> power_at_step_on_cells(const StepCase& c) {
  const auto solution = solve_on_cells(c.problem(), 8192);
  for (const auto& place : solution->places()) {
    if (place.kind == SingularKind::step) return power_on_cells(*solution, place, c.contact);
  }
  throw Refutation{{text_of(c), "on cells the contact does not end at the step"}};
}

template <Real R>
SolvedSteps<R> measure_steps(bool quick) {
  SolvedSteps<R> all;
  for (const StepCase& c : step_grid()) {
    const auto solution = solve<R>(c.problem());
    const std::size_t step = point_at(*solution, Rational(0));
    const auto contact = solution->contact();
    SolvedStep<R> found{contact.size(), {}, {}, {}};
    found.far_end = c.contact == Side::left ? contact.front().left.x.value : contact.front().right.x.value;
    for (std::size_t k = 0; k < step_distances.size(); ++k) {
      found.traction[k] = traction_beside(*solution, step, c.contact, R(step_distances[k]));
    }
    if (!quick && all.size() < 2) found.power_on_cells = power_at_step_on_cells(c);
    all.push_back(std::move(found));
  }
  return all;
}

/// By quadrature of the formula's traction: the surface stays below the other level.
template <Real R>
void check_gap(Findings& findings, const PowerForm<R>& form, const StepCase& c) {
  const numeric::trapezoidal::Grid<R> grid(form.traction().density());
  const R height = numeric::to_real<R>(StepCase::height() / c.problem().elasticity().compliance());
  for (const R& d : {R(R(1) / 1000), R(R(1) / 10), R(1)}) {
    findings.require(height - grid.displacement(0, opposite(c.contact), d) > 0, "no gap beside the step");
  }
}

std::vector<Evidence> check_step(const Context& context, Once<SolvedSteps>& once, const StepFormula& formula) {
  const auto walk = [&]<Real R>() {
    const Quantity traction{"traction beside the step", {"solved, with step and jump", "the formula"}, tolerance<R>()};
    const Quantity far_end{"the contact's other end", {"solved, with step and jump", "the edge"}, tolerance<R>()};
    const Quantity cells{"power at the step on 8192 cells, in its error bars", {"fit", "the formula"}, 3, 0};
    const Quantity bar{"its error bar", {}, 0.02, 0};
    const std::vector<StepCase> cases = step_cases(context);
    const SolvedSteps<R>& solved = once.at<R>(context.quick, [&] { return measure_steps<R>(context.quick); });
    Findings findings;
    for (std::size_t k = 0; k < cases.size(); ++k) {
      const StepCase& c = cases[k];
      findings.begin_case(text_of(c), c.rear_friction != c.front_friction);
      const PowerForm<R> form = formula.at<R>(c);
      const auto no_slope = [](const R&) { return R(0); };
      check_surface(findings, surface_of<R>(form, c.problem(), c.piece(), no_slope), 1);
      check_gap(findings, form, c);
      if (k >= solved.size()) continue;
      findings.require(solved[k].components == 1, "more than one contact");
      findings.compare(far_end, relative_difference<R>(solved[k].far_end, R(c.contact == Side::left ? -1 : 1)));
      const numeric::PowerTraction<R> said = form.traction();
      for (std::size_t i = 0; i < step_distances.size(); ++i) {
        const R d = step_distances[i];
        const auto panel = said.weight.panel(0);
        const auto node = c.contact == Side::left ? panel.node_from_right(d) : panel.node_from_left(d);
        findings.compare(traction, relative_difference<R>(solved[k].traction[i], said(0, node)));
      }
      if (!solved[k].power_on_cells) continue;
      const numeric::Estimate<double>& found = *solved[k].power_on_cells;
      findings.compare(bar, found.error);
      const auto power = static_cast<double>(form.powers[c.contact == Side::left ? 1 : 0].value);
      findings.compare(cells, std::abs(found.value - power) / found.error);
    }
    return findings.evidence("4 of a grid, " + std::to_string(cases.size() - 4) + " random with seed " +
                             std::to_string(context.seed));
  };
  return gather([&] { return numeric::at_precision(context.digits, walk); });
}

/// The angle at the end of contact that lies on the step.
Exponent contact_angle(const StepCase& c) { return alpha(c.problem(), c.piece()); }
Exponent other_angle(const StepCase& c) { return alpha(c.problem(), 1 - c.piece()); }

/// Gives the end at the step the power with that angle.
void set_step_power(auto& form, const StepCase& c, const Exponent& angle) {
  if (c.contact == Side::right) {
    form.set_exponent(0, -(half + angle));
  } else {
    form.set_exponent(1, -(half - angle));
  }
}

Claim contact_side() {
  const StepFormula right = StepFormula::from([]<Real R>(const StepCase& c) {
    const Exponent angle = contact_angle(c);
    const std::vector<Rational> points =
        c.contact == Side::right ? std::vector<Rational>{0, 1} : std::vector<Rational>{-1, 0};
    return power_form<R>(points, {-(half + angle), -(half - angle)}, {punch_amplitude<R>(c.problem(), c.piece())});
  });
  const auto to_the_other = [](auto& form, const StepCase& c) { set_step_power(form, c, other_angle(c)); };
  return make_claim(
      claim_text("thm-03-contact-side"),
      [once = std::make_shared<Once<SolvedSteps>>()](const Context& context, const StepFormula& formula) {
        return check_step(context, *once, formula);
      },
      right,
      std::vector<Wrong<StepFormula>>{
          {"the printed angle (5), of the friction behind c, for contact in front of c",
           right.changed([to_the_other](auto& form, const StepCase& c) {
             if (c.contact == Side::right) to_the_other(form, c);
           })},
          {"the printed angle (6), of the friction in front of c, for contact behind c",
           right.changed([to_the_other](auto& form, const StepCase& c) {
             if (c.contact == Side::left) to_the_other(form, c);
           })},
          {"the mean of both angles' powers", right.changed([]<Real R>(PowerForm<R>& form, const StepCase& c) {
             const R step = (numeric::to_real<R>(contact_angle(c)) - numeric::to_real<R>(other_angle(c))) / 2;
             form.move_power(c.contact == Side::right ? 0 : 1, step);
           })},
          {"near miss: the power at the step moved by ten times the tolerance",
           right.changed([]<Real R>(PowerForm<R>& form, const StepCase& c) {
             form.move_power(c.contact == Side::right ? 0 : 1, near_miss<R>());
           })}});
}

}  // namespace

std::vector<Claim> outside_claims() { return {outside_slope(), contact_side()}; }

}  // namespace steadyslide::proofs_checks
