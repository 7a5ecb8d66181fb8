#include "proofs_checks/instruments/operators/local_power.hpp"
#include "proofs_checks/instruments/solutions/extremes.hpp"
#include "proofs_checks/instruments/tractions/punch.hpp"
#include "proofs_checks/kit/claim_builder.hpp"

namespace steadyslide::proofs_checks::fig_05_parabola {
namespace {

/// The radius R = 1/5 of the profile psi/c = x^2/(2 R).
const Rational radius(1, 5);

ContactProblem parabola(const Rational& f, const Rational& load, Sliding sliding = Sliding::plus_x) {
  return {Elasticity::reduced(Rational(2, 7)), FrictionProfile({f}),
          Indenter(-2, {{2, Polynomial({0, 0, 1 / (2 * radius)})}}), load, sliding};
}

/// Returns the predicted contact of half-width a for the angle alpha. For sliding towards -x, alpha is negative and the
/// rear is on the right.
Values shifted_contact(const Number& alpha, const Number& a) {
  return {{"left end", Number(-(1 + 2 * alpha) * a)},
          {"right end", Number((1 - 2 * alpha) * a)},
          {"left power", Number(0.5 - alpha)},
          {"right power", Number(0.5 + alpha)},
          {"equation", Number(0)},
          {"place", Number(-4 * alpha * a)},
          {"to the rear", true}};
}

Number alpha_of(const ContactProblem& p) { return to_real<Number>(alpha(p, 0)); }

Number half_width(const ContactProblem& p, const Number& alpha) {
  const auto product = to_real<Number>(p.load() * radius);
  return sqrt(Number(product / (2 * numeric::pi<Number>() * (0.25 - alpha * alpha))));
}

}  // namespace

Claim claim() {
  return compared<ContactProblem>("fig-05-parabola")
      .cases(fixed_cases<ContactProblem>(
          {parabola(2, 1), parabola(Rational(1, 5), 3), parabola(30, 1), parabola(2, 1, Sliding::minus_x)}, 1,
          "solved parabolas"))
      .precision(Precision::at_least_fifty)
      .measured([]<Real R>(const ContactProblem& p) {
        const auto solution = solve<R>(p);
        const auto contact = solution->contact().front();
        const R left = contact.left.x.value;
        const R right = contact.right.x.value;
        const R s = to_real<R>(p.coupled_friction(0));
        Values values{{"left end", left},
                      {"right end", right},
                      {"left power", end_power<R>(Side::right, EndTraction::vanishing, s)},
                      {"right power", end_power<R>(Side::left, EndTraction::vanishing, s)},
                      {"equation", equation_error(p)}};
        const std::size_t end = contact_end(*solution, Side::left);
        const auto pressure = [&](const R& x) { return R(-traction_beside(*solution, end, Side::right, R(x - left))); };
        // The pressure is zero at both ends, so a single extreme is the maximum.
        const std::vector<R> extremes = extremes_between<R>(pressure, left, right);
        if (extremes.size() != 1) return values;
        const R centre = (left + right) / 2;
        values.add({"place", extremes.front()});
        values.add(
            {"to the rear", s > 0 ? extremes.front() < centre && centre < 0 : extremes.front() > centre && centre > 0});
        return values;
      })
      .predicted([](const ContactProblem& p) {
        const Number alpha = alpha_of(p);
        return shifted_contact(alpha, half_width(p, alpha));
      })
      .wrong("shifted to the front",
             [](Values& p, const ContactProblem& c) { p = shifted_contact(-alpha_of(c), half_width(c, alpha_of(c))); })
      .wrong("the largest pressure at the contact's centre", [](Values& p) { p["place"] /= 2; })
      .wrong("the largest pressure at the vertex", [](Values& p) { p["place"] = 0; })
      .wrong("the same power at both ends", [](Values& p) { p["right power"] = Number(p["left power"]); })
      .wrong("the frictionless half-width",
             [](Values& p, const ContactProblem& c) { p = shifted_contact(alpha_of(c), half_width(c, 0)); })
      .near_misses();
}

}  // namespace steadyslide::proofs_checks::fig_05_parabola
