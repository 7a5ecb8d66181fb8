// The first sentence in words after theorem 2: a wedge where the friction does not jump. [Bal16, theorem 2]

#include "proofs_checks/instruments/words.hpp"

namespace steadyslide::proofs_checks {
namespace {

struct WedgeCase {
  std::string name;
  ContactProblem problem;
};

/// One wedge, (1/3) - (-1) in slope under f = 2, in problems that have nothing else in common; then without friction.
std::vector<WedgeCase> wedges(bool quick) {
  const Rational third(1, 3);
  std::vector<WedgeCase> all{
      {"free ends", flanks(FrictionProfile({2}), Polynomial({0, -1, 1}), Polynomial({0, third, 2}), 6)},
      {"twice the load, other flanks, turned, friction jumps on both sides",
       flanks(FrictionProfile({Rational(1, 2), 2, 0}, {Rational(-1, 4), Rational(3, 8)}),
              Polynomial({0, Rational(-3, 4), 2, Rational(1, 2)}), Polynomial({0, Rational(7, 12), 1}), 12)}};
  if (quick) return all;
  all.push_back({"edges",
                 {Elasticity(Solid(Rational(3, 10), 1)), FrictionProfile({2}),
                  Indenter(-1, {{corner, Polynomial({0, -1})}, {1, Polynomial({Rational(-1, 6), third})}}), 20}});
  all.push_back(
      {"without friction", flanks(FrictionProfile({0}), Polynomial({0, -third, 1, -third}), Polynomial({0, 1, 1}), 6)});
  all.push_back({"without friction, twice the load",
                 flanks(FrictionProfile({0}), Polynomial({0, -third, 3}), Polynomial({0, 1, 2}), 12)});
  return all;
}

struct NotchCase {
  std::string name;
  ContactProblem problem;
  int trend;  ///< of f at the vertex
};

/// A re-entrant corner: 0 - 1 in slope; where the friction rises 0 - 1/8, as little as closes under the load.
std::vector<NotchCase> notches(bool quick) {
  const Rational third(1, 3);
  const Polynomial right({0, 0, 1});
  const Polynomial steep({0, 1, 1});
  const Polynomial blunt({0, Rational(1, 8), 1});
  std::vector<NotchCase> all{{"notch", flanks(FrictionProfile({2}), steep, right, 4), 0},
                             {"notch, f rises", flanks(FrictionProfile({third, 3}, {corner}), blunt, right, 12), 1}};
  if (quick) return all;
  all.push_back({"notch, three times the load", flanks(FrictionProfile({2}), steep, right, 12), 0});
  all.push_back({"notch without friction", flanks(FrictionProfile({0}), steep, right, 4), 0});
  all.push_back({"notch, f falls", flanks(FrictionProfile({3, third}, {corner}), steep, right, 4), -1});
  return all;
}

template <class R>
struct WedgeFacts {
  std::string name;
  Rational wedge;
  Rational s;
  Rational load;
  R coefficient[2];  ///< left, right
  R step;            ///< t(c+d) - t(c-d)
  R elsewhere;       ///< theta at the left end
};
template <class R>
struct NotchFacts {
  std::string name;
  int trend;
  bool is_inside;
};
template <class R>
struct WedgeProblems {
  std::vector<WedgeFacts<R>> wedges;
  std::vector<NotchFacts<R>> notches;
  double on_cells = 0;  ///< relative difference, to D/(1+s^2)
};

/// What is said; the defaults are right.
struct WedgeSaid {
  int sign = 1;
  bool over_square = true;  ///< D/(1+s^2), not D
  int pi_power = 0;
  int load_power = 0;
  int step_sign = 1;
  bool rise_admits = true;  ///< a re-entrant corner, where f rises
  bool plain_admits = false;
  int miss = 0;  ///< in tolerances
};

std::size_t friction_piece(const ContactProblem& problem) { return problem.friction().piece(corner, Side::right); }

double coefficient_on_cells() {
  const ContactProblem problem = cell_case("wedge");
  const auto solution = solve_on_cells(problem, 8192);
  const Rational s = problem.coupled_friction(0);
  const Rational wedge = problem.indenter().breaks().front().wedge;
  const auto expected = numeric::to_real<double>(wedge / (1 + s * s));
  for (const auto& point : solution->singular_points()) {
    if (point.kind == SingularKind::wedge) return relative_difference(point.intensity.value, expected);
  }
  throw Refutation{{"on cells", "no wedge found"}};
}

template <Real R>
WedgeProblems<R> measure(bool quick) {
  WedgeProblems<R> facts;
  for (const WedgeCase& c : wedges(quick)) {
    const auto solution = solve<R>(c.problem);
    const std::size_t j = point_at(*solution, corner);
    const R d = very_near<R>();
    facts.wedges.push_back(
        {c.name,
         wedge_of(c.problem),
         c.problem.coupled_friction(friction_piece(c.problem)),
         c.problem.load(),
         {logarithm_beside(*solution, j, Side::left), logarithm_beside(*solution, j, Side::right)},
         R(traction_beside(*solution, j, Side::right, d) - traction_beside(*solution, j, Side::left, d)),
         solution->contact().front().left.intensity.value});
  }
  for (const NotchCase& c : notches(quick)) {
    const auto solution = solve<R>(c.problem);
    const std::size_t j = point_at(*solution, corner);
    facts.notches.push_back(
        {c.name, c.trend, in_contact(*solution, j, Side::left) && in_contact(*solution, j, Side::right)});
  }
  if (!quick) facts.on_cells = coefficient_on_cells();
  return facts;
}

template <Real R>
void check_wedges(Findings& findings, const std::vector<WedgeFacts<R>>& all, const WedgeSaid& said) {
  using std::pow;
  const Quantity logarithm{"coefficient of log|x-c|/pi in solved problems",
                           {"read off t at d and 2d, on both sides", "D/(1+s^2)"},
                           tolerance<R>()};
  const Quantity step{"t(c+d) - t(c-d)", {"solved problems", "s D/(1+s^2)"}, tolerance<R>(), 0.3};
  for (const WedgeFacts<R>& facts : all) {
    findings.begin_case(facts.name, facts.s != 0);
    const R local =
        numeric::to_real<R>(said.over_square ? Rational(facts.wedge / (1 + facts.s * facts.s)) : facts.wedge);
    const R load = numeric::to_real<R>(facts.load / all.front().load);
    const R coefficient = said.sign * local * pow(numeric::pi<R>(), said.pi_power) * pow(load, said.load_power) *
                          (1 + said.miss * R(tolerance<R>()));
    for (const R& found : facts.coefficient) findings.compare(logarithm, relative_difference<R>(found, coefficient));
    const R expected = said.step_sign * numeric::to_real<R>(facts.s) * local;
    const R scale = numeric::to_real<R>(facts.wedge);
    findings.compare(step, static_cast<double>(R(abs(facts.step - expected) / scale)));
  }
  findings.require(relative_difference<R>(all[0].elsewhere, all[1].elsewhere) > 0.01,
                   "the intensity at the left end is the same in another problem");
}

std::vector<Evidence> check(const Context& context, Once<WedgeProblems>& once, const WedgeSaid& said) {
  return gather_quick_in_double(context, [&]<Real R>() {
    const WedgeProblems<R>& facts = once.at<R>(context.quick, [&] { return measure<R>(context.quick); });
    const Quantity inside{"is the vertex of a re-entrant corner inside the contact? (differences)",
                          {"solved problems", "where f rises"},
                          0};
    Findings findings;
    check_wedges<R>(findings, facts.wedges, said);
    for (const NotchFacts<R>& notch : facts.notches) {
      findings.begin_case(notch.name);
      const bool admitted = notch.trend > 0 ? said.rise_admits : notch.trend == 0 && said.plain_admits;
      findings.compare(inside, notch.is_inside == admitted ? 0 : 1);
    }
    if (!context.quick) {
      findings.begin_case("on 8192 cells");
      findings.compare({"coefficient of the logarithm on cells", {"fit to the cells", "D/(1+s^2)"}, 0.001},
                       facts.on_cells);
    }
    return findings.evidence(std::to_string(facts.wedges.size()) + " solved problems with a wedge, " +
                             std::to_string(facts.notches.size()) + " with a re-entrant corner");
  });
}

}  // namespace

Claim words_wedge() {
  return make_claim(
      claim_text("thm-02-words-wedge"),
      [once = std::make_shared<Once<WedgeProblems>>()](const Context& context, const WedgeSaid& said) {
        return check(context, *once, said);
      },
      WedgeSaid{},
      std::vector<Wrong<WedgeSaid>>{
          {"a coefficient that grows with the load", changed<WedgeSaid>([](WedgeSaid& said) { said.load_power = 1; })},
          {"1/(1+s^2) missing", changed<WedgeSaid>([](WedgeSaid& said) { said.over_square = false; })},
          {"the logarithm's sign", changed<WedgeSaid>([](WedgeSaid& said) { said.sign = -1; })},
          {"1/pi missing", changed<WedgeSaid>([](WedgeSaid& said) { said.pi_power = 1; })},
          {"the step's sign: H(c-x)", changed<WedgeSaid>([](WedgeSaid& said) { said.step_sign = -1; })},
          {"a re-entrant corner excluded where f rises as well",
           changed<WedgeSaid>([](WedgeSaid& said) { said.rise_admits = false; })},
          {"a re-entrant corner admitted where f does not jump",
           changed<WedgeSaid>([](WedgeSaid& said) { said.plain_admits = true; })},
          {"near miss: the coefficient moved by ten times the tolerance",
           changed<WedgeSaid>([](WedgeSaid& said) { said.miss = 10; })}});
}

}  // namespace steadyslide::proofs_checks
