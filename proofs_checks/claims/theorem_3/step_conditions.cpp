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
  all.push_back({"psi(c-) > psi(c+), contact on the right, f = 3", other_left, Side::right, left});
  all.push_back({"psi continuous, contact on the left, f = 3", other_left, Side::left, {}});
  all.push_back({"psi(c-) < psi(c+), contact on the left, f = 3", other_right, Side::left, right});
  all.push_back({"psi continuous, contact on the right, f = 3", other_right, Side::right, {}});
  return all;
}

template <class R>
struct EndFacts {
  std::string name;
  Side contact;
  Rational s;
  Rational step;          ///< psi beyond the end, less psi in contact
  R power;                ///< of the two that the operator allows, an edge's and a free end's, the one on cells
  double off_on_cells;    ///< of the power on cells from it
  R gap;                  ///< next to the end
  double equation_error;  ///< of the solution in double
};
struct CellPower {
  std::string where;
  Side contact;
  Rational s;
  bool edge;
  numeric::Estimate<double> power;
};
template <class R>
struct StepProblems {
  std::vector<EndFacts<R>> ends;
  std::vector<CellPower> cells;
};

/// At an end of contact, on a mesh on which it is told from a power that differs by 1.
double power_on_coarse_cells(const EndCase& c) {
  const auto solution = solve_on_cells(c.problem, 2048);
  for (const auto& place : solution->places()) {
    if (!place.is_end() || place.contact != c.contact || place.exact != c.place.has_value()) continue;
    return power_on_cells(*solution, place, c.contact).value;
  }
  throw Refutation{{c.name, "on cells the contact does not end there"}};
}

template <Real R>
EndFacts<R> measure_end(const EndCase& c) {
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
  const double on_cells = power_on_coarse_cells(c);
  const R power = end_power<R>(c.contact, on_cells < 0 ? Power::unbounded : Power::vanishing, s);
  return {c.name,
          c.contact,
          c.problem.coupled_friction(0),
          step,
          power,
          std::abs(on_cells - static_cast<double>(power)),
          gap_beside(*solution, j, opposite(c.contact), d),
          equation_error(c.problem)};
}

std::vector<CellPower> powers_on_cells() {
  std::vector<CellPower> all;
  for (const Side high : {Side::left, Side::right}) {
    const ContactProblem problem = stepped(Rational(high == Side::left ? -3 : 3, 7), high, Rational(1, 5));
    const auto solution = solve_on_cells(problem, 8192);
    for (const auto& place : solution->places()) {
      if (!place.is_end()) continue;
      all.push_back({std::string(name_of(place.kind)) + ", high on the " + (high == Side::left ? "left" : "right"),
                     place.contact, problem.coupled_friction(0), place.kind == SingularKind::step,
                     power_on_cells(*solution, place, place.contact)});
    }
  }
  return all;
}

template <Real R>
StepProblems<R> measure(bool quick) {
  StepProblems<R> facts;
  for (const EndCase& c : ends(quick)) facts.ends.push_back(measure_end<R>(c));
  if (!quick) facts.cells = powers_on_cells();
  return facts;
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

std::vector<Evidence> check(const Context& context, Once<StepProblems>& once, const StepSaid& said) {
  return gather_quick_in_double(context, [&]<Real R>() {
    const Quantity power{"power at an end of contact",
                         {"of those where the residual of A |x|^p vanishes, the one on cells", "theorem 3"},
                         tolerance<R>()};
    const Quantity near{"distance of the power on 2048 cells from it", {}, 0.1};
    const Quantity equation{
        "equation, solved in double with that power", {"trapezoidal rule", "psi_bar'"}, equation_tolerance};
    const Quantity gap{"gap next to the end", {"solved problems", "psi beyond less psi in contact"}, tolerance<R>()};
    const Quantity cells{"power on cells, in its error bars", {"fit", "theorem 3"}, 3};
    const Quantity bar{"its error bar", {}, 0.02};
    const StepProblems<R>& facts = once.at<R>(context.quick, [&] { return measure<R>(context.quick); });
    Findings findings;
    for (const EndFacts<R>& end : facts.ends) {
      findings.begin_case(end.name);
      const bool edge = end.step != 0 ? said.edge_at_high : said.edge_if_continuous;
      const R expected =
          numeric::to_real<R>(power_of(edge, end.contact, end.s, said)) * (1 + said.miss * R(tolerance<R>()));
      findings.compare(near, end.off_on_cells);
      findings.compare(power, relative_difference<R>(end.power, expected));
      findings.compare(equation, end.equation_error);
      const R step = numeric::to_real<R>(said.third ? Rational(-end.step) : end.step);
      findings.compare(gap, static_cast<double>(R(abs(end.gap - step))));
      findings.require(end.step >= 0, "contact on the higher side only: the surface is above the lower one");
    }
    for (const CellPower& found : facts.cells) {
      findings.begin_case(found.where + ", on cells");
      findings.compare(bar, found.power.error);
      const bool edge = found.edge ? said.edge_at_high : said.edge_if_continuous;
      const auto expected = numeric::to_real<double>(power_of(edge, found.contact, found.s, said));
      findings.compare(cells, std::abs(found.power.value - expected) / found.power.error);
    }
    return findings.evidence(std::to_string(facts.ends.size()) + " ends of contact in solved problems");
  });
}

}  // namespace

Claim step_conditions() {
  return make_claim(
      claim_text("thm-03-step-conditions"),
      [once = std::make_shared<Once<StepProblems>>()](const Context& context, const StepSaid& said) {
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
