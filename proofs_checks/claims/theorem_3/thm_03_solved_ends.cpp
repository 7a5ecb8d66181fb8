// Compares the slope of the surface beyond the contact ends of solved problems with the traction inside.

#include "numeric/riemann_hilbert/traction_density.hpp"
#include "proofs_checks/instruments/solutions/flanks.hpp"
#include "proofs_checks/instruments/solutions/local_behaviour.hpp"
#include "proofs_checks/instruments/solutions/trial.hpp"
#include "proofs_checks/instruments/tractions/punch.hpp"
#include "proofs_checks/kit/claim_builder.hpp"

namespace steadyslide::proofs_checks::thm_03_solved_ends {
namespace {

struct SolvedProblem {
  ContactProblem problem;
  std::array<bool, 2> free;  ///< true for a free end

  Rational s(std::size_t end) const { return s_of(problem, end == 0 ? 0 : problem.friction().values().size() - 1); }
};

std::string text_of(const SolvedProblem& c) { return proofs_checks::text_of(c.problem); }

/// Returns a problem whose friction jumps at the point where two flanks meet.
ContactProblem with_jump(const Rational& rear, const Rational& front, const Polynomial& left, const Polynomial& right,
                         const Rational& load) {
  return flanks(FrictionProfile({rear, front}, {corner}), left, right, load, Rational(-1, 2));
}

CaseList<SolvedProblem> problems(const Context& context) {
  return first_when_quick<SolvedProblem>(
      context,
      {{with_jump(1, Rational(1, 4), Polynomial(), Polynomial({0, Rational(1, 4), 1}), 30), {false, true}},
       {with_jump(Rational(1, 3), 2, Polynomial({0, Rational(-1, 10)}), Polynomial({0, Rational(1, 10)}), 60),
        {false, false}},
       {with_jump(2, 0, Polynomial({0, Rational(-3, 4), 1}), Polynomial({0, Rational(3, 2), 2}), 5), {true, true}}},
      1, "solved problems");
}

/// The formula u'/c - psi'/c = coefficient (-t/d^p) d^p beyond an end, where -t/d^p is continued across the end.
struct EndSlope {
  Number coefficient;
  Number power;
};
using EndSlopes = std::array<EndSlope, 2>;

EndSlopes slopes(const SolvedProblem& c) {
  EndSlopes said;
  for (const std::size_t i : {0U, 1U}) {
    const Exponent angle = i == 0 ? -Exponent::angle(c.s(i)) : Exponent::angle(c.s(i));
    const Number root = 1 / cos_pi_alpha<Number>(c.s(i));
    said[i] = {(i == 0) == c.free[i] ? root : Number(-root), to_real<Number>((c.free[i] ? half : -half) + angle)};
  }
  return said;
}

/// A solved problem, and u'/c by quadrature one step beyond its outer ends.
template <class R>
struct SolvedEnds {
  Solved<R> solution;
  std::array<R, 2> slope;
};

template <Real R>
SolvedEnds<R> measure(const SolvedProblem& c) {
  const auto solution = solve<R>(c.problem);
  const trapezoidal::Grid<R> grid(numeric::traction_density(solution->form()));
  const R h = extrapolation_step<R>();
  return {solution, {grid.cauchy(Side::left, h), grid.cauchy(Side::right, h)}};
}

template <Real R>
void check_end(Findings& findings, const EndSlope& said, Side side, const SolvedEnds<R>& found) {
  using std::pow;
  const auto& form = found.solution->form();
  const std::size_t end = contact_end(*found.solution, side);
  const R h = extrapolation_step<R>();
  const R power(said.power);
  std::vector<R> theta;  // inside, 1, 2, ... steps from the end
  for (int i = 1; i <= extrapolation_values<R>; ++i) {
    const R d = i * h;
    theta.push_back(-form.traction(numeric::beside(form.set(), end, opposite(side), d)).value / pow(d, power));
  }
  const std::size_t segment = side == Side::left ? end : end - 1;
  const R x = form.set().x(end) + (side == Side::left ? R(-h) : h);
  const R profile = form.problem().slope(form.slope_at(segment), x) + form.tilt();
  const R slope = found.slope[side == Side::left ? 0 : 1] - profile;
  findings.compare("slope", R(slope / (R(said.coefficient) * pow(h, power))), extrapolated(theta, 1));
}

}  // namespace

Claim claim() {
  return formula_claim<SolvedProblem, EndSlopes>("thm-03-solved-ends")
      .cases(problems)
      .precision(Precision::at_least_fifty)
      .says(slopes)
      .checked([kept = std::make_shared<KeptForCases>()]<Real R>(Findings& findings, const EndSlopes& said,
                                                                 const SolvedProblem& c) {
        const SolvedEnds<R>& found = kept->at(c, [&] { return measure<R>(c); });
        check_end(findings, said[0], Side::left, found);
        check_end(findings, said[1], Side::right, found);
        const auto contact = found.solution->contact();
        findings.require(contact.front().left.intensity.value >= 0 && contact.back().right.intensity.value >= 0,
                         "theta < 0 where t <= 0 forbids it");
      })
      .wrong("the other sign of `u' - psi'` behind the rear end", [](EndSlopes& said) { said[0].coefficient *= -1; })
      .wrong("the other sign of `u' - psi'` beyond a free end",
             [](EndSlopes& said, const SolvedProblem& c) {
               for (const std::size_t i : {0U, 1U}) said[i].coefficient *= c.free[i] ? -1 : 1;
             })
      .wrong("`sqrt(1+s^2)` missing",
             [](EndSlopes& said) {
               std::ranges::for_each(said, [](EndSlope& end) { end.coefficient = end.coefficient > 0 ? 1 : -1; });
             })
      .wrong("the powers of both ends exchanged", [](EndSlopes& said) { std::swap(said[0].power, said[1].power); })
      .near_miss("the power at the front", [](EndSlopes& said, const Number& step) { said[1].power += step; })
      .near_miss("`u'` in front", [](EndSlopes& said, const Number& step) { said[1].coefficient *= 1 + step; });
}

}  // namespace steadyslide::proofs_checks::thm_03_solved_ends
