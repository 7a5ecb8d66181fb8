#include <algorithm>

#include "numeric/cauchy/sliding_operator.hpp"
#include "proofs_checks/instruments/operators/half_plane_field.hpp"
#include "proofs_checks/instruments/tractions/punch.hpp"
#include "proofs_checks/instruments/tractions/surface.hpp"
#include "proofs_checks/kit/claim_builder.hpp"

namespace steadyslide::proofs_checks::eq_02_03_reduction {
namespace {

/// A traction under friction with jumps. The profile is not used.
struct Sheared {
  ContactProblem problem;
  Polynomial normal;
};

std::string text_of(const Sheared& c) { return proofs_checks::text_of(c.problem) + ", t_n = " + to_string(c.normal); }

Sheared random_case(Random& random, std::size_t k) {
  const std::vector<std::vector<Rational>> jumps{{Rational(1, 9)}, {}, {Rational(-1, 3), Rational(2, 7)}};
  const std::vector<Rational>& c = jumps[k % jumps.size()];
  const std::vector<Rational> f = random.between(Rational(1, 10), 3, c.size() + 1);
  const Polynomial normal(random.between(-1, 1, 4));
  const Rational young = random.between(Rational(1, 2), 3);
  return {ContactProblem(Elasticity(Solid(random.poisson(), young)), FrictionProfile(f, c),
                         Indenter(-1, {{1, Polynomial()}}), 1, k % 2 == 0 ? Sliding::minus_x : Sliding::plus_x),
          normal};
}

CaseList<Sheared> cases(const Context& context) {
  return random_cases(context, "eq-02-03", 12, 1,
                      "random polynomials, frictions with up to two jumps, sliding both ways", random_case);
}

/// The values of s on the pieces, in u_bar_n' = H t_n + s t_n.
using PiecewiseS = std::vector<Rational>;

template <Real R>
void check_reduction(Findings& findings, const PiecewiseS& s, const Sheared& c) {
  using std::abs;
  const Elasticity& elasticity = c.problem.elasticity();
  PiecewiseTraction normal, tangential;
  std::vector<R> said;
  for (const auto& [left, right, friction, profile] : c.problem.pieces()) {
    // The component along +x of the traction that the indenter exerts on the body: friction drags the body along.
    const Rational ratio = c.problem.shear_ratio(friction);
    normal.push_back({left, right, c.normal});
    tangential.push_back({left, right, Polynomial::constant(ratio) * c.normal});
    said.push_back(to_real<R>(s[friction]));
  }
  const HalfPlaneField<R> field(*elasticity.half_space(), normal, tangential);
  const trapezoidal::Grid<R> grid(density_of<R>(normal));
  const numeric::SlidingOperator<R> A(grid, said);
  for (std::size_t i = 0; i < s.size(); ++i) {
    const PanelPoint<R> at = grid.midpoint_near(i, R(1) / 2);
    const numeric::SlidingTerms<R> terms = A.at(at);
    const R slope = field.normal_slope(at.node.x) / to_real<R>(elasticity.compliance());
    const R size = abs(terms.hilbert.value) + abs(terms.traction);
    findings.compare("equation", R(abs(terms.sum().value - slope) / size));
  }
  for (std::size_t i = 0; i < s.size(); ++i) {
    findings.decide("`-gamma t_t = s t_n`", -elasticity.gamma() * c.problem.shear_ratio(i) == s[i]);
    findings.decide("`s` is the model's", c.problem.coupled_friction(i) == s[i]);
  }
}

}  // namespace

Claim claim() {
  return formula_claim<Sheared, PiecewiseS>("eq-02-03-reduction")
      .cases(cases)
      .effective_where([](const Sheared& c) { return c.problem.elasticity().gamma() != 0; })
      .precision(Precision::at_least_fifty)
      .says([](const Sheared& c) {
        PiecewiseS s;
        for (const auto& piece : c.problem.pieces()) s.push_back(s_of(c.problem, piece.friction));
        return s;
      })
      .checked([]<Real R>(auto&... of) { check_reduction<R>(of...); })
      .wrong("`s = -gamma f`", [](PiecewiseS& s) { std::ranges::for_each(s, [](Rational& value) { value = -value; }); })
      .wrong("`gamma` missing", [](PiecewiseS& s, const Sheared& c) { s = c.problem.friction().values(); })
      .wrong("the direction of sliding forgotten",
             [](PiecewiseS& s) { std::ranges::for_each(s, [](Rational& value) { value = abs(value); }); })
      .wrong("`f` taken from the other end", [](PiecewiseS& s) { std::ranges::reverse(s); })
      .wrong("near miss: `s` moved by a hundred times the tolerance", [](PiecewiseS& s) {
        std::ranges::for_each(s, [](Rational& value) { value += parse_rational("1e-43"); });
      });
}

}  // namespace steadyslide::proofs_checks::eq_02_03_reduction
