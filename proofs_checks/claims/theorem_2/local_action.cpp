// Compares every symbol of the local action in the symbolic layer with a principal value by quadrature.

#include <optional>

#include "proofs_checks/kit/claim_builder.hpp"
#include "symbolic/local/local_action_value.hpp"

namespace steadyslide::proofs_checks::local_action {
namespace {

using numeric::Panel;
using symbolic::LocalAction;
using symbolic::WrongSymbol;

struct ActionAt {
  LocalAction action;
  Rational x;
};

/// Returns the density mirrored to the right half, where it is x^mu log(x)^logs on ]0, 1[.
template <Real R>
PiecewiseDensity<R> density_of(const LocalAction& action) {
  const R mu = to_real<R>(action.fractional ? Rational(action.lambda + action.order) : Rational(action.order));
  const int logs = action.logs;
  return {{Panel<R>{0, 1, 1}, {mu, R(1 + mu)}, {R(0), R(1)}, [logs](const Node<R>& node) {
             using std::log;
             R value = 1;
             for (int k = 0; k < logs; ++k) value *= log(node.from_left);
             return value;
           }}};
}

/// Returns principal values by tanh-sinh and by the trapezoidal rule. The latter sums its tails as pure powers, so that
/// it cannot be used with logarithms.
template <Real R>
Values principal_values(const LocalAction& action, const Rational& x) {
  const PiecewiseDensity<R> density = density_of<R>(action);
  const bool mirrored = action.side == Side::left;
  const R y = to_real<R>(mirrored ? Rational(-x) : x);
  // H anticommutes with the mirror; the mirror changes x^order to (-1)^order x^order.
  const int sign = mirrored && action.order % 2 == 0 ? -1 : 1;
  Values values;
  const auto add = [&](const char* name, const R& value) { values.add({name, R(sign * value)}); };
  if (y > 0) {
    const PanelPoint<R> at{0, density[0].panel.node_from_left(y)};
    add("tanh-sinh", tanh_sinh::hilbert(density, at).value);
    if (action.logs == 0) add("trapezoidal", trapezoidal::Grid<R>(density).hilbert(at));
  } else {
    add("tanh-sinh", tanh_sinh::cauchy(density, Side::left, R(-y)).value);
    if (action.logs == 0) add("trapezoidal", trapezoidal::Grid<R>(density).cauchy(Side::left, R(-y)));
  }
  return values;
}

std::string text_of(const ActionAt& c) {
  const LocalAction& action = c.action;
  return std::string(action.side == Side::left ? "x < 0: " : "x > 0: ") + "x^" + std::to_string(action.order) +
         (action.fractional ? " |x|^(" + to_string(action.lambda) + ")" : "") + " log^" + std::to_string(action.logs) +
         "|x| at x = " + to_string(c.x);
}

CaseList<ActionAt> actions(const Context& context) {
  std::vector<ActionAt> all;
  Random random(context.seed, "local-action");
  for (const Side side : {Side::left, Side::right}) {
    for (const bool fractional : {true, false}) {
      for (int order = 0; order < (context.quick ? 2 : 3); ++order) {
        for (int logs = 0; logs < (context.quick ? 2 : 3); ++logs) {
          const LocalAction action{side, fractional, order, logs, random.between(Rational(-4, 5), Rational(-1, 10))};
          const Rational x = random.between(Rational(1, 100), Rational(1, 4));
          all.push_back({action, x});
          all.push_back({action, -x});
        }
      }
    }
  }
  return {all, "every order and logarithm at a random power and place, seed " + std::to_string(context.seed)};
}

/// Returns the values of the symbols, with more digits than any check needs.
Values said(const ActionAt& c, std::optional<WrongSymbol> wrong = {}) {
  const int digits = static_cast<int>(numeric::Digits::hundred) + 10;
  const symbolic::Decimal decimal = local_action_value(c.action, c.x, digits, wrong);
  const auto value = to_real<Number>(decimal.value);
  Values values{{"tanh-sinh", value}};
  if (c.action.logs == 0) values.add({"trapezoidal", value});
  return values;
}

}  // namespace

Claim claim() {
  const auto with = [](WrongSymbol symbol) { return [symbol](Values& p, const ActionAt& c) { p = said(c, symbol); }; };
  return compared<ActionAt>("local-action")
      .cases(actions)
      .measured([]<Real R>(const ActionAt& c) { return principal_values<R>(c.action, c.x); })
      .predicted([](const ActionAt& c) { return said(c); })
      .wrong("`+cot(pi lambda)` on the density's side", with(WrongSymbol::cotangent_sign))
      .wrong("`+1/sin(pi lambda)` on the other side", with(WrongSymbol::cosecant_sign))
      .wrong("cotangent and sine on each other's side", with(WrongSymbol::sides_exchanged))
      .wrong("`1/pi` missing", with(WrongSymbol::pi_missing))
      .near_misses();
}

}  // namespace steadyslide::proofs_checks::local_action
