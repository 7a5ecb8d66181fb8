// The complete solution under constant friction. [Bal16, theorem 8]

#include <cmath>
#include <map>
#include <memory>
#include <tuple>

#include "numeric/closed_form/closed_form.hpp"
#include "proofs_checks/claims/section_3/dual_problem_parts.hpp"
#include "proofs_checks/instruments/cells.hpp"
#include "proofs_checks/instruments/near.hpp"
#include "proofs_checks/kit/findings.hpp"

namespace steadyslide::proofs_checks {
namespace {

using numeric::ContactSolution;
using numeric::Real;

struct HomogeneousSaid {
  int friction = 1;   ///< its sign, for the second solver
  int load = 1;       ///< factor, for the second solver
  Polynomial added;   ///< to psi, besides the constant
  double moved = 0;   ///< the load of the second solver, in tolerances
  int profile = 1;    ///< factor of psi, for the second solver
  bool equal = true;  ///< u_n and psi + C: the gap stays, else it is said to grow by C
};

struct Case {
  Rational s;
  Polynomial profile;
  Rational load;
};

/// Parabolas with free ends and flat punches, which have closed forms, then edges at the rear and at the front.
std::vector<Case> cases(const Context& context) {
  Random random(context.seed, "thm-08-homogeneous");
  std::vector<Case> all;
  const int quick = context.digits == numeric::Digits::sixteen ? 4 : 1;
  for (int k = 0; k < (context.quick ? quick : 8); ++k) {
    const Rational s = random.between(Rational(1, 5), 1) * ((k % 4 < 2) == (k < 4) ? 1 : -1);
    const Rational load = random.between(Rational(1, 5), Rational(1, 2));
    switch (k % 4) {
      case 0:
      case 2: all.push_back({s, Polynomial({0, 0, random.between(1, 2)}), load}); break;
      case 1:
        all.push_back({s, Polynomial({0, random.between(Rational(1, 4), Rational(1, 2)), Rational(1, 4)}), load});
        break;
      default: all.push_back({s, Polynomial(), load});
    }
  }
  return all;
}

/// Ends, traction and gap at some places.
template <Real R>
void compare(Findings& findings, const Quantity& quantity, const ContactSolution<R>& a, const ContactSolution<R>& b,
             const R& load, const R& raised = 0) {
  using std::abs;
  const auto error = [&](const R& x, const R& y, const R& scale) { return static_cast<double>(R(abs(x - y) / scale)); };
  const auto ends = a.contact();
  const auto other_ends = b.contact();
  findings.require(ends.size() == other_ends.size(), "other components of contact");
  for (std::size_t k = 0; k < ends.size(); ++k) {
    findings.compare(quantity, error(ends[k].left.x.value, other_ends[k].left.x.value, R(1)));
    findings.compare(quantity, error(ends[k].right.x.value, other_ends[k].right.x.value, R(1)));
  }
  for (const Rational& x : {Rational(-19, 20), Rational(-2, 5), Rational(-1, 20), Rational(3, 10), Rational(9, 10)}) {
    const auto here = a.at(x);
    const auto there = b.at(x);
    findings.compare(quantity, error(here.traction.left.value, there.traction.left.value, load));
    if (here.gap && there.gap) {
      findings.compare(quantity, error(R(here.gap->value + raised), there.gap->value, load));
    }
  }
}

/// Residuals take longer than solutions: found once for the claim and its controls.
template <class R>
using KnownResiduals = std::map<std::string, numeric::Residuals<R>>;
using AllKnownResiduals =
    std::tuple<KnownResiduals<double>, KnownResiduals<numeric::Real50>, KnownResiduals<numeric::Real100>>;

std::vector<Evidence> check(const Context& context, const HomogeneousSaid& said, AllKnownResiduals& all_known) {
  const auto walk = [&]<Real R>() {
    auto& known = std::get<KnownResiduals<R>>(all_known);
    // Residuals come from rules that lose a digit or two.
    const Quantity residual{"equation, load, penetration and tension", {"unrelated rule", "zero"}, tolerance<R>()};
    const Quantity solvers{"ends, traction and gap", {"Riemann-Hilbert", "closed form"}, tolerance<R>(), 0.4};
    const Quantity shifted{"ends, traction and gap, psi + C", {"psi", "psi + C"}, tolerance<R>()};
    Findings findings;
    for (const Case& c : cases(context)) {
      const std::string name =
          "s = " + to_string(c.s) + ", psi = " + to_string(c.profile) + ", P = " + to_string(c.load);
      findings.begin_case(name);
      const R load = numeric::to_real<R>(c.load);
      const auto solution = solve<R>(cell_problem({{c.s}, {}}, c.profile, c.load));
      if (!known.contains(name)) known.emplace(name, solution->residuals());
      const numeric::Residuals<R>& left = known.at(name);
      for (const R& value : {left.equation, left.load, left.penetration, left.tension}) {
        findings.compare(residual, static_cast<double>(value));
      }
      const Polynomial factor = Polynomial::constant(said.profile);
      const Rational near(static_cast<long>(said.moved));
      // The tolerance as a power of ten.
      const Rational unit = parse_rational("1e" + std::to_string(std::lround(std::log10(tolerance<R>()))));
      const auto closed = numeric::closed_form<R>(cell_problem({{said.friction * c.s}, {}}, factor * c.profile,
                                                               c.load * Rational(said.load) * (1 + near * unit)));
      if (closed.solution) {
        compare<R>(findings, solvers, *solution, *closed.solution, load);
      } else {
        findings.skip(solvers);
      }
      const Rational constant(17, 5);
      const auto raised =
          solve<R>(cell_problem({{c.s}, {}}, c.profile + Polynomial::constant(constant) + said.added, c.load));
      compare<R>(findings, shifted, *solution, *raised, load, said.equal ? R(0) : numeric::to_real<R>(constant));
    }
    return findings.evidence("random s of both signs, profiles and loads, seed " + std::to_string(context.seed));
  };
  return gather([&] { return numeric::at_precision(context.digits, walk); });
}

}  // namespace

Claim homogeneous_friction_claim() {
  using S = HomogeneousSaid;
  const auto examine = [known = std::make_shared<AllKnownResiduals>()](const Context& context, const S& said) {
    return check(context, said, *known);
  };
  return make_claim(
      claim_text("thm-08-homogeneous"), examine, S(),
      std::vector<Wrong<S>>{
          {"the second solver with the friction's sign reversed", changed<S>([](S& said) { said.friction = -1; })},
          {"the second solver with twice the load", changed<S>([](S& said) { said.load = 2; })},
          {"the second solver with twice the profile", changed<S>([](S& said) { said.profile = 2; })},
          {"psi + C + x/10 instead of psi + C", changed<S>([](S& said) {
             said.added = Polynomial({0, Rational(1, 10)});
           })},
          {"psi + C and u_n, not u_n + C", changed<S>([](S& said) { said.equal = false; })},
          {"near miss: the second solver's load moved by ten times the tolerance",
           changed<S>([](S& said) { said.moved = 10; })}});
}

}  // namespace steadyslide::proofs_checks
