#include "proofs_checks/instruments/operators/local_power.hpp"
#include "proofs_checks/instruments/solutions/extremes.hpp"
#include "proofs_checks/instruments/tractions/punch.hpp"
#include "proofs_checks/kit/claim_builder.hpp"

namespace steadyslide::proofs_checks::fig_04_shape {
namespace {

ContactProblem two_coatings(const Rational& s_rear, const Rational& s_front) {
  return {Elasticity::reduced(Rational(1, 2)), FrictionProfile({2 * s_rear, 2 * s_front}, {0}),
          Indenter(-1, {{1, Polynomial()}}), 1};
}

/// Adds the extremes of |t| from left to right, and their number on each half.
template <Real R>
void add_extremes(Values& values, const std::vector<R>& places) {
  const auto behind = std::ranges::count_if(places, [](const R& x) { return x < 0; });
  values.add({"behind", Rational(behind)});
  values.add({"in front", Rational(std::ssize(places) - behind)});
  for (std::size_t i = 0; i < std::min<std::size_t>(places.size(), 2); ++i) {
    values.add({i == 0 ? "first extreme" : "second extreme", places[i]});
  }
}

/// Returns the power beta, and the extremes: the roots of x^2 - sum x + beta in ]-1, 1[.
Values shape(const Number& sum, const Number& beta) {
  Values values{{"power", beta}, {"unbounded", beta < 0}, {"equation", Number(0)}};
  const Number square = sum * sum - 4 * beta;
  std::vector<Number> roots;
  if (square >= 0) roots = {(sum - sqrt(square)) / 2, (sum + sqrt(square)) / 2};
  add_extremes(values, roots);
  return values;
}

Number alpha_of(const ContactProblem& p, std::size_t piece) { return to_real<Number>(alpha(p, piece)); }
Number beta_of(const ContactProblem& p) { return to_real<Number>(alpha(p, 0) - alpha(p, 1)); }

}  // namespace

Claim claim() {
  const Rational low(1, 10);
  const Rational high(3, 5);
  return compared<ContactProblem>("fig-04-shape")
      // In the third case both roots lie in front of the jump.
      .cases(fixed_cases<ContactProblem>(
          {two_coatings(low, high), two_coatings(high, low), two_coatings(3, Rational(7, 5)), two_coatings(0, 2),
           two_coatings(2, 0), two_coatings(Rational(7, 5), 3), two_coatings(20, 15)},
          3, "solved flat punches"))
      .precision(Precision::at_least_fifty)
      .measured([]<Real R>(const ContactProblem& p) {
        const auto solution = solve<R>(p);
        const std::size_t jump = point_at(*solution, Rational(0));
        const auto pressure = [&](const R& x) {
          return x < 0 ? R(-traction_beside(*solution, jump, Side::left, R(-x)))
                       : R(-traction_beside(*solution, jump, Side::right, x));
        };
        const R s_rear = to_real<R>(p.coupled_friction(0));
        const R s_front = to_real<R>(p.coupled_friction(1));
        const R d = asymptotic_distance<R>();
        Values values{{"power", jump_power<R>(s_rear, s_front).power},
                      {"unbounded", pressure(d) > pressure(R(2 * d)) && pressure(R(-d)) > pressure(R(-2 * d))},
                      {"equation", equation_error(p)}};
        std::vector<R> places = extremes_between<R>(pressure, R(-1), R(0));
        std::ranges::copy(extremes_between<R>(pressure, R(0), R(1)), std::back_inserter(places));
        add_extremes(values, places);
        return values;
      })
      .predicted([](const ContactProblem& p) { return shape(alpha_of(p, 0) + alpha_of(p, 1), beta_of(p)); })
      .wrong("the figures exchanged: `beta`'s sign",
             [](Values& p, const ContactProblem& c) { p = shape(alpha_of(c, 0) + alpha_of(c, 1), -beta_of(c)); })
      .wrong("`alpha_- - alpha_+` in the middle term",
             [](Values& p, const ContactProblem& c) { p = shape(beta_of(c), beta_of(c)); })
      .wrong("no extreme ever for `f_- > f_+`",
             [](Values& p, const ContactProblem& c) {
               if (beta_of(c) > 0) p = shape(0, beta_of(c));
             })
      .near_misses();
}

}  // namespace steadyslide::proofs_checks::fig_04_shape
