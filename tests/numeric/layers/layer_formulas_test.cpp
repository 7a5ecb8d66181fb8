// The recursion of the numeric layer against the decided formulas of one layer, with 100 digits.

#include "symbolic/cln/layer_formulas.hpp"

#include "numeric/layers/body_symbols.hpp"
#include "support/numeric_test.hpp"

namespace {

struct DecidedSymbols {
  Real100 normal;    ///< W
  Real100 coupling;  ///< gamma V
};

/// Returns the symbols of a layer on an elastic half-plane, or on a rigid base if `base` is absent.
DecidedSymbols decided_symbols(const Layer& layer, const std::optional<Solid>& base, Plane plane, const Rational& k) {
  const Rational kappa = layer.solid.kolosov(plane);
  Rational K = -1 / kappa, L = -kappa, rho = 1;
  if (base) {
    const Rational kappa_b = base->kolosov(plane);
    const Rational n = base->shear_modulus() / layer.solid.shear_modulus();
    const Rational m = (kappa_b + 1) / (n * (kappa + 1));
    K = (1 - n) / (1 + n * kappa);
    L = (kappa_b - n * kappa) / (kappa_b + n);
    rho = (1 - m) / (1 + m);
  }
  const auto number = [](const Rational& value) { return to_real<Real100>(value); };
  const Real100 xi = number(k * layer.thickness), e = exp(Real100(-2 * xi));
  const auto formula = layer.below == Interface::bonded ? symbolic::bonded_layer(number(K), number(L), xi, e)
                                                        : symbolic::slipping_layer(number(rho), xi, e);
  return {formula.normal, number((kappa - 1) / (kappa + 1)) - formula.coupling_defect};
}

double off_by_digits(const Real50& found, const Real100& truth) {
  return std::abs(static_cast<double>(Real100(Real100(found) - truth)));
}

}  // namespace

TEST_CASE("one layer of each kind: 50 digits of the recursion are those of the decided formulas") {
  const Solid rubber(0.48_r, 3_r), steel(0.3_r, 2000_r);
  const std::vector<std::optional<Solid>> bases{std::nullopt, steel, Solid(-0.5_r, 0.001_r)};
  for (const Interface below : {Interface::bonded, Interface::slip}) {
    for (const std::optional<Solid>& base : bases) {
      for (const Solid& solid : {rubber, steel}) {
        for (const Plane plane : {Plane::strain, Plane::stress}) {
          const Layer layer{0.7_r, solid, below};
          const BodySymbols<Real50> symbols(Elasticity(solid, plane), Body::layered({layer}, base));
          for (const char* k : {"1e-5", "0.01", "1", "2", "9", "60"}) {
            CAPTURE(k);
            const Rational wave_number = parse_rational(k);
            const DecidedSymbols truth = decided_symbols(layer, base, plane, wave_number);
            const auto found = symbols.at(to_real<Real50>(wave_number));
            const double size = static_cast<double>(truth.normal);
            CHECK(size > 0);
            CHECK(off_by_digits(found.normal, truth.normal) < 1e-54 * size);
            CHECK(off_by_digits(found.coupling, truth.coupling) < 1e-54 * (1 + size));
          }
        }
      }
    }
  }
}

TEST_CASE("the decided formulas of a layer: 15 digits from outside this project") {
  const Layer layer{1_r, Solid(0.3_r, 1_r)};
  const DecidedSymbols one = decided_symbols(layer, std::nullopt, Plane::strain, 1_r);
  CHECK(static_cast<double>(one.normal) == doctest::Approx(0.41575179845649).epsilon(1e-14));
  const DecidedSymbols half = decided_symbols(layer, std::nullopt, Plane::strain, 0.5_r);
  CHECK(static_cast<double>(half.normal) == doctest::Approx(0.206642486366985).epsilon(1e-14));
  // gamma = 2/7.
  CHECK(static_cast<double>(one.coupling) * 3.5 == doctest::Approx(-0.00257508988483).epsilon(1e-11));
}
