#include "proofs_checks/instruments/tractions/punch_loads.hpp"
#include "proofs_checks/kit/claim_builder.hpp"
#include "proofs_checks/kit/rate.hpp"
#include "proofs_checks/kit/special_numbers.hpp"

namespace steadyslide::proofs_checks::flat_punch_direction_small {
namespace {

struct Halves {
  std::string name;
  Rational rear;
  Rational front;
};

/// Returns (f(+) - f(-))/gamma, the difference of the effective friction between the two directions of sliding.
template <Real R>
R difference(const Halves& halves, const Rational& gamma) {
  const ContactProblem forth(Elasticity::reduced(gamma), FrictionProfile({halves.rear, halves.front}, {0}),
                             Indenter(-1, {{1, Polynomial()}}), 1);
  const R back = punch_loads<R>(forth.with_sliding(Sliding::minus_x)).friction;
  return (punch_loads<R>(forth).friction - back) / to_real<R>(gamma);
}

template <Real R>
Values measured(const Halves& halves) {
  using std::abs;
  const R limit = difference<R>(halves, parse_rational("1e-9"));
  std::vector<Level> levels;
  for (const char* gamma : {"1e-2", "5e-3", "2e-3", "1e-3"}) {
    const R rest = difference<R>(halves, parse_rational(gamma)) / limit - 1;
    levels.push_back({1 / to_real<double>(parse_rational(gamma)), static_cast<double>(R(abs(rest)))});
  }
  const Rate rate = fitted_rate(levels);
  return {{"first order", limit}, {"rest", Order{rate.value, rate.error_bar, "`gamma` from `1e-2` to `1e-3`"}}};
}

Values predicted(const Halves& halves, const Number& constant) {
  const auto pi = numeric::pi<Number>();
  return {{"first order",
           Number(4 * constant / (pi * pi) * to_real<Number>(halves.rear * halves.rear - halves.front * halves.front))},
          {"rest", Order{2}}};
}

}  // namespace

Claim claim() {
  return compared<Halves>("flat-punch-direction-small")
      .cases(fixed_cases<Halves>({{"f = 0.1 | 0.5", Rational(1, 10), Rational(1, 2)},
                                  {"f = 1 | 0", 1, 0},
                                  {"f = 0.3 | 2", Rational(3, 10), 2}},
                                 1, "two equal halves"))
      .precision(Precision::at_least_fifty)
      .measured([]<Real R>(const Halves& halves) { return measured<R>(halves); })
      .predicted([](const Halves& halves) { return predicted(halves, catalan()); })
      .wrong("the rough half in front costs more", scaled({"first order"}, -1))
      .wrong("`pi^2/12` for Catalan's constant",
             [](Values& p, const Halves& halves) {
               p = predicted(halves, Number(numeric::pi<Number>() * numeric::pi<Number>() / 12));
             })
      .wrong("linear in the coefficients",
             scaled({"first order"}, [](const Halves& h) { return to_real<Number>(1 / (h.rear + h.front)); }))
      .wrong("`2 G` for `4 G`", scaled({"first order"}, 0.5))
      .wrong("a rest of first order", replaced({{"rest", Order{1}}}))
      .near_misses();
}

}  // namespace steadyslide::proofs_checks::flat_punch_direction_small
