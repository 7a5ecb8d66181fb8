// The facade agrees with problem files, laws and closed forms. The test includes only the facade's header.

#include <cmath>
#include <numeric>
#include <optional>
#include <steadyslide/steadyslide.hpp>
#include <string>
#include <thread>
#include <vector>

#include "doctest/doctest.h"

using namespace steadyslide;

namespace {

ProblemData coatings() { return {.load = 1, .friction = {"0.1", 0.5}, .jumps = {0}, .poisson = 0.2, .profile = "0"}; }

/// Contact with free ends, on both sides of a friction jump.
ProblemData parabola(const Exact& load = "0.2") {
  return {.load = load, .friction = {"0.1", "0.5"}, .jumps = {"0.1"}, .poisson = "0.3", .profile = "x^2/2"};
}

template <class Call>
std::string refusal(Call call) {
  try {
    call();
  } catch (const InvalidData& invalid) {
    return invalid.what();
  }
  return "accepted";
}

}  // namespace

TEST_CASE("ten lines to an answer") {
  const Solution solution = solve(coatings(), {.digits = 50});
  REQUIRE(solution.solved());
  CHECK(solution.method() == "closed-form");
  CHECK(solution.traction("1/2").digits == "-0.35655291651384204495378157903613372561292925249359");
  CHECK(solution.traction(0.5).value == -0.35655291651384204);
  CHECK(solution.traction(0.5).error < 1e-50);
  // Arrays have doubles only. Their errors include the rounding to double.
  const std::vector<double> x{0.3}, z{0.1};
  const Number in_array = solution.stress(x, z)[0].xx;
  CHECK(in_array.value == solution.stress(0.3, 0.1).xx.value);
  CHECK((in_array.error > 1e-20 && in_array.error < 1e-16));
}

TEST_CASE("a problem of data is the problem of its text, whatever its numbers are written as") {
  const Problem problem = coatings();
  CHECK(Problem::from_text(problem.text()).text() == problem.text());
  const Problem decimal = ProblemData{.load = 1.0,
                                      .friction = {"1/10", "5e-1"},
                                      .jumps = {"0"},
                                      .poisson = "1/5",
                                      .support = {-1, 1},
                                      .profile = "0*x"};
  CHECK(solve(decimal, {.digits = 30}).effective_friction().digits ==
        solve(problem, {.digits = 30}).effective_friction().digits);
}

TEST_CASE("layers, a period and harmonics are data") {
  const Problem layered = ProblemData{.load = 1,
                                      .friction = {"1/2"},
                                      .layers = {{.thickness = 1, .young = 1, .poisson = "0.3"}},
                                      .base = "rigid",
                                      .profile = "0"};
  CHECK(solve(layered).centre_of_pressure().value == doctest::Approx(-0.0087854184229).epsilon(1e-11));
  const Problem waves = ProblemData{.load = "1/100",
                                    .friction = {0},
                                    .gamma = 0,
                                    .period = 1,
                                    .support = {"-1/2", "1/2"},
                                    .harmonics = {{.n = 1, .cos = "-1/100"}}};
  const Solution solution = solve(waves);
  REQUIRE(solution.solved());
  // Westergaard: P = pi E* Delta sin^2(pi a/L) with c = 1 = 2/E*, so E* = 2.
  const double a = solution.contact()[0].right.x.value;
  CHECK(0.02 * M_PI * std::pow(std::sin(M_PI * a), 2) == doctest::Approx(0.01).epsilon(1e-12));
}

TEST_CASE("load, Coulomb's law and the slope hold") {
  const Solution solution = solve(parabola());
  REQUIRE(solution.solved());
  const std::vector<ContactComponent> contact = solution.contact();
  REQUIRE(contact.size() == 1);
  CHECK(solution.at(contact[0].right.x.value).cumulative_load.value == doctest::Approx(0.2).epsilon(1e-12));
  CHECK(contact[0].load.value == doctest::Approx(0.2).epsilon(1e-12));
  std::vector<double> places;
  for (int k = 1; k < 40; ++k) places.push_back(contact[0].left.x.value + contact[0].width.value * k / 40 + 1e-5);
  const std::vector<double> t = solution.traction(places);
  const std::vector<double> shear = solution.shear(places);
  const std::vector<double> slope = solution.slope(places);
  for (std::size_t k = 0; k < places.size(); ++k) {
    const double friction = places[k] < 0.1 ? 0.1 : 0.5;
    CHECK(shear[k] == doctest::Approx(-friction * t[k]).epsilon(1e-14));
    CHECK(solution.traction(places[k]).value == doctest::Approx(t[k]).epsilon(1e-12));
    CHECK(slope[k] == doctest::Approx(places[k]).epsilon(1e-9));  // the slope of the profile
    CHECK(std::abs(solution.gap(places[k]).value) < 1e-12);
  }
  CHECK(std::isnan(solution.gap(2).value));
}

TEST_CASE("exact data, residuals, and a start from a neighbour") {
  const Problem problem = parabola("1/3");
  CHECK(problem.load().text() == "1/3");
  REQUIRE(problem.friction().size() == 2);
  CHECK(problem.friction()[1].text() == "0.5");
  CHECK(problem.jumps()[0].text() == "0.1");
  CHECK(problem.support().second.text() == "1");
  const Solution before = solve(parabola("0.32")), cold = solve(problem), warm = solve(problem, {}, &before);
  CHECK(warm.residuals().equation < 1e-10);
  CHECK(warm.estimated_error().resultants < 1e-8);
  const Number one = cold.effective_friction(), other = warm.effective_friction();
  CHECK(std::abs(one.value - other.value) <= one.error + other.error);
}

TEST_CASE("displacements and the largest stress") {
  const Solution solution = solve(parabola());
  CHECK(solution.displacement(0, 0).x.value == 0);
  const Number down = solution.displacement("0.9", 0).z, u = solution.at("0.9").displacement;
  CHECK(std::abs(down.value + u.value) <= down.error + u.error);
  CHECK(solution.stress("0.2", 0).zz.value == doctest::Approx(solution.traction("0.2").value).epsilon(1e-13));
  const LargestStress largest = solution.max_stress("0.05");
  CHECK(largest.z.value >= 0.05);
  CHECK(largest.von_mises.value ==
        doctest::Approx(solution.stress(largest.x.value, largest.z.value).von_mises->value).epsilon(1e-12));
  REQUIRE(largest.unbounded_at.size() == 1);  // the jump, at which friction rises
  CHECK(largest.unbounded_at[0].value == doctest::Approx(0.1));
  const LargestStress average = solution.max_stress({}, "0.1");
  CHECK(average.unbounded_at.empty());
  CHECK(average.von_mises.value > largest.von_mises.value);
  CHECK(average.von_mises.error < 1e-9);
  CHECK(refusal([&] { solution.max_stress({}, 0); }) == "over: out of range; the length of a window is positive; 0");
  CHECK(refusal([&] { solution.displacement(0, -1); }) == "z: above the surface; a depth is at least 0; -1");
  CHECK(refusal([&] { solution.max_stress("-1"); }) == "depth: above the surface; a depth is at least 0; -1");
  const ProblemData reduced{.load = 1, .friction = {0}, .gamma = "0.2", .profile = "0"};
  CHECK(refusal([&] {
          solve(reduced).displacement(0, 1);
        }).starts_with("displacement: no displacement below the surface; "));
  CHECK(refusal([&] { solve(parabola(), {.iterations = 3}); }).starts_with("iterations: method without cells; "));
}

TEST_CASE("resultants belong together") {
  const Resultants of = solve(parabola()).resultants();
  CHECK(of.friction_force.value == doctest::Approx(of.effective_friction.value * of.normal.value));
  CHECK(of.mean_pressure.value == doctest::Approx(of.normal.value / of.real_contact_length.value));
  CHECK(of.load_share.size() == 2);
  CHECK(of.load_share[0].value + of.load_share[1].value == doctest::Approx(1));
  CHECK(of.largest_pressure.value.value == INFINITY);  // at the jump, at which friction rises
  CHECK(of.largest_pressure.x.value == doctest::Approx(0.1));
  CHECK(of.largest_pressure.exponent->value < 0);
}

TEST_CASE("data are refused as the command line refuses them") {
  ProblemData data = coatings();
  data.load = "-1";
  CHECK(refusal([&] { Problem{data}; }) == "load: load out of range; the load is positive; -1");
  CHECK(refusal([&] { Problem::from_text("load = 1\n", "p.toml"); }) ==
        "p.toml:1: half_space: missing; the table is required; absent");
  CHECK(refusal([] { solve(coatings(), {.digits = 0}); }) ==
        "digits: out of range; it is a whole number from 1 to 100; '0'");
  CHECK(refusal([] { solve(coatings()).traction("x"); }) ==
        "x: not a number; a number is written like 2, -0.25, 1e-3 or 1/3; 'x'");
  CHECK_THROWS_WITH_AS(read_problem("/no/file"), "/no/file: cannot be read: No such file or directory",
                       std::runtime_error);
}

TEST_CASE("exponents, their derivation and a proof") {
  const Problem problem = coatings();
  const std::vector<PossiblePoint> points = exponents(problem, 30);
  CHECK(points[0].symbolic == "-1/2 - arctan(3/80)/pi");
  CHECK(points[0].exponent->value == doctest::Approx(-0.5 - std::atan(3.0 / 80) / std::acos(-1)).epsilon(1e-15));
  CHECK(points[0].exponent->digits == "-0.51193103015721390799784273158");
  CHECK(points[0].exponent->error * 1e30 == doctest::Approx(5.12).epsilon(1e-3));
  CHECK(derivation(problem).find("edge, contact on the right") != std::string::npos);
  const Proof proof = solve(problem).certify();
  CHECK(proof.proved);
  CHECK(proof.certificate.find("\"exists\": true") != std::string::npos);
  CHECK(proof.unresolved_gaps.empty());
  // There is no proof of a solution with contact in a gap that is too short for numbers. The proof names the gap.
  const ProblemData notch{.load = 1000, .friction = {1}, .gamma = "0.5", .pieces = {{"1/4", "x/8"}, {1, "1/16 - x/8"}}};
  const Proof refused = solve(notch).certify();
  CHECK_FALSE(refused.proved);
  REQUIRE(refused.unresolved_gaps.size() == 1);
  CHECK(refused.unresolved_gaps[0].x.value == doctest::Approx(0.25).epsilon(1e-15));
  CHECK(refused.unresolved_gaps[0].log10_length < -1000);
}

TEST_CASE("periodic contact has a certificate that another program proves, or the reason why it has none") {
  const auto proof_of = [](const std::string& profile) {
    return solve(Problem::from_text("load = 1\n[half_space]\ngamma = 0.7\nperiod = 1\n[friction]\nvalues = [1]\n"
                                    "[indenter]\nsupport = [\"-0.3\", \"0.3\"]\nprofile = \"" +
                                        profile + "\"\n",
                                    "p.toml"))
        .certify();
  };
  const Proof punch = proof_of("0"), parabola = proof_of("x^2");
  CHECK_FALSE(punch.proved);
  CHECK(punch.reason == "steadyslide-check proves this certificate");
  CHECK(punch.certificate.find("\"kind\": \"periodic\"") != std::string::npos);
  CHECK(parabola.certificate.empty());
  CHECK(parabola.reason.starts_with("with a period there are certificates for flat punches that do not tilt and for"));
}

TEST_CASE("what solve warns of: a pressed notch whose gap has no number") {
  CHECK(solve(coatings()).warnings().empty());
  CHECK(solve(coatings()).unresolved_gaps().empty());
  const ProblemData notch{.load = 1000, .friction = {1}, .gamma = "0.5", .pieces = {{"1/4", "x/8"}, {1, "1/16 - x/8"}}};
  for (const int digits : {16, 50}) {
    const Solution solution = solve(notch, {.digits = digits});
    REQUIRE(solution.solved());
    const std::vector<UnresolvedGap> gaps = solution.unresolved_gaps();
    REQUIRE(gaps.size() == 1);
    CHECK(gaps[0].x.value == doctest::Approx(0.25).epsilon(1e-15));
    CHECK(gaps[0].log10_length < -1000);
    const std::vector<std::string> warnings = solution.warnings();
    REQUIRE(warnings.size() == 1);
    CHECK(warnings[0].starts_with("gaps over notches of the profile are shown as contact; "));
    CHECK(warnings[0].ends_with("x = 0.25 (about 1e" + std::to_string(std::lround(gaps[0].log10_length)) + ")"));
  }
}

TEST_CASE("a gap of 1e-195 is answered in double: an intensity of 1e160 does not ask for more digits") {
  const Problem notch = ProblemData{.load = "6.42392389782674",
                                    .friction = {"16/5", 4},
                                    .jumps = {0},
                                    .gamma = "1/2",
                                    .pieces = {{0, "x/5"}, {1, "-x/5"}}};
  const Solution solution = solve(notch);
  REQUIRE(solution.solved());
  REQUIRE(solution.contact().size() == 2);
  const Number intensity = solution.contact().front().right.intensity;
  CHECK(intensity.value > 1e150);
  CHECK(intensity.error < 1e-6 * intensity.value);
  // Fifty digits would give a smaller error.
  CHECK(intensity.error > 1e-14 * intensity.value);
}

TEST_CASE("on cells, too") {
  const Solution solution = solve(parabola(), {.method = "variational", .cells = 512});
  CHECK(solution.method() == "variational");
  CHECK(solution.effective_friction().value ==
        doctest::Approx(solve(parabola()).effective_friction().value).epsilon(0.01));
}

TEST_CASE("auto takes cells where the Riemann-Hilbert method fails, and says so: a wedge under large friction") {
  ProblemData data{.load = "0.1", .friction = {16}, .gamma = "0.5"};
  data.pieces = {{0, "-x"}, {1, "x"}};
  const Problem wedge(data);
  const Solution failed = solve(wedge, {.method = "riemann-hilbert"});
  REQUIRE_FALSE(failed.solved());
  const Solution found = solve(wedge);
  CHECK(found.solved());
  CHECK(found.method() == "variational");
  const auto warnings = found.warnings();
  REQUIRE_FALSE(warnings.empty());
  CHECK(warnings[0] == "method variational: the Riemann-Hilbert method did not converge; " + failed.failed_condition());
}
