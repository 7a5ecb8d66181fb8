// Checks which side's friction governs a contact end at a friction jump. [Bal16, theorem 3]

#include <cmath>

#include "proofs_checks/instruments/solutions/local_behaviour.hpp"
#include "proofs_checks/instruments/tractions/power_product.hpp"
#include "proofs_checks/instruments/tractions/punch.hpp"
#include "proofs_checks/kit/claim_builder.hpp"

namespace steadyslide::proofs_checks::thm_03_contact_side {
namespace {

/// Two flat levels with a step at c = 0, where the friction jumps too. The lower level is in contact. The other level
/// is higher than the surface rises beside a punch with friction up to 50.
struct StepCase {
  Rational nu;
  Rational rear_friction;
  Rational front_friction;
  Side contact;
  bool solved = false;    ///< solve the problem with its step and friction jump
  bool on_cells = false;  ///< also on cells, in a full run

  static Rational height() { return 200; }
  ContactProblem problem() const {
    const Polynomial high = Polynomial::constant(height());
    const bool rear = contact == Side::left;
    return {Elasticity(Solid(nu, 1)), FrictionProfile({rear_friction, front_friction}, {0}),
            Indenter(-1, {{0, rear ? Polynomial() : high}, {1, rear ? high : Polynomial()}}), 1};
  }
  std::size_t piece() const { return contact == Side::left ? 0 : 1; }
  /// Returns the index of this end among the contact ends.
  std::size_t end_at_step() const { return contact == Side::left ? 1 : 0; }
  /// Returns the power with the angle of the friction on the contact's side, or with another angle.
  Exponent power_at_step(const Exponent& angle) const {
    return contact == Side::left ? -(half - angle) : -(half + angle);
  }
};

std::string text_of(const StepCase& c) {
  return "nu = " + to_string(c.nu) + ", f = " + to_string(c.rear_friction) + " behind and " +
         to_string(c.front_friction) + " in front of the step, contact " +
         (c.contact == Side::left ? "behind it" : "in front of it");
}

CaseList<StepCase> step_cases(const Context& context) {
  std::vector<StepCase> cases{{Rational(3, 10), Rational(1, 2), 2, Side::right, true, true},
                              {Rational(3, 10), Rational(1, 2), 2, Side::left, true, true},
                              {Rational(-9, 10), 10, 1, Side::right, true},
                              {Rational(-9, 10), 10, 1, Side::left, true}};
  Random random(context.seed, "contact-side");
  const std::size_t count = context.quick ? 2 : count_for(context, {30, 10, 4});
  for (std::size_t k = 0; k < count; ++k) {
    const Rational rear = random.friction(50);
    const Rational front = random.friction(50);
    cases.push_back({random.poisson(), rear, front, k % 2 == 0 ? Side::left : Side::right});
  }
  return {cases, "4 of a grid, " + std::to_string(count) + " random with seed " + std::to_string(context.seed)};
}

Estimate<double> power_at_step_on_cells(const StepCase& c) {
  const auto solution = solve_on_cells(c.problem(), 8192);
  for (const auto& place : solution->places()) {
    if (place.kind == SingularKind::step) return power_on_cells(*solution, place, c.contact);
  }
  throw Refutation{{text_of(c), "on cells the contact does not end at the step"}};
}

/// The solution of the problem with its step and its friction jump.
template <class R>
struct SolvedStep {
  Solved<R> solution;
  std::optional<Estimate<double>> power_on_cells;
};

/// Checks by quadrature of the formula's traction that the surface stays below the other level.
template <Real R>
void check_gap(Findings& findings, const PowerForm<R>& form, const StepCase& c) {
  const trapezoidal::Grid<R> grid(form.traction().density());
  const R height = to_real<R>(StepCase::height() / c.problem().elasticity().compliance());
  for (const R& d : {R(R(1) / 1000), R(R(1) / 10), R(1)}) {
    findings.require(height - grid.displacement(0, opposite(c.contact), d) > 0, "no gap beside the step");
  }
}

template <Real R>
void check_solved(Findings& findings, const SolvedStep<R>& solved, const PowerForm<R>& form, const StepCase& c) {
  const auto contact = solved.solution->contact();
  findings.require(contact.size() == 1, "more than one contact");
  const bool rear = c.contact == Side::left;
  findings.compare("far end", (rear ? contact.front().left : contact.front().right).x.value, R(rear ? -1 : 1));
  const numeric::PowerTraction<R> said = form.traction();
  const std::size_t step = point_at(*solved.solution, Rational(0));
  for (const R& d : {R(1e-9), R(0.125), R(0.75)}) {
    const auto panel = said.weight.panel(0);
    const auto node = rear ? panel.node_from_right(d) : panel.node_from_left(d);
    findings.compare("traction", traction_beside(*solved.solution, step, c.contact, d), said(0, node));
  }
  if (!solved.power_on_cells) return;
  const Estimate<double>& found = *solved.power_on_cells;
  findings.compare("error bar", found.error);
  findings.compare("cells", found.value, static_cast<double>(form.powers[c.end_at_step()].value), found.error);
}

Exponent contact_angle(const StepCase& c) { return alpha(c.problem(), c.piece()); }
Exponent other_angle(const StepCase& c) { return alpha(c.problem(), 1 - c.piece()); }

PowerProduct traction(const StepCase& c) {
  const Rational left = c.contact == Side::right ? 0 : -1;
  return PowerProduct::on({left, left + 1}, punch_powers({contact_angle(c)}),
                          {punch_amplitude<Number>(c.problem(), c.piece())});
}

/// Returns a change: the angle of the other side's friction, for contact on this side.
auto other_angle_for(Side contact) {
  return [contact](PowerProduct& t, const StepCase& c) {
    if (c.contact == contact) t.exponents[c.end_at_step()] = c.power_at_step(other_angle(c));
  };
}

}  // namespace

Claim claim() {
  return formula_claim<StepCase, PowerProduct>("thm-03-contact-side")
      .cases(step_cases)
      .effective_where([](const StepCase& c) { return c.rear_friction != c.front_friction; })
      .says(traction)
      .checked([kept = std::make_shared<KeptForCases>()]<Real R>(Findings& findings, const PowerProduct& t,
                                                                 const StepCase& c, const Context& context) {
        const PowerForm<R> form = t.at<R>();
        check_surface(findings, surface_of<R>(form, c.problem(), c.piece()), 1);
        check_gap(findings, form, c);
        if (!c.solved) return;
        const SolvedStep<R>& solved = kept->at(c, [&] {
          SolvedStep<R> found{solve<R>(c.problem()), {}};
          if (!context.quick && c.on_cells) found.power_on_cells = power_at_step_on_cells(c);
          return found;
        });
        check_solved(findings, solved, form, c);
      })
      .wrong("the printed angle (5), of the friction behind `c`, for contact in front of `c`",
             other_angle_for(Side::right))
      .wrong("the printed angle (6), of the friction in front of `c`, for contact behind `c`",
             other_angle_for(Side::left))
      .wrong("the mean of both angles' powers",
             [](PowerProduct& t, const StepCase& c) {
               t.move_power(c.end_at_step(), to_real<Number>(contact_angle(c) - other_angle(c)) / 2);
             })
      .near_miss("the power at the step",
                 [](PowerProduct& t, const Number& step, const StepCase& c) { t.move_power(c.end_at_step(), step); });
}

}  // namespace steadyslide::proofs_checks::thm_03_contact_side
