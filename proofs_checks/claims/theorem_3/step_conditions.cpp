// At a step of the profile: which end of contact goes with which sign of the step. [Bal16, theorem 3]

#include "proofs_checks/instruments/local_power.hpp"
#include "proofs_checks/instruments/punch.hpp"
#include "proofs_checks/instruments/words.hpp"

namespace steadyslide::proofs_checks {
namespace {

/// A parabola on [-end, end] with a step of 1/5 at 3/7, or at -3/7: `high` is the side away from the body.
ContactProblem stepped(const Rational& place, Side high, const Rational& load, const Rational& f = 1,
                       const Rational& end = 1) {
  const Polynomial low({0, 0, Rational(1, 4)});
  const Polynomial lifted({Rational(1, 5), 0, Rational(1, 4)});
  return {Elasticity(Solid(Rational(3, 10), 1)), FrictionProfile({f}),
          Indenter(-end, {{place, high == Side::left ? lifted : low}, {end, high == Side::left ? low : lifted}}), load};
}

/// An end of the contact, with the contact on the side `contact`.
struct EndCase {
  std::string name;
  ContactProblem problem;
  Side contact;
  std::optional<Rational> place;  ///< absent: wherever it is, the profile is continuous there
  bool on_cells = true;           ///< does the leading power there outweigh the next one over cells enough?
};

std::vector<EndCase> ends(bool quick) {
  const Rational left(-3, 7);
  const Rational right(3, 7);
  const Rational load(1, 5);
  const ContactProblem high_left = stepped(left, Side::left, load);
  const ContactProblem high_right = stepped(right, Side::right, load);
  std::vector<EndCase> all{{"psi(c-) > psi(c+), contact on the right", high_left, Side::right, left},
                           {"psi continuous, contact on the left", high_left, Side::left, {}},
                           {"psi(c-) < psi(c+), contact on the left", high_right, Side::left, right},
                           {"psi continuous, contact on the right", high_right, Side::right, {}}};
  if (quick) return all;
  const ContactProblem other_left = stepped(left, Side::left, Rational(1, 4), 3, 2);
  const ContactProblem other_right = stepped(right, Side::right, Rational(1, 4), 3, 2);
  all.push_back({"psi(c-) > psi(c+), contact on the right, f = 3", other_left, Side::right, left, false});
  all.push_back({"psi continuous, contact on the left, f = 3", other_left, Side::left, {}, false});
  all.push_back({"psi(c-) < psi(c+), contact on the left, f = 3", other_right, Side::left, right, false});
  all.push_back({"psi continuous, contact on the right, f = 3", other_right, Side::right, {}, false});
  return all;
}

template <class R>
struct EndFacts {
  std::string name;
  Side contact;
  Rational s;
  Rational step;  ///< psi beyond the end, less psi in contact
  R power;        ///< of the two that the operator allows, an edge's and a free end's
  std::optional<numeric::Estimate<double>> on_cells;
  R gap;                  ///< next to the end
  double equation_error;  ///< of the solution in double
};
template <class R>
using EndList = std::vector<EndFacts<R>>;

numeric::Estimate<double> power_at_end_on_cells(const EndCase& c, std::size_t cells) {
  const auto solution = solve_on_cells(c.problem, cells);
  for (const auto& place : solution->places()) {
    if (!place.is_end() || place.contact != c.contact || place.exact != c.place.has_value()) continue;
    return power_on_cells(*solution, place, c.contact);
  }
  throw Refutation{{c.name, "on cells the contact does not end there"}};
}

template <Real R>
EndFacts<R> measure_end(const EndCase& c, std::size_t cells) {
  const auto solution = solve<R>(c.problem);
  const std::size_t j = c.place ? point_at(*solution, *c.place) : contact_end(*solution, opposite(c.contact));
  if (!in_contact(*solution, j, c.contact) || in_contact(*solution, j, opposite(c.contact))) {
    throw Refutation{{c.name, "the contact does not end there"}};
  }
  Rational step = 0;
  if (c.place) step = c.problem.indenter().breaks().front().step * (c.contact == Side::right ? -1 : 1);
  // u ~ d^(1/2 -+ alpha) beyond an edge: nothing beside the step only at distances far below 10^-digits.
  using std::pow;
  const R d = pow(very_near<R>(), 6);
  const R s = numeric::to_real<R>(c.problem.coupled_friction(0));
  std::optional<numeric::Estimate<double>> on_cells;
  if (c.on_cells) on_cells = power_at_end_on_cells(c, cells);
  // Where cells say of which kind the end is, they decide; else the solved problem does.
  const bool unbounded = on_cells ? on_cells->value < 0 : solution->form().exponent(j).sign() < 0;
  const R power = end_power<R>(c.contact, unbounded ? Power::unbounded : Power::vanishing, s);
  return {c.name,
          c.contact,
          c.problem.coupled_friction(0),
          step,
          power,
          on_cells,
          gap_beside(*solution, j, opposite(c.contact), d),
          equation_error(c.problem)};
}

template <Real R>
EndList<R> measure(bool quick) {
  EndList<R> list;
  for (const EndCase& c : ends(quick)) list.push_back(measure_end<R>(c, quick ? 2048 : 8192));
  return list;
}

struct StepSaid {
  bool edge_at_high = true;  ///< where the profile beyond the end is the higher one
  bool edge_if_continuous = false;
  bool third = false;        ///< contact only on the side of the higher profile, too
  bool sides_alike = false;  ///< the powers of rear and front
  int miss = 0;
};

/// -(1/2+alpha), 1/2-alpha with the contact on the right; mirrored on the left.
Exponent power_of(bool edge, Side contact, const Rational& s, const StepSaid& said) {
  const bool rear = contact == Side::right || said.sides_alike;
  return (edge ? -half : half) + (rear ? -Exponent::angle(s) : Exponent::angle(s));
}

std::vector<Evidence> check(const Context& context, Once<EndList>& once, const StepSaid& said) {
  return gather_quick_in_double(context, [&]<Real R>() {
    const Quantity power{"power at an end of contact",
                         {"of those where the residual of A |x|^p vanishes, the one on cells", "theorem 3"},
                         tolerance<R>()};
    const Quantity equation{
        "equation, solved in double with that power", {"trapezoidal rule", "psi_bar'"}, equation_tolerance};
    const Quantity gap{"gap next to the end", {"solved problems", "psi beyond less psi in contact"}, tolerance<R>()};
    const Quantity cells{"power on cells, in its error bars", {"fit", "theorem 3"}, 3};
    const Quantity bar{"its error bar", {}, 0.02};
    const EndList<R>& facts = once.at<R>(context.quick, [&] { return measure<R>(context.quick); });
    Findings findings;
    for (const EndFacts<R>& end : facts) {
      findings.begin_case(end.name);
      const bool edge = end.step != 0 ? said.edge_at_high : said.edge_if_continuous;
      const R expected =
          numeric::to_real<R>(power_of(edge, end.contact, end.s, said)) * (1 + said.miss * R(tolerance<R>()));
      findings.compare(power, relative_difference<R>(end.power, expected));
      findings.compare(equation, end.equation_error);
      const R step = numeric::to_real<R>(said.third ? Rational(-end.step) : end.step);
      findings.compare(gap, static_cast<double>(R(abs(end.gap - step))));
      findings.require(end.step >= 0, "contact on the higher side only: the surface is above the lower one");
      if (!end.on_cells) continue;
      findings.begin_case(end.name + ", on cells");
      findings.compare(bar, end.on_cells->error);
      findings.compare(cells, std::abs(end.on_cells->value - static_cast<double>(expected)) / end.on_cells->error);
    }
    return findings.evidence(std::to_string(facts.size()) + " ends of contact in solved problems");
  });
}

}  // namespace

Claim step_conditions() {
  return make_claim(
      claim_text("thm-03-step-conditions"),
      [once = std::make_shared<Once<EndList>>()](const Context& context, const StepSaid& said) {
        return check(context, *once, said);
      },
      StepSaid{},
      std::vector<Wrong<StepSaid>>{
          {"the power of a free end at a step", changed<StepSaid>([](StepSaid& said) { said.edge_at_high = false; })},
          {"the power of an edge where psi is continuous",
           changed<StepSaid>([](StepSaid& said) { said.edge_if_continuous = true; })},
          {"contact on the side of the higher profile", changed<StepSaid>([](StepSaid& said) { said.third = true; })},
          {"the same powers at front and rear", changed<StepSaid>([](StepSaid& said) { said.sides_alike = true; })},
          {"near miss: the power moved by ten times the tolerance",
           changed<StepSaid>([](StepSaid& said) { said.miss = 10; })}});
}

}  // namespace steadyslide::proofs_checks
