#include "numeric/closed_form/closed_form.hpp"
#include "proofs_checks/instruments/cells/cells.hpp"
#include "proofs_checks/instruments/solutions/local_behaviour.hpp"
#include "proofs_checks/instruments/solutions/trial.hpp"
#include "proofs_checks/kit/claim_builder.hpp"

namespace steadyslide::proofs_checks::thm_08_homogeneous {
namespace {

using numeric::ContactSolution;

struct Homogeneous {
  Rational s;
  Polynomial profile;
  Rational load;

  ContactProblem problem() const { return cell_problem({{s}, {}}, profile, load); }
};

std::string text_of(const Homogeneous& c) {
  return "s = " + to_string(c.s) + ", psi = " + to_string(c.profile) + ", P = " + to_string(c.load);
}

/// Returns parabolas with free ends and flat punches, which have closed forms, and profiles with an edge at the rear or
/// at the front.
CaseList<Homogeneous> cases(const Context& context) {
  const auto make = [](Random& random, std::size_t k) {
    const Rational s = random.between(Rational(1, 5), 1) * ((k % 4 < 2) == (k < 4) ? 1 : -1);
    const Rational load = random.between(Rational(1, 5), Rational(1, 2));
    Polynomial profile;
    if (k % 4 == 1) {
      profile = Polynomial({0, random.between(Rational(1, 4), Rational(1, 2)), Rational(1, 4)});
    } else if (k % 2 == 0) {
      profile = Polynomial({0, 0, random.between(1, 2)});
    }
    return Homogeneous{s, profile, load};
  };
  return random_cases(context, "thm-08-homogeneous", 8, context.digits == numeric::Digits::sixteen ? 4 : 1,
                      "random `s` of both signs, profiles and loads", make);
}

/// Problems with the same solution: the problem for the closed form, and the problem with psi + C, in which the gap is
/// larger by `opened`.
struct SameSolution {
  Homogeneous closed;
  Homogeneous raised;
  Rational opened = 0;
};

const Rational constant(17, 5);

SameSolution same_solution(const Homogeneous& c) {
  return {c, {c.s, c.profile + Polynomial::constant(constant), c.load}};
}

/// Compares ends, and traction and gap at some points.
template <Real R>
void compare(Findings& findings, const char* quantity, const ContactSolution<R>& a, const ContactSolution<R>& b,
             const R& load, const R& opened = 0) {
  using std::abs;
  const auto error = [&](const R& x, const R& y, const R& scale) { return static_cast<double>(abs(x - y) / scale); };
  const auto ends = a.contact();
  const auto other_ends = b.contact();
  findings.require(ends.size() == other_ends.size(), "other components of contact");
  for (std::size_t k = 0; k < ends.size(); ++k) {
    findings.compare(quantity, error(ends[k].left.x.value, other_ends[k].left.x.value, 1));
    findings.compare(quantity, error(ends[k].right.x.value, other_ends[k].right.x.value, 1));
  }
  for (const Rational& x : {Rational(-19, 20), Rational(-2, 5), Rational(-1, 20), Rational(3, 10), Rational(9, 10)}) {
    const auto here = a.at(x);
    const auto there = b.at(x);
    findings.compare(quantity, error(here.traction.left.value, there.traction.left.value, load));
    if (here.gap && there.gap) findings.compare(quantity, error(here.gap->value + opened, there.gap->value, load));
  }
}

template <Real R>
void check(Findings& findings, const SameSolution& same, const Homogeneous& c) {
  // The rules for residuals lose one or two digits.
  const R load = to_real<R>(c.load);
  const auto solution = solve<R>(c.problem());
  const auto closed = numeric::closed_form<R>(same.closed.problem());
  if (closed.solution) {
    compare<R>(findings, "solvers", *solution, *closed.solution, load);
  } else {
    findings.skip("solvers");
  }
  const auto raised = solve<R>(same.raised.problem());
  compare<R>(findings, "shifted", *solution, *raised, load, to_real<R>(same.opened));
  // Residuals come last, because they take longer than solutions.
  const numeric::Residuals<R> left = solution->residuals();
  for (const R& value : {equation_error(solution->form()), left.load, left.penetration, left.tension}) {
    findings.compare("residual", static_cast<double>(value));
  }
}

}  // namespace

Claim claim() {
  return formula_claim<Homogeneous, SameSolution>("thm-08-homogeneous")
      .cases(cases)
      .says(same_solution)
      .checked([]<Real R>(auto&... of) { check<R>(of...); })
      .wrong("the second solver with the friction's sign reversed", [](SameSolution& same) { same.closed.s *= -1; })
      .wrong("the second solver with twice the load", [](SameSolution& same) { same.closed.load *= 2; })
      .wrong("the second solver with twice the profile",
             [](SameSolution& same, const Homogeneous& c) { same.closed.profile = c.profile + c.profile; })
      .wrong("`psi + C + x/10` instead of `psi + C`",
             [](SameSolution& same) {
               same.raised.profile = same.raised.profile + Polynomial({0, Rational(1, 10)});
             })
      .wrong("`psi + C` and `u_n`, not `u_n + C`", &SameSolution::opened, constant)
      .near_miss("the second solver's load", [](SameSolution& same, const Number& step) {
        same.closed.load *= 1 + Rational(static_cast<double>(step));
      });
}

}  // namespace steadyslide::proofs_checks::thm_08_homogeneous
