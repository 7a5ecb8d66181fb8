// The recursion of the numeric layer against the decided formulas of one layer, evaluated by CLN.

#include "numeric/layers/body_symbols.hpp"
#include "support/numeric_test.hpp"
#include "symbolic/cln/cln_layer.hpp"

namespace {

double off_by_digits(const Real50& found, const symbolic::Decimal& truth) {
  return std::abs(static_cast<double>(found - to_real<Real50>(truth.value)));
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
            const symbolic::ClnLayerSymbols truth = symbolic::cln_layer_symbols(layer, base, plane, wave_number, 60);
            const auto found = symbols.at(to_real<Real50>(wave_number));
            const double size = static_cast<double>(truth.normal.value);
            CHECK(size > 0);
            CHECK(off_by_digits(found.normal, truth.normal) < 1e-54 * size);
            CHECK(off_by_digits(found.coupling, truth.coupling) < 1e-54 * (1 + size));
          }
        }
      }
    }
  }
}

TEST_CASE("a layer in CLN: 15 digits from outside this project, and refusals") {
  const Layer layer{1_r, Solid(0.3_r, 1_r)};
  const symbolic::ClnLayerSymbols one = symbolic::cln_layer_symbols(layer, std::nullopt, Plane::strain, 1_r, 14);
  CHECK(one.normal.text == "0.41575179845649");
  CHECK(symbolic::cln_layer_symbols(layer, std::nullopt, Plane::strain, 0.5_r, 15).normal.text == "0.206642486366985");
  // gamma = 2/7.
  CHECK(static_cast<double>(one.coupling.value) * 3.5 == doctest::Approx(-0.00257508988483).epsilon(1e-11));
  CHECK_THROWS_AS(symbolic::cln_layer_symbols(layer, std::nullopt, Plane::strain, 0_r, 14), std::domain_error);
}
