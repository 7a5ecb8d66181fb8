#include "proofs_checks/instruments/solutions/local_behaviour.hpp"
#include "proofs_checks/kit/claim_builder.hpp"
#include "proofs_checks/kit/rate.hpp"

namespace steadyslide::proofs_checks::rem_01_incompressible_order {
namespace {

/// Problems that differ only by gamma: a reduced problem with this gamma, or nu -> 1/2 at the same compliance.
struct Limit {
  std::string name;
  std::vector<Rational> f;
  Indenter indenter;
  bool by_poisson = false;

  ContactProblem problem(const Elasticity& elasticity, bool with_friction) const {
    std::vector<Rational> values = f;
    if (!with_friction) values.assign(f.size(), 0);
    std::vector<Rational> jumps;
    if (f.size() > 1) jumps.emplace_back(1, 8);
    return {elasticity, FrictionProfile(std::move(values), std::move(jumps)), indenter, Rational(3, 2)};
  }
  Elasticity elasticity(const Rational& small) const {
    return by_poisson ? Elasticity(Solid(Rational(1, 2) - small, 1)) : Elasticity::reduced(small);
  }
};

CaseList<Limit> limits(const Context& context) {
  const Rational c(1, 8);
  const Indenter flat(-1, {{1, Polynomial()}});
  const Indenter parabola(-2, {{2, Polynomial({0, 0, 1})}});
  const Indenter wedge(-2, {{c, Polynomial({Rational(1, 8), -1, 1})}, {2, Polynomial({Rational(-1, 8), 1, 1})}});
  return first_when_quick<Limit>(context,
                                 {{"flat punch", {2}, flat},
                                  {"parabola", {2}, parabola},
                                  {"flat punch, f jumps", {Rational(1, 2), 2}, flat},
                                  {"flat punch, nu -> 1/2", {2}, flat, true},
                                  {"wedge at a friction jump", {2, Rational(1, 2)}, wedge}},
                                 2, "problems, solved at four values of `gamma`");
}

template <Real R>
Values measured(const Limit& c) {
  using std::abs;
  const auto span = [](const RiemannHilbertSolution<R>& solution) {
    const auto contact = solution.contact();
    return std::pair(contact.front().left.x.value, contact.back().right.x.value);
  };
  std::vector<Level> levels;
  R slope = 0;
  R shift = 0;
  for (const char* small : {"1e-4", "1e-8", "1e-16", "1e-24"}) {
    const Elasticity body = c.elasticity(parse_rational(small));
    const auto with = solve<R>(c.problem(body, true));
    const auto without = solve<R>(c.problem(body, false));
    double largest = 0;
    R change = 0;
    for (const Rational& x : {Rational(-1, 2), Rational(1, 3), Rational(1, 2)}) {
      const R t = without->at(x).traction.left.value;
      change = (with->at(x).traction.left.value - t) / t;
      largest = std::max(largest, static_cast<double>(abs(change)));
    }
    const R gamma = to_real<R>(body.gamma());
    levels.push_back({static_cast<double>(1 / gamma), largest});
    const auto [left, right] = span(*with);
    const auto [zero_left, zero_right] = span(*without);
    slope = change / gamma;
    shift = ((left + right) - (zero_left + zero_right)) / (zero_right - zero_left) / gamma;
  }
  const Rate rate = fitted_rate(levels);
  Values values{{"order", Order{rate.value, rate.error_bar,
                                c.name + ", relative, at three fixed points, `gamma` from `1e-4` to `1e-24`"}}};
  if (c.name == "flat punch") values.add({"slope", slope});
  if (c.name == "parabola") values.add({"shift", shift});
  return values;
}

Values predicted(const Limit& c) {
  const Number first = to_real<Number>(c.f.front()) / numeric::pi<Number>();
  Values values{{"order", Order{1}}};
  if (c.name == "flat punch") values.add({"slope", Number(-first * log(Number(3)))});
  if (c.name == "parabola") values.add({"shift", Number(-2 * first)});
  return values;
}

}  // namespace

Claim claim() {
  return compared<Limit>("rem-01-incompressible-order")
      .cases(limits)
      .precision(Precision::at_least_fifty)
      .measured([]<Real R>(const Limit& c) { return measured<R>(c); })
      .predicted(predicted)
      .wrong("a difference of the order `gamma^2`", replaced({{"order", Order{2}}}))
      .wrong("a difference of the order `sqrt(gamma)`", replaced({{"order", Order{0.5}}}))
      .wrong("the sign of the first order", scaled({"slope", "shift"}, -1))
      .wrong("the first order without `f`",
             scaled({"slope", "shift"}, [](const Limit& c) { return to_real<Number>(1 / c.f.front()); }))
      .wrong("the first order without `1/pi`", scaled({"slope", "shift"}, numeric::pi<Number>()))
      .near_misses();
}

}  // namespace steadyslide::proofs_checks::rem_01_incompressible_order
