#include "numeric/layers/body_symbols.hpp"

#include "transfer_matrix.hpp"

namespace {

const Solid rubber(0.49_r, 2_r);
const Solid steel(0.3_r, 2000_r);
const Solid foam(-0.2_r, 0.01_r);
const Solid nearly_incompressible(0.4999_r, 1_r);

Body one_layer(const Solid& solid, Interface below, const std::optional<Solid>& base, const Rational& h = 1) {
  return Body::layered({{h, solid, below}}, base);
}

template <Real R>
BodySymbols<R> symbols_of(const Body& body, Plane plane = Plane::strain) {
  return {Elasticity(body.layers()[0].solid, plane), body};
}

template <Real R>
double error(const R& found, const Real100& truth, const Real100& scale) {
  return static_cast<double>(size_of(Real100((Real100(found) - truth) / scale)));
}

std::vector<Body> bodies() {
  std::vector<Body> result;
  for (const Interface below : {Interface::bonded, Interface::slip}) {
    for (const Solid& solid : {rubber, steel, foam, nearly_incompressible}) {
      result.push_back(one_layer(solid, below, std::nullopt));
      result.push_back(one_layer(solid, below, steel));
      result.push_back(one_layer(solid, below, foam));
    }
  }
  result.push_back(Body::layered({{0.3_r, rubber}, {0.01_r, steel}, {2_r, foam, Interface::slip}}, steel));
  result.push_back(Body::layered({{0.001_r, steel, Interface::slip}, {1_r, nearly_incompressible}}, std::nullopt));
  result.push_back(Body::layered({{1_r, foam, Interface::slip}, {0.1_r, steel, Interface::slip}, {1_r, rubber}}, foam));
  return result;
}

/// The closed formula of a bonded layer on a rigid base.
template <Real R>
SymbolValues<R> bonded_on_rigid(const R& kappa, const R& xi) {
  const R d = 2 * kappa * cosh(R(2 * xi)) + 1 + kappa * kappa + 4 * xi * xi;
  const R gamma = (kappa - 1) / (kappa + 1);
  const R w = (2 * kappa * sinh(R(2 * xi)) - 4 * xi) / d;
  const R v = (2 * kappa * (cosh(R(2 * xi)) - 1) * gamma - 8 * xi * xi / (kappa + 1)) / d;
  return {w, v, 1 - w, gamma - v};
}

}  // namespace

TEST_CASE("a bonded layer on a rigid base has the closed formula, with numbers from outside this project") {
  struct Value {
    Rational nu;
    Rational xi;
    const char* normal;
    const char* relative_coupling;
  };
  for (const auto& [nu, xi, normal, coupling] : {Value{0.3_r, 1_r, "0.41575179845649", "-0.00257508988483"},
                                                 {0.3_r, 0.5_r, "0.206642486366985", "-0.050477550466195"},
                                                 {0.2_r, 2_r, "0.78928602558974", "0.62740793383075"}}) {
    const auto symbols = symbols_of<double>(one_layer(Solid(nu, 1_r), Interface::bonded, std::nullopt));
    const auto k = to_real<double>(xi);
    CHECK(std::abs(symbols.normal(k) - std::stod(normal)) < 1e-14);
    CHECK(std::abs(symbols.coupling(k) / symbols.gamma() - std::stod(coupling)) < 1e-14);
  }
  for (const Solid& solid : {rubber, steel, foam, nearly_incompressible}) {
    const auto symbols = symbols_of<Real50>(one_layer(solid, Interface::bonded, std::nullopt));
    const auto kappa = to_real<Real50>(solid.kolosov(Plane::strain));
    for (const double xi : {0.01, 0.7, 1.0, 1.5, 8.0, 40.0}) {
      const auto found = symbols.at(Real50(xi));
      const auto formula = bonded_on_rigid<Real50>(kappa, xi);
      CHECK(close(found.normal, formula.normal, 100, Real50(1)));
      CHECK(close(found.coupling, formula.coupling, 100, Real50(1)));
    }
  }
}

TEST_CASE("one layer and stacks agree with the matrix exponential: 4 kinds of interface, both planes") {
  for (const Body& body : bodies()) {
    for (const Plane plane : {Plane::strain, Plane::stress}) {
      const auto in_double = symbols_of<double>(body, plane);
      const auto in_50 = symbols_of<Real50>(body, plane);
      for (const double k : {1e-6, 1e-4, 0.01, 0.3, 0.999, 1.001, 4.0, 11.0}) {
        CAPTURE(k);
        const auto truth = by_transfer_matrix(body, plane, Real100(k));
        const auto found = in_double.at(k);
        const auto more = in_50.at(Real50(k));
        const Real100 size = size_of(truth.normal) + size_of(truth.coupling);
        CHECK(truth.normal > 0);
        CHECK(error(found.normal, truth.normal, truth.normal) < 1e-13);
        CHECK(error(found.coupling, truth.coupling, size) < 1e-13);
        CHECK(error(more.normal, truth.normal, truth.normal) < 1e-53);
        CHECK(error(more.coupling, truth.coupling, size) < 1e-53);
        if (k <= 1) continue;
        // The defects keep their relative precision.
        const Real100 defect = 1 - truth.normal;
        const Real100 coupling_defect =
            to_real<Real100>(Elasticity(body.layers()[0].solid, plane).gamma()) - truth.coupling;
        const Real100 defects = size_of(defect) + size_of(coupling_defect) + 1e-40;
        CHECK(error(found.normal_defect, defect, defects) < 2e-12);
        CHECK(error(found.coupling_defect, coupling_defect, defects) < 2e-12);
      }
    }
  }
}

TEST_CASE("the matrix exponential refutes a wrong sign of gamma, another interface and a wrong solid") {
  const Body body = one_layer(rubber, Interface::bonded, steel);
  const auto truth = by_transfer_matrix(body, Plane::strain, Real100(0.7));
  const auto found = symbols_of<double>(body).at(0.7);
  CHECK(error(-found.coupling, truth.coupling, Real100(1)) > 1e-3);
  CHECK(error(symbols_of<double>(one_layer(rubber, Interface::slip, steel)).normal(0.7), truth.normal, Real100(1)) >
        1e-3);
  CHECK(error(symbols_of<double>(body, Plane::stress).normal(0.7), truth.normal, Real100(1)) > 1e-3);
}

TEST_CASE("limits: the half-plane, thick and thin layers, one solid in many layers") {
  const auto same = symbols_of<double>(one_layer(rubber, Interface::bonded, rubber));
  for (const double k : {1e-6, 0.1, 0.9, 1.1, 30.0}) {
    CHECK(std::abs(same.at(k).normal_defect) < 1e-14);
    CHECK(std::abs(same.at(k).coupling_defect) < 1e-14);
  }
  for (const Body& body : bodies()) {
    const auto symbols = symbols_of<double>(body);
    const double far = symbols.last_wave_number();
    CHECK(size_of(symbols.at(far).normal_defect) + size_of(symbols.at(far).coupling_defect) < 1e-17);
    CHECK(symbols.normal(1e6 * far) == 1);
    CHECK(symbols.coupling(1e6 * far) == symbols.gamma());
    CHECK(symbols.has_absolute_displacement() == !body.base());
    if (!body.base()) {
      CHECK(symbols.normal(1e-9) < 1e-7);
      continue;
    }
    // A thin layer shows the base. A slipping one has its own coupling.
    const double ratio =
        to_real<double>(Elasticity(*body.base()).compliance() / Elasticity(body.layers()[0].solid).compliance());
    CHECK(symbols.normal(1e-12) / ratio == doctest::Approx(1).epsilon(1e-4));
  }
  const Body one = one_layer(nearly_incompressible, Interface::bonded, std::nullopt);
  const Body many = Body::layered(std::vector<Layer>(64, {1_r / 64, nearly_incompressible}), std::nullopt);
  for (const double k : {1e-6, 1e-4, 0.01, 1.0, 10.0, 40.0, 80.0, 1000.0}) {
    CHECK(symbols_of<double>(many).normal(k) / symbols_of<double>(one).normal(k) == doctest::Approx(1).epsilon(1e-13));
  }
  const BodySymbols<double> half_plane(Elasticity(steel), Body{});
  CHECK(half_plane.normal(3) == 1);
  CHECK(half_plane.last_wave_number() == 0);
}

TEST_CASE("random stacks: W > 0 and 13 digits, for any contrast and wave number") {
  REQUIRE(rc::check([] {
    std::vector<Layer> layers;
    const auto solid = [] { return Solid(Rational(uniform(-90, 49)) / 100, Rational(std::pow(10.0, uniform(-4, 4)))); };
    const int count = uniform(1, 6);
    for (int n = 0; n < count; ++n) {
      layers.push_back(
          {Rational(uniform(1, 1000)) / 1000, solid(), uniform(0, 1) == 0 ? Interface::bonded : Interface::slip});
    }
    const bool rigid = uniform(0, 1) == 0;
    const Body body = Body::layered(layers, rigid ? std::nullopt : std::optional(solid()));
    const double k = std::pow(10.0, uniform(-600, 300) / 100.0);
    const auto found = symbols_of<double>(body).at(k);
    const auto truth = symbols_of<Real100>(body).at(Real100(k));
    RC_ASSERT(truth.normal > 0);
    RC_ASSERT(error(found.normal, truth.normal, truth.normal) < 1e-13);
  }));
}

TEST_CASE("given symbols are interpolated, continued to 0 and beyond the last row") {
  const Body body = one_layer(steel, Interface::bonded, std::nullopt);
  const auto exact = symbols_of<double>(body);
  std::vector<SymbolRow> rows;
  for (int n = 1; n <= 400; ++n) {
    const Rational k = Rational(n) / 40;
    rows.push_back({k, Rational(exact.normal(n / 40.0)), Rational(exact.coupling(n / 40.0))});
  }
  const BodySymbols<double> given(Elasticity(steel), Body::of_symbols(rows));
  CHECK(given.has_absolute_displacement());
  CHECK(given.given_wave_numbers().size() == 401);
  for (const double k : {0.001, 0.012, 0.51, 1.234, 5.0, 9.99}) {
    CHECK(std::abs(given.normal(k) - exact.normal(k)) < 2e-4);
    CHECK(std::abs(given.coupling(k) - exact.coupling(k)) < 2e-4);
  }
  CHECK(given.normal(10.01) == 1);
  CHECK(given.coupling(10.01) == given.gamma());
  const Body flat = Body::of_symbols({{1_r, 0.5_r, 0.1_r}, {2_r, 0.6_r, 0.2_r}, {3_r, 0.9_r, 0.2_r}});
  const BodySymbols<double> constant(Elasticity::reduced(0.2_r), flat);
  CHECK_FALSE(constant.has_absolute_displacement());
  CHECK(constant.normal(1e-3) == doctest::Approx(0.5));
  CHECK(constant.coupling(1e-3) == doctest::Approx(0.1));
  CHECK(constant.coupling(2.5) == doctest::Approx(0.2));
  CHECK(holds(thrown_by([&] { BodySymbols<double>(Elasticity::reduced(0.2_r), body); }), "solid"));
  CHECK(holds(thrown_by([&] { BodySymbols<double>(Elasticity(steel), Body::periodic(1)); }), "periodic"));
}
