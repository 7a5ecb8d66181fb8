// The third sentence in words after theorem 2: a wedge where the friction jumps. [Bal16, theorem 2]

#include "proofs_checks/instruments/convergence/convergence_cases.hpp"
#include "proofs_checks/instruments/operators/local_power.hpp"
#include "proofs_checks/instruments/solutions/flanks.hpp"
#include "proofs_checks/instruments/solutions/near.hpp"

namespace steadyslide::proofs_checks {
namespace {

struct CornerCase {
  std::string name;
  ContactProblem problem;
};

/// Friction from `rear` to `front` over a corner whose slope turns from `left` to `right`.
CornerCase corner_case(std::string name, const Rational& rear, const Rational& front, const Rational& left,
                       const Rational& right, const Rational& load) {
  return {std::move(name),
          flanks(FrictionProfile({rear, front}, {corner}), Polynomial({0, left, 1}), Polynomial({0, right, 2}), load)};
}

std::vector<CornerCase> corners(bool quick) {
  const Rational low(1, 3);
  const Rational eighth(1, 8);
  std::vector<CornerCase> all{corner_case("wedge, f falls", 3, low, -low, 1, 6),
                              corner_case("wedge, f rises", low, 3, -1, low, 6),
                              corner_case("notch, f falls", 3, low, 1, 0, 4)};
  if (quick) return all;
  all.push_back(corner_case("wedge, f falls, twice the load", 3, low, -low, 1, 12));
  all.push_back(corner_case("blunt wedge, f falls", 3, low, 0, eighth, 6));
  all.push_back(corner_case("no wedge, f falls", 3, low, 0, 0, 6));
  all.push_back(corner_case("blunt wedge, f rises", low, 3, 0, eighth, 6));
  all.push_back(corner_case("no wedge, f rises", low, 3, 0, 0, 6));
  all.push_back(corner_case("notch, f rises", low, 3, eighth, 0, 12));
  return all;
}

template <class R>
struct CornerFacts {
  std::string name;
  Rational wedge;
  Rational s[2];
  bool is_inside;         ///< contact on both sides of c
  R limit[2];             ///< left, right, where f falls
  R power;                ///< that the operator asks for
  double equation_error;  ///< of the solution in double
};
template <class R>
struct CornerProblems {
  std::vector<CornerFacts<R>> corners;
  double on_cells = 0;                                     ///< relative difference to the right limit
  std::vector<numeric::Estimate<double>> powers_on_cells;  ///< of a wedge where f rises, on both sides
  Exponent power_on_cells;                                 ///< beta there
};

struct CornerSaid {
  enum class Limit { right, zero, other_sign, logarithm } limit = Limit::right;
  bool power_feels_wedge = false;
  bool notch_stays = false;  ///< a re-entrant corner in the contact where f falls
  int miss_limit = 0;
  int miss_power = 0;
};

/// [psi_bar']/[s], or what is said instead.
Rational limit_of(const Rational& wedge, const Rational (&s)[2], const CornerSaid& said) {
  switch (said.limit) {
    case CornerSaid::Limit::right: return wedge / (s[1] - s[0]);
    case CornerSaid::Limit::zero: return 0;
    case CornerSaid::Limit::other_sign: return wedge / (s[0] - s[1]);
    default: return -wedge / (1 + s[0] * s[0]);
  }
}

/// Of a wedge with friction falling, less [psi_bar']/[s].
double constant_on_cells(const CornerSaid& said) {
  const ContactProblem problem = with_friction_reversed(cell_case("wedge-and-jump"));
  const auto solution = solve_on_cells(problem, 8192);
  const Rational s[2] = {problem.coupled_friction(0), problem.coupled_friction(1)};
  const auto expected = numeric::to_real<double>(limit_of(problem.indenter().breaks().front().wedge, s, said));
  for (const auto& point : solution->singular_points()) {
    if (point.kind == SingularKind::wedge_and_jump) return relative_difference(point.constant.value, expected);
  }
  throw Refutation{{"on cells", "no wedge and jump found"}};
}

/// Of a wedge with friction rising, with the wedge's polynomial beside the power.
template <class R>
void measure_powers_on_cells(CornerProblems<R>& facts) {
  const ContactProblem problem = cell_case("wedge-and-jump");
  facts.power_on_cells = Exponent::angle(problem.coupled_friction(0)) - Exponent::angle(problem.coupled_friction(1));
  const auto solution = solve_on_cells(problem, 8192);
  for (const auto& place : solution->places()) {
    if (place.kind != SingularKind::wedge_and_jump) continue;
    for (const Side side : {Side::left, Side::right}) {
      facts.powers_on_cells.push_back(power_on_cells(*solution, place, side));
    }
  }
}

template <Real R>
CornerProblems<R> measure(bool quick) {
  CornerProblems<R> facts;
  for (const CornerCase& c : corners(quick)) {
    const auto solution = solve<R>(c.problem);
    const std::size_t j = point_at(*solution, corner);
    const Rational rear = c.problem.coupled_friction(0);
    const Rational front = c.problem.coupled_friction(1);
    CornerFacts<R> found{c.name,
                         wedge_of(c.problem),
                         {rear, front},
                         in_contact(*solution, j, Side::left) && in_contact(*solution, j, Side::right),
                         {},
                         jump_power<R>(numeric::to_real<R>(rear), numeric::to_real<R>(front)).power,
                         equation_error(c.problem)};
    if (found.is_inside && front < rear) {
      found.limit[0] = limit_beside(*solution, j, Side::left);
      found.limit[1] = limit_beside(*solution, j, Side::right);
    }
    facts.corners.push_back(std::move(found));
  }
  if (!quick) {
    facts.on_cells = constant_on_cells({});
    measure_powers_on_cells(facts);
  }
  return facts;
}

template <Real R>
void check_corner(Findings& findings, const CornerFacts<R>& c, const CornerSaid& said) {
  const Quantity limit{"limit where f falls, solved problems",
                       {"extrapolated from t at d, 2d, 4d, on both sides", "[psi_bar']/[s]"},
                       tolerance<R>()};
  const Quantity power{
      "power where f rises", {"where the residual of A |x|^p vanishes, by quadrature", "beta"}, tolerance<R>()};
  const Quantity equation{"equation, solved in double", {"trapezoidal rule", "psi_bar'"}, equation_tolerance};
  const bool rises = c.s[1] > c.s[0];
  const bool stays = rises || c.wedge >= 0 || said.notch_stays;
  findings.compare(
      {"is the corner inside the contact? (differences)", {"solved problems", "all but f falling with D < 0"}, 0},
      c.is_inside == stays ? 0 : 1);
  findings.compare(equation, c.equation_error);
  if (!c.is_inside) return;
  if (rises) {
    const Exponent beta = Exponent::angle(c.s[0]) - Exponent::angle(c.s[1]);
    R expected = numeric::to_real<R>(beta) * (1 + said.miss_power * R(tolerance<R>()));
    if (said.power_feels_wedge && c.wedge != 0) expected += 1;
    findings.compare(power, relative_difference<R>(c.power, expected));
    return;
  }
  for (const R& found : c.limit) {
    const R expected = numeric::to_real<R>(limit_of(c.wedge, c.s, said)) * (1 + said.miss_limit * R(tolerance<R>()));
    // Beside a power of the distance a limit is exact to digits of the power's size.
    using std::abs, std::max;
    findings.compare(limit, static_cast<double>(R(abs(found - expected) / max(R(abs(expected)), R(1)))));
    findings.require(c.wedge == 0 || expected < 0, "the limit is no pressure");
  }
}

std::vector<Evidence> check(const Context& context, Once<CornerProblems>& once, const CornerSaid& said) {
  return gather_quick_in_double(context, [&]<Real R>() {
    const CornerProblems<R>& facts = once.at<R>(context.quick, [&] { return measure<R>(context.quick); });
    Findings findings;
    for (const CornerFacts<R>& c : facts.corners) {
      findings.begin_case(c.name);
      check_corner(findings, c, said);
    }
    if (!context.quick) {
      findings.begin_case("wedge, f falls, on 8192 cells");
      findings.compare({"limit where f falls, on cells", {"fit to the cells", "[psi_bar']/[s]"}, 0.001},
                       facts.on_cells);
      findings.begin_case("wedge, f rises, on 8192 cells");
      findings.require(!facts.powers_on_cells.empty(), "on cells, no wedge and jump found");
      const double beta = numeric::to_real<double>(facts.power_on_cells) + (said.power_feels_wedge ? 1 : 0);
      for (const numeric::Estimate<double>& found : facts.powers_on_cells) {
        findings.compare({"its error bar", {}, 0.02}, found.error);
        findings.compare({"power where f rises, on cells, in its error bars", {"fit to the cells", "beta"}, 3},
                         std::abs(found.value - beta) / found.error);
      }
    }
    return findings.evidence(std::to_string(facts.corners.size()) + " solved problems");
  });
}

}  // namespace

// In its plain form: fits to cells are compared within their own error bars.
Claim thm_02_words_wedge_and_jump() {
  using Limit = CornerSaid::Limit;
  return make_claim(
      claim_text("thm-02-words-wedge-and-jump"),
      [once = std::make_shared<Once<CornerProblems>>()](const Context& context, const CornerSaid& said) {
        return check(context, *once, said);
      },
      CornerSaid{},
      std::vector<Wrong<CornerSaid>>{
          {"zero where f falls, as without the wedge",
           changed<CornerSaid>([](CornerSaid& said) { said.limit = Limit::zero; })},
          {"the sign of [s]", changed<CornerSaid>([](CornerSaid& said) { said.limit = Limit::other_sign; })},
          {"D/(1+s^2), as for the logarithm",
           changed<CornerSaid>([](CornerSaid& said) { said.limit = Limit::logarithm; })},
          {"the wedge changes the power where f rises",
           changed<CornerSaid>([](CornerSaid& said) { said.power_feels_wedge = true; })},
          {"a negative limit for any wedge: contact at a re-entrant corner where f falls",
           changed<CornerSaid>([](CornerSaid& said) { said.notch_stays = true; })},
          {"near miss: the limit moved by ten times the tolerance",
           changed<CornerSaid>([](CornerSaid& said) { said.miss_limit = 10; })},
          {"near miss: the power moved by ten times the tolerance",
           changed<CornerSaid>([](CornerSaid& said) { said.miss_power = 10; })}});
}

}  // namespace steadyslide::proofs_checks
