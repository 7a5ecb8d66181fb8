// Estimated errors of random problems are at least as large as the true ones, and not a thousand times as large.

#include "known_limits/error_estimates.hpp"

#include "numeric/riemann_hilbert/riemann_hilbert.hpp"
#include "support/numeric_test.hpp"
#include "support/random_contact.hpp"

TEST_CASE("the first eight, and those whose estimates have been too small") {
  EstimateAudit audit;
  // 5606: loads beside a break; their rule does not know the traction's own error. 4360, 6829, 9274: loads, and 4428:
  // gaps, which a free end beside a short piece changes by more than their size. 4921: components with only edges; the
  // gap between them decides their coefficients. 36: displacements beyond an edge with a power near -1. 8:
  // displacements in the contact of a profile of high degree. 48: slopes of the tangential displacement; their
  // integrals do not know the traction's error either. 520, 1708: tangential slopes at jumps where t vanishes, but its
  // rounding error does not; the powers are 2e-4 and 0.18. 8311: a free end just beyond a break, where the difference
  // of the two slopes has lost digits.
  for (const std::uint64_t i :
       {0U, 1U, 2U, 3U, 4U, 5U, 6U, 7U, 5606U, 4360U, 6829U, 9274U, 4428U, 4921U, 36U, 8U, 48U, 520U, 1708U, 8311U}) {
    audit_estimates(first_listed_seed + i, audit);
  }
  MESSAGE(audit.text());
  for (const std::string& line : audit.dishonest) FAIL_CHECK(line);
  CHECK(audit.failure() == "");
}

namespace {

/// Contact on a short piece, which ends at a gap beside the step.
ContactProblem short_piece(const Rational& length) {
  const auto line = [](const Rational& slope, const Rational& height) { return Polynomial({height, slope}); };
  const Indenter indenter(
      -1, {{0, line(-0.3_r, 0)}, {length, line(0.1_r, 0)}, {1, line(0.9_r, Rational(-9 * length / 10))}});
  return {Elasticity::reduced(Rational(2, 7)), FrictionProfile({0.3_r}), indenter, 1};
}

/// The same with a gap of 1e-18 beside friction 6: Newton's last steps are as long as the gap.
ContactProblem shortest_gap() {
  const FrictionProfile friction({0.58_r, 0, 6, 0.83_r, 3.9_r},
                                 {-1.8125_r, -1.499999875_r, -1.492187375_r, -1.34375_r});
  const Indenter indenter(-2, {{-1.5_r, Polynomial({-7.875_r, -5.25_r})},
                               {-1.499999875_r, Polynomial({7.875_r, 5.25_r})},
                               {-1, Polynomial({1.125000560625_r, 0.75_r})}});
  return {Elasticity(Solid(-0.39_r, 1), Plane::stress), friction, indenter, 0.48_r};
}

}  // namespace

TEST_CASE("intensities beside a step, over gaps much shorter than the contact") {
  EstimateAudit audit;
  audit_solutions("1e-6", short_piece(1e-6_r), false, audit);
  audit_solutions("1e-8", short_piece(1e-8_r), false, audit);
  audit_solutions("1e-18", shortest_gap(), false, audit);
  MESSAGE(audit.text());
  for (const std::string& line : audit.dishonest) FAIL_CHECK(line);
  CHECK(audit.failure() == "");
}

TEST_CASE("flat punches with short ramps, whose slopes are small differences") {
  const Rational left = -0.625_r, right = 0.875_r;
  const auto parabola = [](const Rational& c) { return Polynomial({0.064_r * c * c, -0.128_r * c, 0.064_r}); };
  EstimateAudit audit;
  const std::pair<const char*, const char*> lengths_and_loads[] = {
      {"1e-2", "3e-6"}, {"1e-3", "3e-6"}, {"1e-4", "1e-7"}, {"1e-7", "3e-10"}};
  for (const auto& [length, load] : lengths_and_loads) {
    const Rational l = parse_rational(length);
    const Indenter indenter(left - l, {{left, parabola(left)}, {right, Polynomial({0})}, {right + l, parabola(right)}});
    const ContactProblem problem(Elasticity(Solid(0.38_r, 1), Plane::strain), FrictionProfile({0, 0.64_r}, {0}),
                                 indenter, parse_rational(load));
    audit_solutions(length, problem, false, audit);
  }
  MESSAGE(audit.text());
  for (const std::string& line : audit.dishonest) FAIL_CHECK(line);
  CHECK(audit.failure() == "");
}

TEST_CASE("one problem of each family") {
  EstimateAudit audit;
  for (const auto& [family, name] : contact_families) {
    // Their 50 digits take a minute. Run error_estimates many-wedges FIRST COUNT for them.
    if (family == ContactFamily::usual || family == ContactFamily::many_wedges) continue;
    audit_estimates(first_listed_seed, audit, family);
  }
  // 7: the shear beside a wedge, where all digits of the pressure are known. 5168: slopes in the contact, at places
  // that rounding shifts.
  for (const std::uint64_t i : {7U, 5168U}) {
    audit_estimates(first_listed_seed + i, audit, ContactFamily::neighbouring_frictions);
  }
  // Two zones with the same largest pressure.
  audit_estimates(first_listed_seed + 5168, audit, ContactFamily::limits_of_poisson);
  MESSAGE(audit.text());
  for (const std::string& line : audit.dishonest) FAIL_CHECK(line);
  CHECK(audit.failure() == "");
}

TEST_CASE("the height and the intensities of a gap of 1e-164 over a notch") {
  // random_contact notches 20165090, with 50 digits
  const Polynomial right({0.380859375_r, 0.328125_r, 0.09375_r});
  const Indenter indenter(
      -2.5_r,
      {{-1.5_r, Polynomial({-0.046875_r, -0.03125_r})}, {-0.75_r, Polynomial({0.375_r, 0.25_r})}, {-0.5_r, right}});
  const FrictionProfile friction({4, 0.89_r, 2.9_r, 0.34_r}, {-1.359375_r, -0.8671875_r, -0.71484375_r});
  const ContactProblem problem(Elasticity(Solid(-0.55_r, 1), Plane::strain), friction, indenter, 1.965_r,
                               Sliding::minus_x);
  const auto solution = numeric::riemann_hilbert<double>(problem).solution;
  REQUIRE(solution);
  EstimateAudit audit;
  const Real50 gap("9.4813525799013471576107146372350371198317939959348e-167");
  compare_estimate("gap", solution->at(-0.75_r).gap.value(), {gap, Real50(0)}, audit, "gap");
  const Real50 theta("6.0867054044808263213580469462251441077244208926579e136");
  compare_estimate("intensity", solution->singular_points()[5].intensity, {theta, Real50(0)}, audit, "intensity");
  for (const std::string& line : audit.dishonest) FAIL_CHECK(line);
  CHECK(audit.honest() == 2U);
}

TEST_CASE("intensities at and far from a gap of 1e-193 or 1e-209, where rounding adds up in the integrals") {
  // Seven hundred panels beside the notch have nearly the same integral, so each addition loses as much as the others.
  // At the edges the terms of the sums cancel to one part in seventy.
  EstimateAudit audit;
  const auto compare = [&audit](unsigned i, std::size_t point, const char* digits, double relative) {
    const auto solution =
        numeric::riemann_hilbert<double>(random_contact(first_listed_seed + i, ContactFamily::notches)).solution;
    REQUIRE(solution);
    const Estimate<double> theta = solution->singular_points()[point].intensity;
    const Real50 truth(digits);
    compare_estimate("intensity", theta, {truth, Real50(0)}, audit, "intensity " + std::to_string(point));
    CHECK(abs(Real50(theta.value) - truth) <= relative * truth);
  };
  compare(75, 0, "0.053646663634323305637757756012875840191854947087505", 2e-14);
  compare(110, 0, "0.059008343379852844953024955596065615093613848344753", 2e-14);
  compare(75, 3, "1.038721179216435127217970173573789722602852504312e172", 2e-11);
  for (const std::string& line : audit.dishonest) FAIL_CHECK(line);
  CHECK(audit.honest() == 3U);
}

TEST_CASE("control: an end that is off by more than its estimate is seen") {
  EstimateAudit audit;
  compare_estimate("place", {1.0, 1e-16}, {Real50(1), Real50(0)}, audit);
  compare_estimate("place", {1.0, 1e-16}, {Real50(1) + Real50(0.9e-16), Real50(0)}, audit);
  CHECK(audit.dishonest.empty());
  compare_estimate("place", {1.0, 1e-16}, {Real50(1) + Real50(1.1e-16), Real50(0)}, audit);
  CHECK(audit.dishonest.size() == 1U);
  compare_estimate("place", {1.0, std::nan("")}, {Real50(1), Real50(0)}, audit);
  CHECK(audit.dishonest.size() == 2U);
  compare_estimate("place", {std::nan(""), 1.0}, {Real50(1), Real50(0)}, audit);
  CHECK(audit.dishonest.size() == 3U);
  CHECK(audit.honest() == 2U);
  CHECK(audit.failure() != "");
}

TEST_CASE("control: estimates that cover everything are too large, and a few are no audit") {
  EstimateAudit audit;
  for (int i = 0; i < 50; ++i) compare_estimate("place", {1.0, 1e-12}, {Real50(1) + Real50(1e-16), Real50(0)}, audit);
  audit.problems = audit.compared = 1;
  CHECK(audit.dishonest.empty());
  CHECK(audit.failure() == "estimates are too large");
  CHECK(audit.failure(largest_median(ContactFamily::notches)) == "estimates are too large");
  CHECK(audit.failure(largest_median(ContactFamily::many_wedges)) == "");
  audit.numbers["place"].too_large.assign(50, 2.0);
  CHECK(audit.failure() == "");
  audit.problems = 2;
  CHECK(audit.failure() == "");
  audit.problems = 3;
  CHECK(audit.failure() == "too little was compared");
}
