// An interpolated density equals the density, and evaluates it no more often than necessary.

#include "numeric/cauchy/interpolated_density.hpp"

#include <cmath>

#include "support/numeric_test.hpp"

namespace {

/// 1/(place + 1/50) plus `logarithm` times place log(place), over a panel of length 2. Each value has an error of up to
/// `rounding`.
PanelDensity<double> density(double logarithm, double rounding, int& asked) {
  const auto smooth = [logarithm, rounding, &asked](const Node<double>& node) {
    ++asked;
    const double place = node.from_left / 2;
    const double noise = std::sin(1e15 * place) * rounding;
    return (1 / (place + 0.02) + logarithm * place * std::log(place)) * (1 + noise);
  };
  const Power<double> none{0, 1};
  return {{-1, 1, 2}, none, none, smooth};
}

double largest_error(double logarithm, double rounding, int& asked) {
  int ignored = 0;
  const PanelDensity<double> exact = density(logarithm, 0, ignored);
  const PanelDensity<double> found = interpolated(density(logarithm, rounding, asked));
  double worst = 0;
  for (int i = 1; i < 400; ++i) {
    const Node<double> node = exact.panel.node_from_left(2 * std::pow(i / 400.0, 3));
    worst = std::max(worst, std::abs(found(node) / exact(node) - 1));
  }
  return worst;
}

}  // namespace

TEST_CASE("an interpolated density is right, smooth or with a logarithm at its end") {
  for (const double logarithm : {0.0, 1.0}) {
    int asked = 0;
    CHECK(largest_error(logarithm, 0, asked) <= 1e-13);
    CHECK(asked <= 1500);
  }
}

TEST_CASE("a density with a rounding of its own is not refined below that") {
  for (const double rounding : {1e-14, 1e-13}) {
    int asked = 0;
    CHECK(largest_error(0, rounding, asked) <= 20 * rounding);
    CHECK(asked <= 1500);
  }
}
