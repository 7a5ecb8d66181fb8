// Checks at a step of the profile which contact end belongs to which sign of the step. [Bal16, theorem 3]

#include "proofs_checks/instruments/operators/local_power.hpp"
#include "proofs_checks/instruments/solutions/local_behaviour.hpp"
#include "proofs_checks/instruments/tractions/punch.hpp"
#include "proofs_checks/kit/claim_builder.hpp"

namespace steadyslide::proofs_checks::thm_03_step_conditions {
namespace {

const Rational jump_of_profile(1, 5);

/// Returns a parabola on [-end, end] with a step at 3/7 or -3/7. `high` is the side that is farther from the body.
ContactProblem stepped(const Rational& place, Side high, const Rational& load, const Rational& f = 1,
                       const Rational& end = 1) {
  const Polynomial low({0, 0, Rational(1, 4)});
  const Polynomial lifted({jump_of_profile, 0, Rational(1, 4)});
  return {Elasticity(Solid(Rational(3, 10), 1)), FrictionProfile({f}),
          Indenter(-end, {{place, high == Side::left ? lifted : low}, {end, high == Side::left ? low : lifted}}), load};
}

/// A contact end; the contact lies on the side `contact`.
struct EndCase {
  std::string name;
  ContactProblem problem;
  Side contact;
  /// The point of the step. If absent, the end may be anywhere and the profile is continuous there.
  std::optional<Rational> place;
  /// True if the leading power dominates the next one over enough cells. Otherwise only the solver determines the kind
  /// of the end, and the power is not examined.
  bool on_cells = true;
};

CaseList<EndCase> ends(const Context& context) {
  const Rational left(-3, 7);
  const Rational right(3, 7);
  const Rational load(1, 5);
  const ContactProblem high_left = stepped(left, Side::left, load);
  const ContactProblem high_right = stepped(right, Side::right, load);
  const ContactProblem other_left = stepped(left, Side::left, Rational(1, 4), 3, 2);
  const ContactProblem other_right = stepped(right, Side::right, Rational(1, 4), 3, 2);
  return first_when_quick<EndCase>(
      context,
      {{"psi(c-) > psi(c+), contact on the right", high_left, Side::right, left},
       {"psi continuous, contact on the left", high_left, Side::left, {}},
       {"psi(c-) < psi(c+), contact on the left", high_right, Side::left, right},
       {"psi continuous, contact on the right", high_right, Side::right, {}},
       {"psi(c-) > psi(c+), contact on the right, f = 3", other_left, Side::right, left, false},
       {"psi continuous, contact on the left, f = 3", other_left, Side::left, {}, false},
       {"psi(c-) < psi(c+), contact on the left, f = 3", other_right, Side::left, right, false},
       {"psi continuous, contact on the right, f = 3", other_right, Side::right, {}, false}},
      4, "ends of contact in solved problems");
}

Estimate<double> power_at_end_on_cells(const EndCase& c, std::size_t cells) {
  const auto solution = solve_on_cells(c.problem, cells);
  for (const auto& place : solution->places()) {
    if (!place.is_end() || place.contact != c.contact || place.exact != c.place.has_value()) continue;
    return power_on_cells(*solution, place, c.contact);
  }
  throw Refutation{{c.name, "on cells the contact does not end there"}};
}

/// Returns 1 if the contact is on the right of the point, -1 if on the left.
template <Real R>
int contact_at(const RiemannHilbertSolution<R>& solution, std::size_t point) {
  return int(in_contact(solution, point, Side::right)) - int(in_contact(solution, point, Side::left));
}

enum class End { edge, free };

/// Returns -(1/2+alpha) for an edge and 1/2-alpha for a free end with the contact on the right, and the mirrored powers
/// on the left.
Values powers(End end, Side contact, const ContactProblem& problem) {
  const Exponent angle = alpha(problem, 0);
  const auto power = to_real<Number>((end == End::edge ? -half : half) + (contact == Side::right ? -angle : angle));
  return {{"power", power}, {"cells", power}};
}

}  // namespace

Claim claim() {
  const auto all_ends = [](End end) {
    return [end](Values& p, const EndCase& c) { p.set(powers(end, c.contact, c.problem)); };
  };
  return compared<EndCase>("thm-03-step-conditions")
      .cases(ends)
      .precision(Precision::quick_in_double)
      .measured([]<Real R>(const EndCase& c, const Context& context) -> Values {
        Values found{{"equation", equation_error(c.problem)}};
        const auto solution = solve<R>(c.problem);
        if (c.place) found.add({"side", Number(contact_at(*solution, point_at(*solution, *c.place)))});
        if (!c.on_cells) return found;
        const Estimate<double> on_cells = power_at_end_on_cells(c, context.quick ? 2048 : 8192);
        const EndTraction kind = on_cells.value < 0 ? EndTraction::unbounded : EndTraction::vanishing;
        const R s = to_real<R>(c.problem.coupled_friction(0));
        found.add({"power", end_power<R>(c.contact, kind, s)});
        found.add({"cells", Fitted{on_cells.value, on_cells.error}});
        found.add({"error bar", on_cells.error});
        return found;
      })
      .predicted([](const EndCase& c) -> Values {
        Values said = powers(c.place ? End::edge : End::free, c.contact, c.problem);
        said.add({"error bar", Number(0)});
        said.add({"equation", Number(0)});
        if (c.place) said.add({"side", Number(c.problem.indenter().breaks().front().step > 0 ? -1 : 1)});
        return said;
      })
      .wrong("the power of a free end at a step", all_ends(End::free))
      .wrong("the power of an edge where `psi` is continuous", all_ends(End::edge))
      .wrong("contact on the side of the higher profile", scaled({"side"}, -1))
      .wrong(
          "the same powers at front and rear",
          [](Values& p, const EndCase& c) { p.set(powers(c.place ? End::edge : End::free, Side::right, c.problem)); })
      .near_misses();
}

}  // namespace steadyslide::proofs_checks::thm_03_step_conditions
