// Wrong certificates. A checker that leaves out one term would accept one of them.

#include <doctest/doctest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "checker/cells.hpp"
#include "checker/krawczyk.hpp"
#include "checker/reader.hpp"
#include "checker/signs.hpp"

namespace {

using namespace steadyslide::checker;
using nlohmann::json;

json certificate_of(const std::string& name) {
  std::ifstream file(std::string(STEADYSLIDE_CERTIFICATES) + "/" + name + ".json");
  return json::parse(file);
}

/// Returns the reason of the refusal; empty if the certificate is proved.
std::string refusal(const json& document) {
  try {
    const Reader at = Reader::of_json(document.dump(), "test");
    if (document["kind"] == "cells") {
      prove_cells(Cells::of_certificate(at));
      return {};
    }
    const Certificate c = Certificate::read(at);
    const ReducedProblem problem(c.problem, c.origin, c.unit);
    for (const Box& box : c.boxes) {
      const Krawczyk zero = prove_zero(problem, box, c.bits);
      prove_signs(problem, zero.image, zero.bits);
    }
    return {};
  } catch (const Unproved& error) {
    return error.what();
  }
}

void refused_for(const json& document, const std::string& words) {
  const std::string said = refusal(document);
  CHECK_MESSAGE(said.find(words) != std::string::npos, said);
}

std::string dumped(const Ball& x) {
  char* text = arb_dump_str(x.get());
  std::string result = text;
  flint_free(text);
  return result;
}

/// Widens by 2^exponent the offsets of the free ends, and by 2^of_q those of q, around their midpoints.
void widen(json& document, int exponent, int of_q) {
  const auto around = [](const json& ball, int e) {
    return dumped(Ball::parse(ball, 4096).middle().widened(Ball(std::ldexp(1, e))));
  };
  for (json& point : document["points"]) {
    if (point.contains("log_offset")) point["log_offset"] = around(point["log_offset"], exponent);
  }
  for (json& coefficient : document["q"]) coefficient = around(coefficient, of_q);
}

}  // namespace

TEST_CASE("control: certificates are proved as they are") {
  for (const char* name : {"quartic_left_bump", "gap_that_narrows", "two_bumps", "two_bowls", "rounded_wedge.loads"})
    CHECK_MESSAGE(refusal(certificate_of(name)).empty(), name);
}

TEST_CASE("a second bump beyond the last end of contact, in the one segment there is") {
  // The end of the support moves from 0 to 2. The free end keeps its place.
  json c = certificate_of("quartic_left_bump");
  c["problem"]["indenter"]["pieces"][0]["to"] = "2";
  json& offset = c["points"][2]["log_offset"];
  const Ball old = Ball::parse(offset, 231);
  const Rational unit = Rational::parse(c["frame"]["unit"], "unit");
  const Ball moved = log(exp(old.middle()) + Ball(Rational(2) / unit, 231)).rounded(200);
  offset = dumped(moved.middle().widened(old.radius()));
  refused_for(c, "gap");
}

TEST_CASE("a bump of another piece that reaches through the surface within an interval") {
  json c = certificate_of("gap_that_narrows");
  c["problem"]["load"] = "1/100";
  c["problem"]["indenter"]["pieces"][1]["profile"] =
      json::array({"3/10", "-3", "6"});  // -0.075 at 1/4, 3/10 at 0 and at 1/2
  refused_for(c, "gap");
  c["problem"]["indenter"]["pieces"][1]["profile"] = json::array({"3/10", "-2", "4"});  // 0.05 at 1/4
  CHECK(refusal(c).empty());
}

TEST_CASE("a bump of another piece, away from the contact's end, that reaches through the surface within an interval") {
  json c = certificate_of("two_bowls");
  // 10 (x - 7/10)^2 + 1/10 where the surface lies above 0.11, and the same shifted upwards
  c["problem"]["indenter"]["pieces"][1]["profile"] = json::array({"5", "-14", "10"});
  refused_for(c, "gap");
  c["problem"]["indenter"]["pieces"][1]["profile"] = json::array({"5.1", "-14", "10"});
  CHECK(refusal(c).empty());
}

TEST_CASE("a box so wide that the conditions are no longer linear in it") {
  json c = certificate_of("two_bumps");
  widen(c, -9, -13);
  CHECK(refusal(c).empty());
  widen(c, -6, -10);
  refused_for(c, "Krawczyk");
}

TEST_CASE("an interval of loads three times as long as its box is for") {
  json c = certificate_of("rounded_wedge.loads");
  c["problem"]["loads"] = c["boxes"][0]["loads"] = json::array({"0.997", "1.003"});
  refused_for(c, "Krawczyk");
}

TEST_CASE("Krawczyk's image has the radius of the conditions") {
  // x^2 - 2 = 0 about 3/2 +- 1/4: F(v) = 1/4, F'(V) = 3 +- 1/2
  const std::vector<Ball> V{Ball(1.5).widened(Ball(0.25)).rounded(100)};
  const auto image = [&](const Ball& F) {
    return krawczyk_image(V, {F.rounded(100)}, {{Ball(3).widened(Ball(0.5)), Ball()}}, Ball(), 100)[0];
  };
  CHECK(V[0].contains_inside(image(Ball(0.25))));
  CHECK((image(Ball(0.25).widened(Ball(1))).radius() - Ball(0.33)).is_positive());
  CHECK_FALSE(V[0].contains_inside(image(Ball(0.25).widened(Ball(1)))));
}

TEST_CASE("Krawczyk's image of conditions whose sizes are far apart") {
  // x + 2^200 y = 0 and x + y = 0: without scaling of the rows, pivoting loses the inverse's first entry, -2^-200,
  // below 100 bits.
  const Ball large = Ball(std::ldexp(1, 200)).rounded(100);
  const std::vector<Ball> V(2, Ball().widened(Ball(0.25)).rounded(100));
  const auto image = [&](const Ball& F) {
    return krawczyk_image(V, {F * large, F}, {{Ball(1), large, Ball()}, {Ball(1), Ball(1), Ball()}}, Ball(), 100);
  };
  for (const std::size_t i : {0U, 1U}) CHECK(V[i].contains_inside(image(Ball(0.125).rounded(100))[i]));
  CHECK_FALSE(V[1].contains_inside(image(Ball(0.375).rounded(100))[1]));
}

TEST_CASE("twelve zones, each seen by the others as a small difference of large terms") {
  const json c = certificate_of("twelve_zones");
  const auto signs_of = [](const json& document) {
    const Certificate read = Certificate::read(Reader::of_json(document.dump(), "test"));
    return prove_signs(ReducedProblem(read.problem, read.origin, read.unit), read.boxes[0], 24);
  };
  const Signs signs = signs_of(c);
  CHECK(signs.bits == 24);
  CHECK(signs.in_gaps < 200);
  // The fourth piece, tilted: the traction of its zone is tension at an end.
  json wrong = c;
  wrong["claims"]["unique_by_theorem_1"] = false;
  REQUIRE(wrong["problem"]["indenter"]["pieces"][3]["profile"] == json::array({"12.5", "5", "0.5"}));
  wrong["problem"]["indenter"]["pieces"][3]["profile"][1] = "11/2";
  CHECK_THROWS_AS(signs_of(wrong), Refuted);
}

TEST_CASE("a sum that is negative at one end of its range only is not negative") {
  // R + S phi, phi from phi1 to 0 or to infinity
  CHECK(negative_between(Ball(-1), Ball(2), Ball(0.25), false));
  CHECK_FALSE(negative_between(Ball(-1), Ball(2), Ball(1), false));
  CHECK_FALSE(negative_between(Ball(1), Ball(-3), Ball(1), false));
  CHECK(negative_between(Ball(1), Ball(-3), Ball(1), true));
  CHECK_FALSE(negative_between(Ball(1), Ball(-3), Ball(0.25), true));
  CHECK_FALSE(negative_between(Ball(-1), Ball(2), Ball(0.25), true));
}

TEST_CASE("an energy below the true one by less than the far nodes' Taylor polynomials are off") {
  // One cell of sixteen, [j, j + 1], has all pressure. The profile is 10 up to j + 2, falls to 0 at y0 = j + 3 + 1/256
  // and rises beyond. So the lowest gap is the one at y0: with c = P = 1 and a = 1/256
  // E = <H, p> - min H = 10 + 1/(2 pi) + ((3 + a) log(3 + a) - (2 + a) log(2 + a))/pi.
  // Seen from the cell that contains y0, node j is a far one, at the distance 7/2: its polynomial is 1e-9/pi too low.
  json c = json::parse(R"({"certificate": 1, "kind": "cells", "generator": "test 0.0.0",
    "problem": {"load": "1", "load_at": null, "sliding": "+x", "gamma": "0", "compliance": "1",
      "friction": {"values": ["0"], "jumps": []},
      "indenter": {"left": "0", "pieces": [{"to": "6", "profile": ["10"]},
        {"to": "1793/256", "profile": ["17930/257", "-2560/257"]}, {"to": "16", "profile": ["-44825/64", "100"]}]}},
    "pressures": [0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0], "reaches": [],
    "claims": {"load_share": [["0", "1"]], "effective_friction": ["0", "0"]}})");
  const Ball pi = Ball::pi(200);
  const Ball far = Ball(3 + 1. / 256).rounded(200), near = Ball(2 + 1. / 256).rounded(200);
  const Ball energy = Ball(10) + Ball(0.5) / pi + (far * log(far) - near * log(near)) / pi;
  const auto claimed = [&](double more) {
    // As a fraction with the denominator 2^50.
    Ball scaled = (energy + Ball(more)) * Ball(std::ldexp(1, 50));
    fmpz_t n;
    fmpz_init(n);
    arf_get_fmpz(n, arb_midref(scaled.get()), ARF_RND_NEAR);
    char* text = fmpz_get_str(nullptr, 10, n);
    const std::string result = std::string(text) + "/1125899906842624";
    flint_free(text);
    fmpz_clear(n);
    return result;
  };
  c["energy"] = claimed(1e-8);
  CHECK(refusal(c).empty());
  c["energy"] = claimed(-1e-10);
  refused_for(c, "energy");
}

TEST_CASE("an energy below the true one, where the gap is lowest beside a node and not at the ends of an interval") {
  // Cell [4, 5] has all pressure. With x = y - 5 the gap from there to 6 is 0.418 x + (x log x - (1+x) log(1+x))/pi: 0
  // at 0, -0.0949 at 1/2, and -0.099723 at 0.36792, where x log x is nearly -1/e. The mean under the pressure is
  // 1/(2 pi).
  json c = json::parse(R"({"certificate": 1, "kind": "cells", "generator": "test 0.0.0",
    "problem": {"load": "1", "load_at": null, "sliding": "+x", "gamma": "0", "compliance": "1",
      "friction": {"values": ["0"], "jumps": []},
      "indenter": {"left": "0", "pieces": [{"to": "3", "profile": ["10"]}, {"to": "4", "profile": ["40", "-10"]},
        {"to": "5", "profile": []}, {"to": "6", "profile": ["-2.09", "0.418"]},
        {"to": "16", "profile": ["-59.582", "10"]}]}},
    "pressures": [0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0], "energy": "0.25888", "reaches": [],
    "claims": {"load_share": [["0", "1"]], "effective_friction": ["0", "0"]}})");
  CHECK(refusal(c).empty());
  c["energy"] = "0.2562";
  refused_for(c, "energy");
}
