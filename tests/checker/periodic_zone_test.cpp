#include "checker/periodic_zone.hpp"

#include <doctest/doctest.h>

#include "checker/reader.hpp"
#include "overlap.hpp"

namespace {

using namespace steadyslide::checker;

constexpr slong zone_bits = 256, integral_bits = 160;

Periodic periodic_example(bool flat) {
  return Periodic::of_certificate(Reader::of_json(
      std::string(R"({"certificate": 1, "kind": "periodic", "generator": "by-hand 1.0.0", "problem": {
"load": "1", "load_at": null, "sliding": "+x", "gamma": "7/10", "compliance": "1", "period": "3/2",
"friction": {"values": ["0.4", "1.2", "0.2", "0.9"], "jumps": ["-0.1", "0.05", "0.2"]},
"indenter": {"left": "-0.7", "pieces": [{"to": "0.7", "profile": []}]},)") +
          (flat ? R"("harmonics": []}, "ends": ["-0.7", "0.7"], "free": [false, false], "traction": ["1.1", "0.3"],)"
                : R"("harmonics": [{"n": "2", "cos": "-0.01"}]}, "ends": ["-0.3", "0.3"], "free": [true, true],
                     "traction": ["1", "0.3", "-0.2", "0.1"],)") +
          R"("origin": "0", "radius": "1e-20",
"claims": {"exists": true, "effective_friction": ["0", "1"], "centre_of_pressure": ["0", "1"]}})",
      "example"));
}

Ball zone_number(const Rational& q) { return {q, zone_bits}; }
const Ball small_step = zone_number(Rational(1) / Rational(slong(1) << 50));

/// True if two numbers agree to 12 digits of 1.
bool agree(const Ball& a, const Ball& b) {
  return (zone_number(Rational(1) / Rational(1000000000000)) - (a - b).size()).is_positive();
}

TEST_CASE("integrals of a periodic traction agree with its expansion at infinity") {
  const Periodic claim = periodic_example(true);
  const PeriodicZone zone(claim, {}, zone_bits);
  const Wave T{zone_number(claim.traction[0]), zone_number(claim.traction[1])};
  Ball load;
  for (std::size_t k = 0; k < zone.arcs(); ++k) load += zone.cosine(k) * zone.over_arc(k, {&T}, integral_bits);
  const std::vector<Complex> constant = zone.expansion({}).front();
  const Ball expected = -(constant[0].im() * T[0] + constant[1].im() * T[1]);
  CHECK(zone.arcs() == 4);
  CHECK(overlap(load, expected));
  CHECK((zone_number(Rational(1) / Rational::parse("1e40", "")) - load.radius()).is_positive());
}

TEST_CASE("derivatives of a periodic zone are limits of differences") {
  const Periodic claim = periodic_example(false);
  const Wave T{zone_number(1), zone_number(Rational(3) / Rational(10)), zone_number(Rational(-1) / Rational(5)),
               zone_number(Rational(1) / Rational(10))};
  const std::vector<Ball> ends{zone_number(Rational(-1) / Rational(5)), zone_number(Rational(1) / Rational(5))};
  for (const std::size_t end : {std::size_t{0}, std::size_t{1}}) {
    std::vector<Ball> before = ends, after = ends;
    before[end] -= small_step;
    after[end] += small_step;
    const PeriodicZone zone(claim, ends, zone_bits), left(claim, before, zone_bits), right(claim, after, zone_bits);
    const std::size_t moved = zone.free_point(end);
    const auto quotient = [](const Ball& a, const Ball& b) { return (b - a) / (small_step + small_step); };
    const auto rows = zone.expansion(moved), low = left.expansion({}), high = right.expansion({});
    CHECK(rows.size() == 3);
    for (std::size_t n = 0; n < rows.size(); ++n) {
      for (std::size_t i = 0; i < T.size(); ++i) {
        CHECK(agree(rows[n][i].re(), quotient(low[n][i].re(), high[n][i].re())));
        CHECK(agree(rows[n][i].im(), quotient(low[n][i].im(), high[n][i].im())));
      }
    }
    for (std::size_t k = 0; k < zone.arcs(); ++k) {
      const auto loads = [&](const PeriodicZone& of) { return of.over_arc(k, {&T}, integral_bits); };
      CHECK(agree(zone.over_arc(k, {&T, false, moved}, integral_bits), quotient(loads(left), loads(right))));
    }
  }
}

}  // namespace
