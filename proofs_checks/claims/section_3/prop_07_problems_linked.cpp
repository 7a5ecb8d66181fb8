#include <variant>

#include "proofs_checks/instruments/operators/moment_comparison.hpp"
#include "proofs_checks/instruments/solutions/local_behaviour.hpp"
#include "proofs_checks/kit/claim_builder.hpp"

namespace steadyslide::proofs_checks::prop_07_problems_linked {
namespace {

/// A polynomial displacement u_n = psi.
struct FullContact {
  Rational s;
  Polynomial profile;
};
struct Case {
  std::string name;
  std::variant<FullContact, DualCase> data;
};

CaseList<Case> cases(const Context& context) {
  Random random(context.seed, "prop-07-problems-linked");
  CaseList<Case> list{{}, "random `s` of both signs and profiles, seed " + std::to_string(context.seed)};
  for (int k = 0; k < (context.quick ? 1 : 4); ++k) {
    const Rational s = random.between(Rational(1, 4), 2) * (k % 2 == 0 ? 1 : -1);
    const Rational cubic = context.quick ? Rational(0) : random.between(Rational(-1, 100), Rational(1, 100));
    const Polynomial profile(
        {0, random.between(Rational(-1, 50), Rational(1, 50)), random.between(0, Rational(1, 30)), cubic});
    list.cases.push_back({"s = " + to_string(s) + ", " + to_string(profile), FullContact{s, profile}});
  }
  for (const DualCase& dual : dual_cases(context)) list.cases.push_back({dual.name, dual});
  return list;
}

/// The two problems, or a wrong variant of their relation.
struct Link {
  DisplacementFormula displacement = {};
  int cells_friction = 1;  ///< sign of the friction in problem I0
  Number load = 1;         ///< factor of the load in problem I

  bool has_right_displacement() const { return displacement == DisplacementFormula(); }
};

/// Compares the forces of problem I at its nodes with the Riemann-Hilbert traction.
template <Real R>
void check_full_contact(Findings& findings, const Link& link, const FullContact& c) {
  using std::pow;
  const auto solution = solve<R>(cell_problem({{c.s}, {}}, c.profile));
  findings.require(solution->form().set().segments() == 1, "not in full contact");
  const R unit = to_real<R>(solution->problem().frame().unit);
  const R origin = to_real<R>(solution->problem().frame().origin);
  const DisplacementOperator<R> a(c.s, c.profile.degree() + 1, link.displacement.inverse);
  std::vector<R> psi;
  for (std::size_t i = 0; i < a.size(); ++i) {
    psi.push_back(R(link.displacement.profile) * value_of(c.profile, a.node(i).x));
  }
  const std::vector<R> bent = a.forces(psi);
  const Exponent angle = Exponent::angle(c.s);
  const R load = R(link.displacement.load) * R(link.load);
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Node<R>& node = a.node(i);
    const R t = solution->form()
                    .traction({0, {R((node.x - origin) / unit), R(node.from_left / unit), R(node.from_right / unit)}})
                    .value;
    const R t0 = cos_pi_alpha<R>(c.s) / numeric::pi<R>() * pow(node.from_left, to_real<R>(-(half + angle))) *
                 pow(node.from_right, to_real<R>(-(half - angle)));
    findings.compare<R>("forces", load * a.tau(i) - bent[i], -t * a.tau(i) / t0);
  }
}

void check_convergence(Findings& findings, KnownMoments& known, const Link& link, const DualCase& c, bool quick) {
  const std::vector<int> first = quick ? std::vector<int>{12, 24, 36} : std::vector<int>{16, 32, 64, 128};
  const int meshes = quick ? 7 : 14;
  const auto load = to_real<double>(c.load);
  std::map<int, Moments> wrong;
  const auto polynomials = [&](int n) -> const Moments& {
    if (link.has_right_displacement()) return known.polynomials(c, n);
    Moments& moments = wrong[n];
    if (moments.empty()) moments = displacement_moments(c, n, link.displacement);
    return moments;
  };
  const auto measure = [&](const std::string& what, const std::vector<Level>& levels, double expected) {
    const Rate rate = fitted_rate(levels);
    findings.measure({what + ", " + c.name, rate.value, rate.error_bar, expected, quick ? 0.35 : 0.2,
                      "difference " + short_text(levels.back().error) + " at the last level"});
  };
  const auto exact = [&](int) -> const Moments& { return known.exact(c); };
  // Four cells for each node, so that the errors of the two methods are unrelated.
  const auto cells = [&](int n) -> const Moments& { return known.cells(c, 4 * n, link.cells_friction); };
  measure("`L(u_n)` of problem I to the Riemann-Hilbert solution", levels_of(first, meshes, load, polynomials, exact),
          2);
  measure("`L(u_n)` of problem I to `t_n` of problem `I0`", levels_of(first, meshes, load, polynomials, cells),
          c.cells_rate);
}

}  // namespace

Claim claim() {
  return formula_claim<Case, Link>("prop-07-problems-linked")
      .cases(cases)
      // A principal value at 50 digits takes a tenth of a second.
      .precision(Precision::quick_in_double)
      .checked([known = std::make_shared<KnownMoments>()]<Real R>(Findings& findings, const Link& link, const Case& c,
                                                                  const Context& context) {
        if (const auto* full = std::get_if<FullContact>(&c.data)) {
          check_full_contact<R>(findings, link, *full);
        } else {
          check_convergence(findings, *known, link, std::get<DualCase>(c.data), context.quick);
        }
      })
      .wrong("problem I with the friction's sign reversed", [](Link& link) { link.displacement.inverse.friction = -1; })
      .wrong("problem `I0` with the friction's sign reversed", &Link::cells_friction, -1)
      .wrong("`L` with the printed `(1+x)^{1/2}`", [](Link& link) { link.displacement.inverse.printed = true; })
      .wrong("the `t_0` of `-alpha` in `phi`", [](Link& link) { link.displacement.other_angle = true; })
      .wrong("`-psi` instead of `psi`", [](Link& link) { link.displacement.profile = -1; })
      .wrong("twice the load in problem I", [](Link& link) { link.displacement.load = 2; })
      .near_miss("the load of problem I", [](Link& link, const Number& step) { link.load += step; });
}

}  // namespace steadyslide::proofs_checks::prop_07_problems_linked
