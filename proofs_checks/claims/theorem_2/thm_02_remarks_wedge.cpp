// The first sentence in words after theorem 2: a wedge where the friction does not jump. [Bal16, theorem 2]

#include "proofs_checks/instruments/solutions/flanks.hpp"
#include "proofs_checks/instruments/solutions/local_behaviour.hpp"
#include "proofs_checks/instruments/tractions/punch.hpp"
#include "proofs_checks/kit/claim_builder.hpp"

namespace steadyslide::proofs_checks::thm_02_remarks_wedge {
namespace {

enum class Examined {
  wedge,     ///< a wedge, solved
  notch,     ///< a re-entrant corner, solved
  on_cells,  ///< a wedge on cells
};

struct CornerCase {
  std::string name;
  Examined examined;
  ContactProblem problem;
  int trend = 0;  ///< sign of the change of f at the vertex
  /// A problem with the same wedge and otherwise different data.
  std::optional<ContactProblem> other = {};

  Rational place() const { return problem.indenter().breaks().front().x; }
  Rational s() const { return s_of(problem, problem.friction().piece(place(), Side::right)); }
  /// Returns D, reduced.
  Number wedge() const { return to_real<Number>(wedge_of(problem)); }
};

CornerCase wedge(std::string name, ContactProblem problem, std::optional<ContactProblem> other = {}) {
  return {std::move(name), Examined::wedge, std::move(problem), 0, std::move(other)};
}

CornerCase notch(std::string name, FrictionProfile f, const Polynomial& left, const Rational& load, int trend) {
  return {std::move(name), Examined::notch, flanks(std::move(f), left, Polynomial({0, 0, 1}), load), trend};
}

/// Returns the cases. Wedges: the same change of slope (1/3) - (-1) for f = 2 in problems with otherwise different
/// data, and wedges without friction. Notches: change of slope 0 - 1; for rising friction 0 - 1/8, small enough to
/// close under the load.
CaseList<CornerCase> corners(const Context& context) {
  const Rational third(1, 3);
  const Polynomial steep({0, 1, 1});
  const Polynomial blunt({0, Rational(1, 8), 1});
  const FrictionProfile two({2});
  const FrictionProfile none({0});
  const ContactProblem first = flanks(two, Polynomial({0, -1, 1}), Polynomial({0, third, 2}), 6);
  return first_when_quick<CornerCase>(
      context,
      {wedge("free ends", first),
       wedge("twice the load, other flanks, turned, friction jumps on both sides",
             flanks(FrictionProfile({Rational(1, 2), 2, 0}, {Rational(-1, 4), Rational(3, 8)}),
                    Polynomial({0, Rational(-3, 4), 2, Rational(1, 2)}), Polynomial({0, Rational(7, 12), 1}), 12),
             first),
       notch("notch", two, steep, 4, 0),
       notch("notch, f rises", FrictionProfile({third, 3}, {corner}), blunt, 12, 1),
       wedge("edges", {Elasticity(Solid(Rational(3, 10), 1)), two,
                       Indenter(-1, {{corner, Polynomial({0, -1})}, {1, Polynomial({Rational(-1, 6), third})}}), 20}),
       wedge("without friction", flanks(none, Polynomial({0, -third, 1, -third}), Polynomial({0, 1, 1}), 6)),
       wedge("without friction, twice the load", flanks(none, Polynomial({0, -third, 3}), Polynomial({0, 1, 2}), 12)),
       notch("notch, three times the load", two, steep, 12, 0),
       notch("notch without friction", none, steep, 4, 0),
       notch("notch, f falls", FrictionProfile({3, third}, {corner}), steep, 4, -1),
       {"on 8192 cells", Examined::on_cells, cell_case("wedge")}},
      4, "solved problems with a wedge or a re-entrant corner");
}

double coefficient_on_cells(const ContactProblem& problem) {
  const auto solution = solve_on_cells(problem, 8192);
  for (const auto& point : solution->singular_points()) {
    if (point.kind == SingularKind::wedge) return point.intensity.value;
  }
  throw Refutation{{"on cells", "no wedge found"}};
}

template <Real R>
R left_end(const Solved<R>& solution) {
  return solution->contact().front().left.intensity.value;
}

template <Real R>
Values at_wedge(const CornerCase& c) {
  const Solved<R> solution = solve<R>(c.problem);
  const std::size_t j = point_at(*solution, corner);
  const R d = asymptotic_distance<R>();
  const R step = traction_beside(*solution, j, Side::right, d) - traction_beside(*solution, j, Side::left, d);
  Values found{{"left", logarithm_beside(*solution, j, Side::left)},
               {"right", logarithm_beside(*solution, j, Side::right)},
               {"step", Number(Number(step) / c.wedge())}};
  if (c.other && relative_difference<R>(left_end<R>(solution), left_end<R>(solve<R>(*c.other))) < 0.01) {
    throw Refutation{{c.name, "the intensity at the left end is the same in another problem"}};
  }
  return found;
}

}  // namespace

Claim claim() {
  return compared<CornerCase>("thm-02-remarks-wedge")
      .cases(corners)
      .effective_where([](const CornerCase& c) { return c.examined != Examined::wedge || c.s() != 0; })
      .precision(Precision::quick_in_double)
      .measured([]<Real R>(const CornerCase& c) -> Values {
        if (c.examined == Examined::wedge) return at_wedge<R>(c);
        if (c.examined == Examined::on_cells) return {{"on cells", coefficient_on_cells(c.problem)}};
        const Solved<R> solution = solve<R>(c.problem);
        const std::size_t j = point_at(*solution, corner);
        const bool inside = in_contact(*solution, j, Side::left) && in_contact(*solution, j, Side::right);
        return {{"inside", Number(inside ? 1 : 0)}};
      })
      .predicted([](const CornerCase& c) -> Values {
        if (c.examined == Examined::notch) return {{"inside", Number(c.trend > 0 ? 1 : 0)}};
        const auto s = to_real<Number>(c.s());
        const Number coefficient = c.wedge() / (1 + s * s);
        if (c.examined == Examined::on_cells) return {{"on cells", coefficient}};
        return {{"left", coefficient}, {"right", coefficient}, {"step", Number(s / (1 + s * s))}};
      })
      .wrong("a coefficient that grows with the load",
             scaled({"left", "right"}, [](const CornerCase& c) { return to_real<Number>(c.problem.load() / 6); }))
      .wrong("`1/(1+s^2)` missing",
             scaled({"left", "right", "step"}, [](const CornerCase& c) { return to_real<Number>(1 + c.s() * c.s()); }))
      .wrong("the logarithm's sign", scaled({"left", "right"}, -1))
      .wrong("`1/pi` missing", scaled({"left", "right"}, numeric::pi<Number>()))
      .wrong("the step's sign: `H(c-x)`", scaled({"step"}, -1))
      .wrong("a re-entrant corner excluded where `f` rises as well", scaled({"inside"}, 0))
      .wrong("a re-entrant corner admitted where `f` does not jump",
             [](Values& p, const CornerCase& c) { p.set("inside", Number(c.trend >= 0 ? 1 : 0)); })
      .near_misses();
}

}  // namespace steadyslide::proofs_checks::thm_02_remarks_wedge
