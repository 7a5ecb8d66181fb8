// Checks the surface outside of the contact, close to an edge [Bal16, theorem 3].

#include <algorithm>

#include "proofs_checks/instruments/tractions/punch.hpp"
#include "proofs_checks/kit/claim_builder.hpp"

namespace steadyslide::proofs_checks::thm_03_outside_slope {
namespace {

/// The formulas u' = factor |Y| beyond an end, u' ~ coefficient theta d^power close to it, and t ~ -theta d^power
/// inside.
struct EndSlope {
  Number factor;
  Number coefficient;
  Exponent power;
  Number moved = 0;          ///< a near miss adds this to the power
  bool from_inside = false;  ///< take the estimate from inside the contact
};

struct Outside {
  EndSlope rear;
  EndSlope front;
};

CaseList<ContactProblem> punches(const Context& context) {
  const std::vector<ContactProblem> grid{
      punch(Rational(3, 10), {Rational(1, 2), 2}, {Rational(1, 4)}, 3), punch(Rational(3, 10), {1}), punch(0, {0}),
      punch(Rational(-9, 10), {50, 1, 10}, {0, Rational(1, 2)}), punch(Rational(499, 1000), {3})};
  return grid_and_random(context, "outside", grid, {30, 8, 3},
                         [&](Random& random) { return random_punch(context, random, random.below(3)); });
}

Outside outside(const ContactProblem& p) {
  const std::size_t last = p.friction().jumps().size();
  const Number over_pi = to_real<Number>(p.load()) / numeric::pi<Number>();
  const auto root = [&](std::size_t k) { return Number(1 / cos_pi_alpha<Number>(p.coupled_friction(k))); };
  return {{-over_pi, -root(0), -(half + alpha(p, 0))}, {over_pi, root(last), -(half - alpha(p, last))}};
}

/// Checks the slope beyond a contact end, and close to it.
template <Real R>
void check_end(Findings& findings, const EndSlope& end, Side side, const PowerForm<R>& form,
               const ContactProblem& problem) {
  using std::pow;
  const numeric::PowerTraction<R> traction = form.traction();
  const PiecewiseDensity<R> density = traction.density();
  const trapezoidal::Grid<R> grid(density);
  const R factor(end.factor);
  for (const Rational& distance : {Rational(1, 1000), Rational(1, 10), Rational(2), Rational(50)}) {
    const R d = to_real<R>(distance);
    const R expected = factor * traction.weight.modulus_beyond(side, d);
    findings.compare("trapezoidal", grid.cauchy(side, d), expected);
    if (distance != Rational(1, 10)) continue;
    findings.compare("tanh-sinh", tanh_sinh::cauchy<R>(density, side, d).value, expected);
  }
  const std::size_t last = side == Side::left ? 0 : form.lengths.size() - 1;
  // The relative error of the estimate is the distance divided by the length to the next singular point.
  const R near = R(tolerance<R>()) / 1000 * std::ranges::min(form.lengths);
  const R theta = -form.amplitudes[last] * traction.weight.amplitude(side == Side::left ? 0 : form.lengths.size());
  R slope = factor * traction.weight.modulus_beyond(side, near);
  if (end.from_inside) {
    const auto at = grid.midpoint_near(last, side == Side::left ? R(1) / 1'000'000 : R(999'999) / 1'000'000);
    slope = grid.hilbert(at) + to_real<R>(problem.coupled_friction(last)) * density[last](at.node);
  }
  const R power = to_real<R>(end.power) + R(end.moved);
  findings.compare("estimate", R(slope / (theta * pow(near, power))), R(end.coefficient));
}

}  // namespace

Claim claim() {
  return formula_claim<ContactProblem, Outside>("thm-03-outside-slope")
      .cases(punches)
      .effective_where(has_friction)
      .says(outside)
      .checked([]<Real R>(Findings& findings, const Outside& form, const ContactProblem& problem) {
        const PowerForm<R> traction = punch_traction(problem).at<R>();
        check_end(findings, form.rear, Side::left, traction, problem);
        check_end(findings, form.front, Side::right, traction, problem);
      })
      .wrong("the printed `x -> c-` at the front: the estimate read inside of the contact",
             [](Outside& form) { form.front.from_inside = true; })
      .wrong("the other sign of `u'` in front",
             [](Outside& form) {
               form.front.factor *= -1;
               form.front.coefficient *= -1;
             })
      .wrong("`sqrt(1+s^2)` missing at the rear", [](Outside& form) { form.rear.coefficient = -1; })
      .wrong("`sqrt(1+s^2)` of the front at the rear",
             [](Outside& form) { form.rear.coefficient = -form.front.coefficient; })
      .wrong("the powers of both edges exchanged in the estimate",
             [](Outside& form) { std::swap(form.rear.power, form.front.power); })
      .wrong("the power of the other side's friction at the rear",
             [](Outside& form, const ContactProblem& p) {
               form.rear.power = -(half + alpha(p, p.friction().values().size() - 1));
             })
      .near_miss("the power at the front", [](Outside& form, const Number& step) { form.front.moved = step; })
      .near_miss("`u'` behind", [](Outside& form, const Number& step) { form.rear.factor *= 1 + step; });
}

}  // namespace steadyslide::proofs_checks::thm_03_outside_slope
