#include "model/body.hpp"

#include "broken_rule.hpp"
#include "model/contact_problem.hpp"

namespace {

const Solid steel(0.3_r, 210), soft(0.45_r, 1);
const Indenter plane_punch(-1, {{1, Polynomial{}}});

ContactProblem on(const Body& body, const Elasticity& elasticity = Elasticity(soft)) {
  return {elasticity, FrictionProfile({0.5_r}), plane_punch, 1, Sliding::plus_x, std::nullopt, body};
}

}  // namespace

TEST_CASE("bodies that do not exist") {
  CHECK(refusal([] { Body::layered({}, steel); }) == "layers: wrong number of layers; there are 1 to 64; 0 layers");
  CHECK(refusal([] {
          Body::layered({{1, soft}, {0, soft}}, steel);
        }) == "layers[1].thickness: thickness out of range; it is positive; 0");
  CHECK(refusal([] { Body::periodic(0); }) == "period: period out of range; it is positive; 0");
  CHECK(refusal([] {
          Body::of_symbols({{1, 1, 1}});
        }) == "symbol: too few rows; a table of symbols has at least 2 rows; 1 rows");
  CHECK(refusal([] {
          Body::of_symbols({{1, 1, 1}, {1, 1, 1}});
        }) == "symbol: k: wrong order; wave numbers are positive and increase; 1");
  CHECK(refusal([] {
          Body::of_symbols({{0, 1, 1}, {1, 1, 1}});
        }) == "symbol: k: wrong order; wave numbers are positive and increase; 0");
  CHECK(refusal([] { Body::of_symbols({{1, 0, 1}, {2, 1, 1}}); }) == "symbol: W: out of range; it is positive; 0");
}

TEST_CASE("problems that do not fit their body") {
  const Body layers = Body::layered({{1, soft}}, steel);
  CHECK(refusal([&] { on(layers); }) == "accepted");
  CHECK(refusal([&] { on(layers, Elasticity(steel)); }) ==
        ": the elasticity of a layered body is that of its first layer");
  CHECK(refusal([&] { on(layers, Elasticity(soft, steel)); }) ==
        "indenter.elastic: elastic indenter; on layers the indenter is rigid; present");
  CHECK(refusal([&] { on(Body::periodic(2)); }) == "accepted");
  CHECK(refusal([&] { on(Body::periodic(1.9_r)); }) ==
        "half_space.period: period out of range; it is not shorter than the support; 1.9");
  CHECK(refusal([&] {
          ContactProblem(Elasticity(soft), FrictionProfile({0}), plane_punch, 1, Sliding::plus_x, 0, Body::periodic(2));
        }) == "load_at: free attitude; with a period the attitude is fixed; 0");
  CHECK(refusal([&] {
          on({}).with_indenter(plane_punch.with_harmonics({{1, 1, 0}}));
        }) == "indenter.harmonics: harmonics without a period; half_space.period gives their length; absent");
  CHECK(refusal([&] {
          plane_punch.with_harmonics({{1, 1, 0}, {0, 1, 0}});
        }) == "indenter.harmonics[1].n: number out of range; a harmonic has a positive number; 0");
}

TEST_CASE("a moved problem takes its body and its harmonics with it") {
  const Body layers = Body::layered({{0.5_r, soft, Interface::slip}, {2, steel}}, std::nullopt);
  const Body moved = on(layers).moved(-2, 3).body();
  CHECK(moved.layers() == std::vector<Layer>{{1, soft, Interface::slip}, {4, steel}});
  CHECK(on(layers).moved(-2, 3).moved(-0.5_r, 1.5_r) == on(layers));
  const ContactProblem waves = on(Body::periodic(2)).with_indenter(plane_punch.with_harmonics({{1, 1, 2}}, 0.25_r));
  const Indenter mirrored = waves.moved(-2, 3).indenter();
  CHECK(mirrored.harmonics() == std::vector<Harmonic>{{1, 1, -2}});
  CHECK(mirrored.origin_of_harmonics() == 2.5_r);
  CHECK(waves.moved(-2, 3).body().period() == 4);
  CHECK(waves.moved(-2, 3).moved(-0.5_r, 1.5_r) == waves);
  CHECK(plane_punch.with_harmonics({{1, 1, 2}}).scaled(3).harmonics() == std::vector<Harmonic>{{1, 3, 6}});
  const Body table = Body::of_symbols({{1, 0.5_r, 0.1_r}, {2, 1, 0.2_r}});
  CHECK(table.scaled(2) == Body::of_symbols({{0.5_r, 0.5_r, 0.1_r}, {1, 1, 0.2_r}}));
  CHECK_FALSE(table == Body());
}
