// Problems I and I0 have the same solution, t_n = L(u_n). [Bal16, proposition 7]

#include <cmath>
#include <map>
#include <memory>

#include "numeric/number/polynomial.hpp"
#include "numeric/riemann_hilbert/riemann_hilbert.hpp"
#include "numeric/riemann_hilbert/riemann_hilbert_solution.hpp"
#include "proofs_checks/claims/section_3/dual_problem_parts.hpp"
#include "proofs_checks/instruments/dual_study.hpp"
#include "proofs_checks/instruments/power_form.hpp"
#include "proofs_checks/kit/findings.hpp"

namespace steadyslide::proofs_checks {
namespace {

struct LinkSaid {
  DisplacementSaid displacement;
  int cells_friction = 1;  ///< its sign, in problem I0
  double load_moved = 0;   ///< in problem I, in tolerances
};

/// Full contact, where u_n = psi is a polynomial: forces of problem I at its nodes against the Riemann-Hilbert
/// traction.
template <Real R>
void check_full_contact(Findings& findings, const Context& context, const LinkSaid& said) {
  const Quantity forces{"P t_0 - L(psi) in full contact", {"(10) at the nodes", "Riemann-Hilbert"}, tolerance<R>()};
  Random random(context.seed, "prop-07-problems-linked");
  for (int k = 0; k < (context.quick ? 1 : 4); ++k) {
    const Rational s = random.between(Rational(1, 4), 2) * (k % 2 == 0 ? 1 : -1);
    const Rational cubic = context.quick ? Rational(0) : random.between(Rational(-1, 100), Rational(1, 100));
    const Polynomial profile(
        {0, random.between(Rational(-1, 50), Rational(1, 50)), random.between(0, Rational(1, 30)), cubic});
    const ContactProblem problem = cell_problem({{s}, {}}, profile);
    findings.begin_case("s = " + to_string(s) + ", " + to_string(profile));
    const auto attempt = numeric::riemann_hilbert<R>(problem);
    const auto* solution = dynamic_cast<const numeric::RiemannHilbertSolution<R>*>(attempt.solution.get());
    findings.require(solution && solution->shortcoming().empty() && solution->form().set().segments() == 1,
                     "not in full contact");
    const R unit = numeric::to_real<R>(solution->problem().frame().unit);
    const R origin = numeric::to_real<R>(solution->problem().frame().origin);
    const DisplacementOperator<R> a(s, profile.degree() + 1, said.displacement.inverse);
    std::vector<R> psi;
    for (std::size_t i = 0; i < a.size(); ++i) {
      psi.push_back(R(said.displacement.profile) * numeric::value_of(profile, a.node(i).x));
    }
    const std::vector<R> bent = a.forces(psi);
    const Exponent angle = Exponent::angle(s);
    const R load = R(said.displacement.load) * (1 + R(said.load_moved) * R(tolerance<R>()));
    for (std::size_t i = 0; i < a.size(); ++i) {
      using std::pow;
      const numeric::Node<R>& node = a.node(i);
      const R t = solution->form()
                      .traction({0, {R((node.x - origin) / unit), R(node.from_left / unit), R(node.from_right / unit)}})
                      .value;
      const R t0 = numeric::cos_pi_alpha<R>(s) / numeric::pi<R>() *
                   pow(node.from_left, numeric::to_real<R>(-(half + angle))) *
                   pow(node.from_right, numeric::to_real<R>(-(half - angle)));
      findings.compare(forces, relative_difference<R>(load * a.tau(i) - bent[i], -t * a.tau(i) / t0));
    }
  }
}

/// Moments found once for a claim and its controls.
class Solved {
 public:
  const Moments& exact(std::size_t k) {
    Moments& moments = exact_[k];
    if (moments.empty()) moments = riemann_hilbert_moments(dual_cases()[k].problem());
    return moments;
  }
  const Moments& cells(std::size_t k, int n, int friction) {
    Moments& moments = cells_[{k, n, friction}];
    if (moments.empty()) moments = cell_moments(dual_cases()[k].problem(friction), static_cast<std::size_t>(n));
    return moments;
  }
  const Moments& polynomials(std::size_t k, int n) {
    Moments& moments = polynomials_[{k, n}];
    if (moments.empty()) moments = displacement_moments(dual_cases()[k], n);
    return moments;
  }

 private:
  std::map<std::size_t, Moments> exact_;
  std::map<std::tuple<std::size_t, int, int>, Moments> cells_;
  std::map<std::pair<std::size_t, int>, Moments> polynomials_;
};

void check_convergence(Findings& findings, Solved& solved, const Context& context, const LinkSaid& said) {
  const DisplacementSaid& d = said.displacement;
  const bool right = d.load == 1 && d.profile == 1 && !d.other_angle && d.inverse.friction == 1 && !d.inverse.printed;
  const std::vector<DualCase> cases = dual_cases();
  const std::vector<int> first = context.quick ? std::vector<int>{12, 24, 36} : std::vector<int>{16, 32, 64, 128};
  const int meshes = context.quick ? 7 : 14;
  const double tolerance = context.quick ? 0.35 : 0.2;
  for (std::size_t k = 0; k < (context.quick ? 2 : cases.size()); ++k) {
    const DualCase& c = cases[k];
    findings.begin_case(c.name);
    const auto load = numeric::to_real<double>(c.load);
    std::map<int, Moments> wrong;
    const auto polynomials = [&](int n) -> const Moments& {
      if (right) return solved.polynomials(k, n);
      Moments& moments = wrong[n];
      if (moments.empty()) moments = displacement_moments(c, n, said.displacement);
      return moments;
    };
    const auto measure = [&](const std::string& what, const std::vector<Level>& levels, double expected) {
      const Rate rate = fitted_rate(levels);
      findings.measure({what + ", " + c.name, rate.value, rate.error_bar, expected, tolerance,
                        "difference " + short_text(levels.back().error) + " at the last level"});
    };
    measure("L(u_n) of problem I to the Riemann-Hilbert solution",
            levels_of(first, meshes, solved.exact(k), load, polynomials), 2);
    // Four cells to a node: neither error is the other's.
    std::vector<Level> levels;
    for (const int n : first) {
      std::vector<double> errors;
      for (int j = 0; j < meshes; ++j) {
        errors.push_back(distance(polynomials(n + j), solved.cells(k, 4 * (n + j), said.cells_friction), load));
      }
      levels.push_back({n + (meshes - 1) / 2.0, root_mean_square(errors)});
    }
    measure("L(u_n) of problem I to t_n of problem I0", levels, c.cells_rate);
  }
}

}  // namespace

Claim linked_problems_claim() {
  using S = LinkSaid;
  const auto check = [solved = std::make_shared<Solved>()](const Context& context, const S& said) {
    const auto walk = [&]<Real R>() {
      Findings findings;
      // Principal values at 50 digits take a tenth of a second.
      if (context.quick) {
        check_full_contact<double>(findings, context, said);
      } else {
        check_full_contact<R>(findings, context, said);
      }
      check_convergence(findings, *solved, context, said);
      return findings.evidence("random s of both signs and profiles, seed " + std::to_string(context.seed));
    };
    return gather([&] { return numeric::at_precision(context.digits, walk); });
  };
  const auto in_form = [](auto change) { return changed<S>([&](S& said) { change(said.displacement); }); };
  return make_claim(
      claim_text("prop-07-problems-linked"), check, S(),
      std::vector<Wrong<S>>{
          {"problem I with the friction's sign reversed",
           in_form([](DisplacementSaid& said) { said.inverse.friction = -1; })},
          {"problem I0 with the friction's sign reversed", changed<S>([](S& said) { said.cells_friction = -1; })},
          {"L with the printed (1+x)^{1/2}", in_form([](DisplacementSaid& said) { said.inverse.printed = true; })},
          {"the t_0 of -alpha in phi", in_form([](DisplacementSaid& said) { said.other_angle = true; })},
          {"-psi instead of psi", in_form([](DisplacementSaid& said) { said.profile = -1; })},
          {"twice the load in problem I", in_form([](DisplacementSaid& said) { said.load = 2; })},
          {"near miss: the load of problem I moved by ten times the tolerance",
           changed<S>([](S& said) { said.load_moved = 10; })}});
}

}  // namespace steadyslide::proofs_checks
