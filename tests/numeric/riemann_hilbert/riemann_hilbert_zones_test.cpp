// Many contact zones: between them the fundamental solution is near 1, and each has a pivot
// (signed_fundamental_solution.hpp).

#include <random>

#include "model/most_components.hpp"
#include "numeric/riemann_hilbert/gap_integral.hpp"
#include "numeric/variational/variational_inequality.hpp"
#include "support/solved_contact.hpp"

namespace {

struct Zones {
  const char* name;
  ContactProblem problem;
  bool in_digits = false;  ///< true: also test in 50 digits
};

/// Parabolas side by side over [0, n], with a free zone under each.
Indenter bumps(int n) {
  std::vector<Indenter::Piece> pieces;
  for (int i = 0; i < n; ++i) {
    const Rational centre = Rational(2 * i + 1, 2);
    pieces.push_back({i + 1, Polynomial({centre * centre, -2 * centre, 1})});
  }
  return {0, std::move(pieces)};
}

std::vector<Zones> zone_cases() {
  const Polynomial flat, raised({1}), rising({0.8_r, 0.8_r}), bump({2.25_r, -3, 1});
  const Indenter teeth(-3, {{-2, flat}, {-1, raised}, {0, flat}, {1, raised}, {2, flat}});
  const Indenter mixed(-3, {{-2, flat}, {-1, raised}, {0, rising}, {1, raised}, {2, bump}});
  return {{"free zones, a jump in one", reduced({0.3_r, 1, 0.2_r}, {0.6_r, 1.1_r}, bumps(3), 0.2_r)},
          {"free zones, one of them up to an edge", reduced({0.3_r}, {}, bumps(4), 0.7_r)},
          {"teeth", reduced({0.3_r, 1}, {-0.3_r}, teeth, 1)},
          {"no end, one end and both are free", reduced({0.4_r, 1, 0.2_r}, {-2.5_r, 0.5_r}, mixed, 1)},
          {"free zones under a load line", reduced({0.3_r, 0.5_r}, {2}, bumps(3), 0.2_r, 1.4_r)},
          {"zones of all kinds under a load line", reduced({0.4_r, 1}, {0.5_r}, mixed, 1, -0.8_r), true}};
}

/// A solution whose form has a pivot in every component, found from a contact with lengths that are wrong by the
/// fraction `error`.
template <Real R>
struct Pivoted {
  RoundedProblem<R> problem;
  JacobiRules<R> rules;
  SearchResult<R> found;
  TractionRepresentation<R> form;

  Pivoted(const RiemannHilbertSolution<R>& known, const ContactProblem& data, double error)
      : problem(data, known.problem().frame(), 0),
        found(search_contact(problem, ContactState<R>::initial(problem, perturbed(known, error), R(0)), rules)),
        form(problem, found.state.set, found.state.q, found.state.tilt, rules) {}

  ContactSet<R> perturbed(const RiemannHilbertSolution<R>& known, double error) const {
    ContactSet<R> set = ContactSet<R>::converted(problem, known.form().set());
    std::vector<R> steps;
    for (const std::size_t j : set.movable()) {
      const R sign = steps.size() % 3 == 1 ? -1 : 1;
      steps.push_back(sign * error * std::min(set.length(j - 1), set.length(j)));
    }
    set.move(steps);
    return set;
  }
};

template <Real R>
void is_near(const R& a, const R& b, const R& scale, double tolerance_in_epsilon) {
  using std::abs;
  CHECK(static_cast<double>(abs(a - b) / (scale * epsilon<R>())) < tolerance_in_epsilon);
}

void forces_agree(const ContactSolution<double>& a, const ContactSolution<double>& b, double tolerance) {
  const auto ours = a.resultants(), theirs = b.resultants();
  CHECK(ours.load_share[0].value == doctest::Approx(theirs.load_share[0].value).epsilon(tolerance));
  CHECK(ours.centre_of_pressure.value == doctest::Approx(theirs.centre_of_pressure.value).epsilon(tolerance));
}

}  // namespace

TEST_CASE_TEMPLATE("a pivot in each component, or one fundamental solution of all", R, double, Real50) {
  for (const Zones& c : zone_cases()) {
    const std::string name = c.name;
    CAPTURE(name);
    if (!std::same_as<R, double> && !c.in_digits) continue;
    const auto known = solved<R>(c.problem);
    REQUIRE(known->form().y().pivots().empty());
    const TractionRepresentation<R>& one = known->form();
    const Pivoted<R> pivoted(*known, c.problem, 0.02);
    const TractionRepresentation<R>& many = pivoted.form;
    REQUIRE(pivoted.found.failed_condition == "");
    REQUIRE(many.y().pivots().size() == known->contact().size());
    REQUIRE(many.set().points().size() == one.set().points().size());
    constexpr double few = 3000;
    for (std::size_t j = 0; j < one.set().points().size(); ++j) {
      is_near(many.set().x(j), one.set().x(j), R(1), few);
    }
    is_near(many.tilt(), one.tilt(), R(1), few);
    is_near(many.moment_of_load().value, one.moment_of_load().value, one.problem().load(), few);
    using std::abs;
    R highest = 0;
    for (std::size_t k = 0; k < one.set().segments(); ++k) {
      for (const double part : {1e-4, 0.01, 0.3, 0.5, 0.6, 0.97, 0.9999}) {
        const auto at = [&](const ContactSet<R>& set) { return beside(set, k, Side::right, R(part * set.length(k))); };
        const SurfacePoint<R> here = at(one.set()), there = at(many.set());
        const R t = one.traction(here).value;
        highest = std::max(highest, R(-t));
        is_near(many.traction(there).value, t, std::max(R(1), R(-t)), few);
        const R slope = one.surface_slope(here).value;
        is_near(many.surface_slope(there).value, slope, std::max(R(1), R(abs(slope))), few);
      }
      // Gaps over whole segments, starting at the left end of the gap.
      std::size_t j = k;
      while (j > 0 && !one.set().point(j).is_end()) --j;
      if (one.set().in_contact(k) || !one.set().point(j).is_end()) continue;
      const auto at = [&](const ContactSet<R>& set) { return beside(set, k, Side::right, R(set.length(k) * 3 / 4)); };
      is_near(GapIntegral<R>(many, j).reduced_gap(at(many.set())).value,
              GapIntegral<R>(one, j).reduced_gap(at(one.set())).value, R(1), few);
    }
    CHECK(highest > 0);
    // The control: the effect of a millionth of the load is noticed.
    const ContactProblem heavier = c.problem.with_load(c.problem.load() * 1.000001_r);
    const Pivoted<R> changed(*known, heavier, 0);
    std::size_t k = 0;
    while (!one.set().in_contact(k)) ++k;
    const auto middle = [k](const TractionRepresentation<R>& form) {
      return form.traction(beside(form.set(), k, Side::right, R(form.set().length(k) / 2))).value;
    };
    CHECK(abs(middle(changed.form) - middle(one)) > R(1e-9));
  }
}

TEST_CASE_TEMPLATE("a series of far zones includes the errors of small differences of slopes", R, Real50, Real100) {
  // The slopes 1 and 1 + 1e-20 differ by 1e-20, with an error of about epsilon.
  const Indenter lands(-3, {{-1, Polynomial({0, 1})}, {1, Polynomial({9})}, {3, Polynomial({0, 1 + 1e-20_r})}});
  const ContactProblem problem = reduced({0.3_r}, {}, lands, 1);
  const RoundedProblem<R> rounded(problem, {0, 3}, 1);
  const ContactSet<R> contact(rounded, {{-1, -1.0 / 3, true, true}, {1.0 / 3, 1, true, true}});
  JacobiRules<R> rules;
  const SignedFundamentalSolution<R> y(rounded, contact);
  REQUIRE(y.pivots().size() == 2);
  const ContactQuadrature<R> quadrature(y, rules);
  const SurfacePoint<R> at = beside(contact, 0, Side::right, R(R(1) / 6));
  const Estimate<R> by_panels = quadrature.cauchy(y.slope_at(0), at);
  CHECK(static_cast<double>(by_panels.error) > 0.01);
  CHECK(abs(static_cast<double>(by_panels.value)) < 1e-19);
  Estimate<R> by_series = by_panels;
  for (int i = 0; i < 30; ++i) by_series = quadrature.cauchy(y.slope_at(0), at);
  CHECK(by_series.error != by_panels.error);
  CHECK(by_series.error >= by_panels.error);
  CHECK(by_series.error <= 3 * by_panels.error);
}

TEST_CASE("equal bumps without friction are symmetric, however many there are") {
  for (const int n : {5, 24, 64}) {
    CAPTURE(n);
    const auto found = solved<double>(reduced({0}, {}, bumps(n), Rational(n, 40)));
    const auto zones = found->contact();
    REQUIRE(zones.size() == static_cast<std::size_t>(n));
    for (std::size_t i = 0; i < zones.size(); ++i) {
      const auto& mirror = zones[zones.size() - 1 - i];
      CHECK(zones[i].left.x.value + mirror.right.x.value == doctest::Approx(n).epsilon(1e-13));
      CHECK(zones[i].left.intensity.value == doctest::Approx(mirror.right.intensity.value).epsilon(1e-9));
    }
    // The outer bumps carry more load.
    const auto width = [&](std::size_t i) { return zones[i].right.x.value - zones[i].left.x.value; };
    for (std::size_t i = 0; i + 1 < zones.size() / 2; ++i) CHECK(width(i) > width(i + 1));
  }
}

TEST_CASE("64 zones are where cells see them") {
  const ContactProblem problem = reduced({0.3_r, 0.2_r}, {30.5_r}, bumps(64), 1);
  const auto found = solved<double>(problem);
  const auto cells = variational_inequality(problem, {.cells = 32768}).solution;
  const auto zones = found->contact();
  const auto seen = cells->contact();
  REQUIRE(zones.size() == 64);
  REQUIRE(seen.size() == 64);
  constexpr double cell = 64.0 / 32768;
  double sum = 0;
  for (std::size_t i = 0; i < zones.size(); ++i) {
    CHECK(std::abs(zones[i].left.x.value - seen[i].left.x.value) < 1.5 * cell);
    CHECK(std::abs(zones[i].right.x.value - seen[i].right.x.value) < 1.5 * cell);
    sum += zones[i].right.x.value - zones[i].left.x.value;
  }
  CHECK(sum < 64);
  forces_agree(*found, *cells, 1e-4);
}

TEST_CASE("rough traces: many zones of many pieces, with gaps shorter than any cell between them") {
  std::mt19937_64 random(2016);
  // The smoother a trace is, the shorter are its gaps. Some are too short for numbers.
  std::size_t unresolved = 0;
  for (const auto& trace : {std::pair(100, 0.3), {200, 0.05}, {400, 0.05}, {1000, 0.1}}) {
    const int n = trace.first;
    const double roughness = trace.second;
    CAPTURE(n);
    CAPTURE(roughness);
    // A parabola with a random height at each of its points.
    const auto height = [&](int i) {
      const double x = 2.0 * i / n - 1;
      const double rough = std::generate_canonical<double, 53>(random) * roughness / n;
      return Rational(std::llround(1e9 * (x * x / 2 + rough)), 1'000'000'000);
    };
    std::vector<Indenter::Piece> pieces;
    Rational left = height(0);
    for (int i = 1; i <= n; ++i) {
      const Rational right = height(i);
      const Rational from(2 * (i - 1) - n, n), to(2 * i - n, n);
      const Rational slope = (right - left) / (to - from);
      pieces.push_back({to, Polynomial({left - slope * from, slope})});
      left = right;
    }
    const ContactProblem problem = reduced({0.1_r, 0.4_r}, {0}, Indenter(-1, pieces), 0.1_r);
    const auto found = riemann_hilbert<double>(problem).solution;
    REQUIRE(found->failed_condition() == "");
    const auto zones = found->contact();
    CHECK(zones.size() > 5);
    double shortest = 1;
    for (std::size_t i = 0; i + 1 < zones.size(); ++i) {
      shortest = std::min(shortest, zones[i + 1].left.x.value - zones[i].right.x.value);
    }
    CHECK(shortest < 1e-6);
    const auto residuals = found->residuals();
    CHECK(residuals.equation < 1e-11);
    unresolved += found->unresolved_gaps().size();
    CHECK(residuals.load < 1e-11);
    CHECK(residuals.penetration < 1e-12);
    CHECK(residuals.tension == 0);
    CHECK(found->estimated_error().traction < 0.01);
    const auto cells = variational_inequality(problem, {.cells = 65536}).solution;
    forces_agree(*found, *cells, 1e-3);
  }
  CHECK(unresolved > 0);
}

// Chebyshev's polynomial T_n on [-1, 1] takes its least value, -1, at every second of the places cos(pi k/n). Under a
// light load all of them touch. They are as many as the bound allows: in each of its cases a smaller bound is refuted.
TEST_CASE("Chebyshev profiles have as many components as the bound allows, under any friction") {
  Polynomial last({1}), chebyshev({0, 1});
  for (std::size_t n = 1; n <= 6; ++n) {
    for (const int sign : {1, -1}) {
      const Indenter indenter(-1, {{1, Polynomial({sign}) * chebyshev}});
      for (const std::vector<Rational>& s : {std::vector<Rational>{0.5_r, 0, 1.5_r}, {2, 1, 0.2_r}}) {
        const ContactProblem problem = reduced(s, {-0.6_r, 0.1_r}, indenter, 1e-4_r);
        CAPTURE(n);
        CAPTURE(sign);
        CHECK(solved<double>(problem)->contact().size() == most_components(problem));
      }
    }
    const Polynomial next = Polynomial({0, 2}) * chebyshev - last;
    last = chebyshev;
    chebyshev = next;
  }
  // A punch in full contact, and a notch between two of them.
  for (const Indenter& indenter : {one_piece(-1, 1, {3}), roof(1, -1)}) {
    const ContactProblem problem = reduced({0.5_r, 0.1_r}, {0.1_r}, indenter, 0.01_r);
    CHECK(solved<double>(problem)->contact().size() == most_components(problem));
  }
}
