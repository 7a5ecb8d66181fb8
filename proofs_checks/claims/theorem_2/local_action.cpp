// The local action of the operator: every symbol of the symbolic layer against a principal value by quadrature.

#include <optional>

#include "numeric/quadrature/tanh_sinh.hpp"
#include "numeric/quadrature/trapezoidal.hpp"
#include "proofs_checks/claims/claims.hpp"
#include "proofs_checks/kit/findings.hpp"
#include "proofs_checks/kit/random.hpp"
#include "symbolic/local/local_action_value.hpp"

namespace steadyslide::proofs_checks {
namespace {

using numeric::Node;
using numeric::Panel;
using numeric::PiecewiseDensity;
using numeric::Real;
using symbolic::LocalAction;
using symbolic::WrongSymbol;

/// What the formula says of H of a density at x.
struct Formula {
  std::optional<WrongSymbol> wrong;
  bool near_miss = false;
};

/// Mirrored to the right half, where the density is x^mu log(x)^logs on ]0, 1[.
template <Real R>
PiecewiseDensity<R> density_of(const LocalAction& action) {
  const R mu = numeric::to_real<R>(action.fractional ? Rational(action.lambda + action.order) : Rational(action.order));
  const int logs = action.logs;
  return {{Panel<R>{0, 1, 1}, {mu, R(1 + mu)}, {R(0), R(1)}, [logs](const Node<R>& node) {
             using std::log;
             R value = 1;
             for (int k = 0; k < logs; ++k) value *= log(node.from_left);
             return value;
           }}};
}

template <Real R>
std::vector<R> principal_values(const LocalAction& action, const Rational& x) {
  const PiecewiseDensity<R> density = density_of<R>(action);
  const bool mirrored = action.side == Side::left;
  const R y = numeric::to_real<R>(mirrored ? Rational(-x) : x);
  std::vector<R> values;
  if (y > 0) {
    const numeric::PanelPoint<R> at{0, density[0].panel.node_from_left(y)};
    values.push_back(numeric::tanh_sinh::hilbert(density, at).value);
    // The trapezoidal rule sums its tails as pure powers: it takes no logarithms.
    if (action.logs == 0) values.push_back(numeric::trapezoidal::Grid<R>(density).hilbert(at));
  } else {
    values.push_back(numeric::tanh_sinh::cauchy(density, Side::left, R(-y)).value);
    if (action.logs == 0) values.push_back(numeric::trapezoidal::Grid<R>(density).cauchy(Side::left, R(-y)));
  }
  // H anticommutes with the mirror, which takes x^order to (-1)^order of it.
  if (mirrored && action.order % 2 == 0) {
    for (R& value : values) value = -value;
  }
  return values;
}

std::string text_of(const LocalAction& action, const Rational& x) {
  return std::string(action.side == Side::left ? "x < 0: " : "x > 0: ") + "x^" + std::to_string(action.order) +
         (action.fractional ? " |x|^(" + to_string(action.lambda) + ")" : "") + " log^" + std::to_string(action.logs) +
         "|x| at x = " + to_string(x);
}

template <Real R>
std::vector<Evidence> check(const Context& context, const Formula& formula) {
  const Quantity quantity{"value of (1/pi) PV int t(x')/(x'-x) dx'",
                          {"local formula and power series, in CLN", "tanh-sinh rule", "trapezoidal rule"},
                          tolerance<R>()};
  const int digits = static_cast<int>(context.digits) + 10;
  Findings findings;
  Random random(context.seed, "local-action");
  const auto compare = [&](const LocalAction& action, const Rational& x) {
    findings.begin_case(text_of(action, x));
    const symbolic::Decimal said =
        formula.wrong ? local_action_value(action, x, digits, *formula.wrong) : local_action_value(action, x, digits);
    R value = numeric::to_real<R>(said.value);
    if (formula.near_miss) value *= 1 + near_miss<R>();
    for (const R& measured : principal_values<R>(action, x)) {
      findings.compare(quantity, relative_difference(value, measured));
    }
  };
  return gather([&] {
    for (const Side side : {Side::left, Side::right}) {
      for (const bool fractional : {true, false}) {
        for (int order = 0; order < (context.quick ? 2 : 3); ++order) {
          for (int logs = 0; logs < (context.quick ? 2 : 3); ++logs) {
            const LocalAction action{side, fractional, order, logs, random.between(Rational(-4, 5), Rational(-1, 10))};
            const Rational x = random.between(Rational(1, 100), Rational(1, 4));
            compare(action, x);
            compare(action, -x);
          }
        }
      }
    }
    return findings.evidence("every order and logarithm at a random power and place, seed " +
                             std::to_string(context.seed));
  });
}

std::vector<Evidence> check_at(const Context& context, const Formula& formula) {
  return numeric::at_precision(context.digits, [&]<class R>() { return check<R>(context, formula); });
}

}  // namespace

Claim local_action() {
  return make_claim<Formula>(claim_text("local-action"), check_at, {},
                             {{"+cot(pi lambda) on the density's side", {WrongSymbol::cotangent_sign}},
                              {"+1/sin(pi lambda) on the other side", {WrongSymbol::cosecant_sign}},
                              {"cotangent and sine on each other's side", {WrongSymbol::sides_exchanged}},
                              {"1/pi missing", {WrongSymbol::pi_missing}},
                              {"near miss: the value moved by ten times the tolerance", {std::nullopt, true}}});
}

}  // namespace steadyslide::proofs_checks
