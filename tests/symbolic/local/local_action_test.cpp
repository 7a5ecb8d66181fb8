#include "symbolic/local/local_action.hpp"
#include "numeric/quadrature/tanh_sinh.hpp"
#include "support/test.hpp"
#include "symbolic/local/local_action_value.hpp"

using namespace steadyslide::symbolic;
using GiNaC::ex;

namespace {

/// H of the monomial cut off at |x| = 1, by quadrature. On the right it uses the mirror image of the density.
double quadrature(const LocalMonomial& monomial, double lambda, double x) {
  const double mu = monomial.order + (monomial.fractional ? lambda : 0);
  const int logs = monomial.logs;
  numeric::PanelDensity<double> panel{{0, 1, 1}, {mu, 1 + mu}, {0, 1}, [logs](const numeric::Node<double>& node) {
                                        return logs == 0 ? 1.0 : std::pow(std::log(node.from_left), logs);
                                      }};
  const bool mirrored = monomial.side == Side::left;
  const double y = mirrored ? -x : x;
  const double value = y > 0 ? numeric::tanh_sinh::hilbert<double>({panel}, {0, panel.panel.node_from_left(y)}).value
                             : numeric::tanh_sinh::cauchy<double>({panel}, Side::left, -y).value;
  return mirrored ? (monomial.order % 2 == 0 ? -value : value) : value;
}

}  // namespace

TEST_CASE("the local action and its far part are the principal value, on both sides, in the strip and beyond it") {
  int compared = 0;
  for (const Side side : {Side::left, Side::right}) {
    for (const bool fractional : {true, false}) {
      for (const int order : {0, 1, 2}) {
        for (const int logs : {0, 1, 2}) {
          for (const double lambda : fractional ? std::vector{-0.7, -0.3, 0.4} : std::vector{0.0}) {
            const LocalMonomial monomial{side, fractional, order, logs};
            for (const double x : {-0.25, -0.02, 0.02, 0.25}) {
              INFO("order = ", order, ", logs = ", logs, ", lambda = ", lambda, ", x = ", x);
              const auto value = [&](Side from) {
                const LocalAction action{from, fractional, order, logs, Rational(lambda)};
                return static_cast<double>(local_action_value(action, Rational(x), 16).value);
              };
              const double expected = quadrature(monomial, lambda, x);
              CHECK(std::abs(value(side) - expected) < 1e-9 * (1 + std::abs(expected)));
              // A control: a density on the other side misses it.
              CHECK(std::abs(value(opposite(side)) - expected) > 1e-6);
              ++compared;
            }
          }
        }
      }
    }
  }
  CHECK(compared == 2 * (3 + 1) * 3 * 3 * 4);
}

TEST_CASE("an integer is the finite part of the powers next to it, to every order of the logarithm") {
  const GiNaC::symbol e("e"), pi("pi");
  const ex cot = (GiNaC::cos(e * GiNaC::Pi) / GiNaC::sin(e * GiNaC::Pi)).series(e == 0, 8);
  const ex cosecant = (1 / GiNaC::sin(e * GiNaC::Pi)).series(e == 0, 8);
  for (int logs = 0; logs <= 5; ++logs) {
    const LocalDensity image = act({{{Side::right, false, 3, logs}, 1}}, {0, 0, GiNaC::Pi});
    for (int k = 0; k <= logs + 1; ++k) {
      const ex weight = GiNaC::factorial(logs) / GiNaC::factorial(k);
      const auto coefficient = [&](Side side) {
        const auto found = image.find({side, false, 3, k});
        return found == image.end() ? ex(0) : found->second;
      };
      CHECK((coefficient(Side::right) + weight * cot.coeff(e, logs - k)).expand().is_zero());
      CHECK((coefficient(Side::left) + weight * cosecant.coeff(e, logs - k)).expand().is_zero());
    }
  }
}
