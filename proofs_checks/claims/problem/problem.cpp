// The contact problem: its equation from those of the surface, its conditions, and what leaves it unchanged.
// [Bal16, (2), (3)]

#include <algorithm>
#include <memory>

#include "numeric/cauchy/sliding_operator.hpp"
#include "proofs_checks/claims/claims.hpp"
#include "proofs_checks/claims/problem/problem_parts.hpp"
#include "proofs_checks/instruments/half_plane_field.hpp"
#include "proofs_checks/instruments/power_form.hpp"
#include "proofs_checks/kit/findings.hpp"
#include "proofs_checks/kit/random.hpp"

namespace steadyslide::proofs_checks {
namespace {

/// A traction under friction with jumps; the profile says nothing.
struct Sheared {
  ContactProblem problem;
  PiecewiseTraction normal;
};

/// s on each piece: u_bar_n' = H t_n + s t_n.
struct ReductionSaid {
  std::function<Rational(const ContactProblem&, std::size_t piece)> s;
  double miss = 0;  ///< added to s
};

Sheared random_case(Random& random, std::size_t k) {
  const std::vector<std::vector<Rational>> jumps{{Rational(1, 9)}, {}, {Rational(-1, 3), Rational(2, 7)}};
  const std::vector<Rational>& c = jumps[k % jumps.size()];
  std::vector<Rational> f;
  for (std::size_t i = 0; i <= c.size(); ++i) f.push_back(random.between(Rational(1, 10), 3));
  PiecewiseTraction normal;
  Rational from = -1;
  std::vector<Rational> coefficients;
  for (std::size_t i = 0; i <= 3; ++i) coefficients.push_back(random.between(-1, 1));
  for (std::size_t i = 0; i <= c.size(); ++i) {
    const Rational to = i < c.size() ? c[i] : Rational(1);
    normal.push_back({from, to, Polynomial(coefficients)});
    from = to;
  }
  return {ContactProblem(Elasticity(Solid(random.poisson(), random.between(Rational(1, 2), 3))), FrictionProfile(f, c),
                         Indenter(-1, {{1, Polynomial()}}), 1, k % 2 == 0 ? Sliding::minus_x : Sliding::plus_x),
          normal};
}

/// The component along +x of what the indenter exerts on the body: friction drags the body along.
std::vector<Rational> shear_ratios(const ContactProblem& problem) {
  std::vector<Rational> ratios;
  for (std::size_t k = 0; k < problem.friction().values().size(); ++k) ratios.push_back(problem.shear_ratio(k));
  return ratios;
}

std::vector<Evidence> check(const Context& context, const ReductionSaid& said, GaussRules& rules) {
  const auto walk = [&]<Real R>() -> std::vector<Evidence> {
    using std::abs;
    if constexpr (std::same_as<R, double>) {
      return {};
    } else {
      const Quantity equation{"u_bar_n'", {"H t_n + s t_n", "strains of the body under both tractions"}, 1e-45};
      Random random(context.seed, "eq-02-03");
      Findings findings;
      const std::size_t count = context.quick ? 1 : 12;
      for (std::size_t k = 0; k < count; ++k) {
        const Sheared c = random_case(random, k);
        const ContactProblem& problem = c.problem;
        findings.begin_case("case " + std::to_string(k), problem.elasticity().gamma() != 0);
        const std::vector<Rational> ratios = shear_ratios(problem);
        for (std::size_t i = 0; i < ratios.size() && said.miss == 0; ++i) {
          findings.decide("-gamma t_t = s t_n", -problem.elasticity().gamma() * ratios[i] == said.s(problem, i));
        }
        const HalfPlaneField<R> field(*problem.elasticity().half_space(), c.normal, scaled_pieces(c.normal, ratios),
                                      rules);
        const numeric::trapezoidal::Grid<R> grid(density_of<R>(c.normal));
        std::vector<R> s;
        for (std::size_t i = 0; i < ratios.size(); ++i) {
          s.push_back(numeric::to_real<R>(said.s(problem, i)) + R(said.miss));
        }
        const numeric::SlidingOperator<R> A(grid, s);
        for (std::size_t i = 0; i < ratios.size(); ++i) {
          const numeric::PanelPoint<R> at = grid.midpoint_near(i, R(1) / 2);
          const numeric::SlidingTerms<R> terms = A.at(at);
          const R slope = field.normal_slope(at.node.x) / numeric::to_real<R>(problem.elasticity().compliance());
          const R scale = abs(terms.hilbert.value) + abs(terms.traction);
          findings.compare(equation, static_cast<double>(R(abs(terms.sum().value - slope) / scale)));
        }
      }
      return findings.evidence("random polynomials, frictions with up to two jumps, sliding both ways, seed " +
                               std::to_string(context.seed));
    }
  };
  return gather([&] { return numeric::at_precision(std::max(context.digits, numeric::Digits::fifty), walk); });
}

Claim reduction_claim() {
  const auto right = [](const ContactProblem& p, std::size_t i) { return p.coupled_friction(i); };
  const auto wrong = [](std::string name, auto s) { return Wrong<ReductionSaid>{std::move(name), {s, 0}}; };
  return make_claim(
      claim_text("eq-02-03-reduction"),
      [rules = std::make_shared<GaussRules>()](const Context& context, const ReductionSaid& said) {
        return check(context, said, *rules);
      },
      ReductionSaid{right},
      std::vector<Wrong<ReductionSaid>>{
          wrong("s = -gamma f",
                [](const ContactProblem& p, std::size_t i) { return Rational(-p.coupled_friction(i)); }),
          wrong("gamma missing", [](const ContactProblem& p, std::size_t i) { return p.friction().values()[i]; }),
          wrong("the direction of sliding forgotten",
                [](const ContactProblem& p, std::size_t i) {
                  return Rational(p.elasticity().gamma() * p.friction().values()[i]);
                }),
          wrong("f taken from the other end",
                [](const ContactProblem& p, std::size_t i) {
                  return p.coupled_friction(p.friction().values().size() - 1 - i);
                }),
          {"near miss: s moved by a hundred times the tolerance", {right, 1e-43}}});
}

}  // namespace

std::vector<Claim> problem_claims() {
  std::vector<Claim> claims{reduction_claim()};
  claims.push_back(complementarity_claim());
  return claims;
}

}  // namespace steadyslide::proofs_checks
