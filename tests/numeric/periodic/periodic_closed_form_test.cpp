#include "numeric/periodic/periodic_solution.hpp"

#include "numeric/riemann_hilbert/riemann_hilbert.hpp"
#include "periodic_problems.hpp"

namespace {

using namespace numeric;

template <Real R>
std::shared_ptr<const ContactSolution<R>> solved(const ContactProblem& problem) {
  const Attempt<R> found = closed_form<R>(problem);
  INFO(found.reason);
  REQUIRE(found.solution);
  return found.solution;
}

template <Real R>
R centre(const ContactProblem& problem) {
  return solved<R>(problem)->resultants().centre_of_pressure.value;
}

/// A wave with two harmonics, lowest next to 0.
Indenter wave(const Rational& left, const Rational& right) {
  return flat(left, right).with_harmonics({{1, -0.05_r, 0.01_r}, {2, 0.01_r, 0}});
}

ContactProblem on_wave(const Indenter& indenter, const Rational& load) {
  return periodic(1, {0.3_r, 0.9_r}, {0.02_r}, flat(-0.1_r, 0.1_r), load).with_indenter(indenter);
}

/// Every kind of contact: edges, free ends, one of each, no gap, with and without jumps.
std::vector<ContactProblem> all_kinds() {
  return {periodic(1, {0.7_r}, {}, flat(-0.3_r, 0.3_r)),
          periodic(1, {0.2_r, 0.9_r, 0.1_r}, {0.05_r, 0.1_r}, flat(-0.3_r, 0.3_r), 2, Sliding::minus_x),
          on_wave(wave(-0.5_r, 0.5_r), 0.05_r),
          on_wave(wave(-0.1_r, 0.4_r), 0.1_r),
          on_wave(wave(-0.4_r, 0.08_r), 0.1_r),
          on_wave(wave(-0.1_r, 0.1_r), 0.1_r),
          periodic(2, {0.6_r, 0.1_r}, {0.9_r}, flat(-0.99_r, 0.99_r)),
          on_wave(wave(-0.5_r, 0.5_r), 1),
          periodic(1, {0.1_r, 0.7_r, 0.1_r}, {-0.2_r, 0.3_r}, flat(-0.5_r, 0.5_r))};
}

/// The ends of contact and the jumps between them, exactly as the solution has them.
template <Real R>
std::vector<Rational> singular_places(const ContactProblem& problem, const ContactSolution<R>& solution) {
  const std::vector<ApproximateContact::End> ends = solution.approximate_contact().ends;
  const auto zone = solution.contact().front();
  std::vector<Rational> places{ends[0].vanishes ? Rational(zone.left.x.value) : ends[0].anchor};
  const Rational right = ends[1].vanishes ? Rational(zone.right.x.value) : ends[1].anchor;
  for (const Rational& c : problem.friction().jumps()) {
    if (places.front() < c && c < right) places.push_back(c);
  }
  places.push_back(right);
  return places;
}

/// Returns the largest difference between A_L t and u'/c, by a rule of this test, at places in contact and in the gap.
template <Real R>
R residual(const ContactProblem& problem, const Rational& part) {
  const auto solution = solved<R>(problem);
  const std::vector<Rational> points = singular_places<R>(problem, *solution);
  const Rational width = points.back() - points.front();
  R worst = 0;
  for (const Rational& x :
       {Rational(points.front() + width * part), Rational(points.back() + (*problem.body().period() - width) * part)}) {
    if (x == points.back()) continue;  // there is no gap
    const R slope = solution->at(x).slope.left.value;
    worst = std::max(worst, size_of(R(applied<R>(problem, *solution, points, x) - slope)));
  }
  return worst;
}

/// Returns the centre of pressure of the middle one of 2n + 1 flat punches on a half-plane, at distances of 1.
double middle_of_many(int n) {
  std::vector<Indenter::Piece> pieces;
  std::vector<Rational> jumps, s;
  for (int k = -n; k <= n; ++k) {
    if (k > -n) pieces.push_back({k - 0.3_r, Polynomial({100})});
    pieces.push_back({k + 0.3_r, Polynomial({0})});
    s.push_back(0.2_r);
    s.push_back(0.9_r);
    jumps.push_back(k + 0.05_r);
    if (k < n) jumps.push_back(k + 0.5_r);
  }
  const ContactProblem many = reduced(s, jumps, Indenter(-n - 0.3_r, pieces), 2 * n + 1);
  const Attempt<double> found = riemann_hilbert<double>(many);
  INFO(found.reason);
  REQUIRE(found.solution);
  CHECK(found.solution->failed_condition() == "");
  const auto t = [&](const Rational& x) { return found.solution->at(x).traction.left.value; };
  double load = 0, moment = 0;
  for (const auto& [from, to] : {std::pair(-0.3_r, 0.05_r), std::pair(0.05_r, 0.3_r)}) {
    load += integral<double>(from, to, t);
    moment += integral<double>(from, to, [&](const Rational& x) { return to_real<double>(x) * t(x); });
  }
  return moment / load;
}

}  // namespace

TEST_CASE("a flat punch with friction: the centre of pressure and the pressure's factor") {
  const ContactProblem punch = periodic(1, {0.7_r}, {}, flat(-0.3_r, 0.3_r));
  CHECK(centre<double>(punch) == doctest::Approx(-0.0445734298325).epsilon(2e-12));
  CHECK(size_of(Real50(centre<Real50>(punch) - centre<Real50>(punch.mirrored().mirrored()))) < Real50("1e-50"));
  // p is proportional to |Y| (1 + 0.249268830989 X), X = tan(pi x), and |Y| of X at 0.2 and -0.2.
  const auto solution = solved<double>(punch);
  const double alpha = std::atan(0.7) / std::numbers::pi, X = std::tan(0.2 * std::numbers::pi),
               end = std::tan(0.3 * std::numbers::pi);
  const auto p = [&](double x) {
    return std::pow(end + x, -0.5 - alpha) * std::pow(end - x, alpha - 0.5) * (1 + 0.249268830989 * x);
  };
  CHECK(solution->at(0.2_r).traction.left.value / solution->at(-0.2_r).traction.left.value ==
        doctest::Approx(p(X) / p(-X)).epsilon(1e-11));
}

TEST_CASE("control: without the mean of friction subtracted, the centre of pressure is another") {
  // Then both conditions say F(i) = kappa - i P/L, and the factor of X is that of S = 0.
  const ContactProblem punch = periodic(1, {0.7_r}, {}, flat(-0.3_r, 0.3_r));
  CHECK(std::abs(centre<double>(punch) + 0.142396) > 0.09);
  PeriodicZone<double> zone{{PeriodicFundamentalSolution<double>(-0.3, {0.6, 0.4},
                                                                 {Power<double>::of(edge_exponent(End::left, 0.7_r)),
                                                                  Power<double>::of(edge_exponent(End::right, 0.7_r))}),
                             {cos_pi_alpha<double>(0.7_r)},
                             {1, 0},
                             0},
                            {0.7},
                            {},
                            1,
                            -1};
  const auto centre_of = [&] {
    const PeriodicTraction<double> t = periodic_state(zone).traction;
    return -integral<double>(-0.3_r, 0.3_r, [&](const Rational& x) {
      return to_real<double>(x) * t.value(0, to_real<double>(x + 0.3_r), to_real<double>(0.3_r - x));
    });
  };
  CHECK(centre_of() == doctest::Approx(-0.0445734298325).epsilon(1e-11));
  zone.s = {0};
  CHECK(centre_of() == doctest::Approx(-0.142396).epsilon(1e-5));
}

TEST_CASE_TEMPLATE("Westergaard's wave without friction", R, double, Real50) {
  // Gap Delta (1 - cos 2y), y = pi x/L: p = 2 pbar cos y sqrt(sin^2 y_a - sin^2 y)/sin^2 y_a, pbar = 2 pi Delta
  // sin^2(y_a)/(c L).
  const Rational half = 3, height = 0.02_r, load = 0.01_r;
  const ContactProblem problem = periodic(2 * half, {0}, {}, flat(-half, half), load)
                                     .with_indenter(flat(-half, half).with_harmonics({{1, -height, 0}}));
  const auto solution = solved<R>(problem);
  const R square = to_real<R>(load / height) / (2 * pi<R>()), period = to_real<R>(2 * half);
  CHECK(close<R>(solution->contact()[0].right.x.value, asin(sqrt(square)) * period / pi<R>(), 100));
  for (const Rational& x : {0_r, 0.1_r, 0.25_r}) {
    const R y = pi<R>() * to_real<R>(x) / period;
    const R p = 2 * to_real<R>(load) / period * cos(y) * sqrt(square - sin(y) * sin(y)) / square;
    CHECK(close<R>(-solution->at(x).traction.left.value, p, 1000));
  }
  const LargestPressure<R> largest = solution->largest_pressure();
  CHECK(close<R>(largest.value.value, 2 * to_real<R>(load) / (period * sqrt(square)), 100));
  CHECK(size_of(largest.x.value) <= largest.x.error);
}

TEST_CASE("the equation holds in contact and in the gap, by another rule") {
  for (const ContactProblem& problem : all_kinds()) {
    for (const Rational& part : {0.06_r, 0.37_r, 0.79_r}) {
      CHECK(residual<double>(problem, part) < 2e-11);
      CHECK(residual<double>(problem.mirrored(), part) < 2e-11);
    }
    CHECK(residual<Real50>(problem, 0.43_r) < Real50("1e-42"));
  }
}

TEST_CASE_TEMPLATE("the load, the closed surface and the checked conditions", R, double, Real50) {
  for (const ContactProblem& problem : all_kinds()) {
    const auto solution = solved<R>(problem);
    const Residuals<R> r = solution->residuals();
    const R small = pow(epsilon<R>(), R(0.75));
    CHECK(r.equation < small);
    CHECK(r.load < small);
    CHECK(r.penetration < small);
    CHECK(r.tension == 0);
    const std::vector<Rational> points = singular_places<R>(problem, *solution);
    // The displacement is periodic: it is the same from both ends of the contact to the middle of the gap.
    const Rational period = *problem.body().period(), middle = (points.front() + points.back() + period) / 2;
    const Rational beside = period / 1000000000;
    const auto u = [&](const Rational& x) { return solution->details_at(x).displacement.value; };
    CHECK(size_of(R(u(middle - beside) - u(middle + beside))) < R(1e-8));
    CHECK(solution->at(middle).slope.left.value == solution->at(middle - 3 * period).slope.left.value);
    if (points.back() == points.front() + period) continue;  // the load counts from there on
    CHECK(close<R>(solution->details_at(points.back()).cumulative_load.value, to_real<R>(problem.load()), 1000));
  }
}

TEST_CASE("a flat surface without a gap: the effective friction is tan(pi mean(alpha))/gamma in every layout") {
  const double gamma = 0.5, alpha_1 = std::atan(0.1) / std::numbers::pi, alpha_2 = std::atan(1.5) / std::numbers::pi;
  const double expected = std::tan(std::numbers::pi * (0.7 * alpha_1 + 0.3 * alpha_2)) / gamma;
  for (const auto& [s, jumps] :
       {std::pair(std::vector{1.5_r, 0.1_r}, std::vector{0.3_r}),
        std::pair(std::vector{0.1_r, 1.5_r, 0.1_r, 1.5_r}, std::vector{0.2_r, 0.4_r, 0.9_r})}) {
    const auto solution = solved<double>(periodic(1, s, jumps, flat(0, 1)));
    CHECK(solution->resultants().effective_friction.value == doctest::Approx(expected).epsilon(1e-13));
    const ContactComponent<double> zone = solution->contact().front();
    CHECK(zone.left.kind == SingularKind::friction_jump);
    CHECK(zone.left.exponent == zone.right.exponent);
    CHECK(zone.width.value == 1);
    CHECK(solution->singular_points().size() == s.size());
  }
  // The pressure is constant if there is no jump.
  CHECK(solved<double>(periodic(2, {0.7_r}, {}, flat(-1, 1)))->at(0.3_r).traction.left.value == doctest::Approx(-0.5));
}

TEST_CASE("short waves: the residuals resolve them") {
  const Indenter waves = flat(-0.5_r, 0.5_r).with_harmonics({{1, -0.05_r, 0}, {6, 0.001_r, 0.002_r}});
  const Residuals<double> r =
      solved<double>(periodic(1, {0.3_r}, {}, flat(-0.5_r, 0.5_r), 5).with_indenter(waves))->residuals();
  CHECK(r.equation < 1e-12);
  CHECK(r.load < 1e-12);
}

TEST_CASE("strong friction, with a power next to -1: the surface is closed") {
  for (const Rational& friction : {16.54_r, 20_r, 21.5_r}) {
    const Residuals<double> r =
        solved<double>(periodic(23.4_r, {friction, 0}, {7.12_r}, flat(2.125_r, 8.29_r)))->residuals();
    CHECK(r.equation < 1e-13);
    CHECK(r.load < 1e-13);
    CHECK(r.penetration < 1e-11);
  }
}

TEST_CASE("the load behind a place next to an edge is a power of the distance, at any distance") {
  const ContactProblem problem = periodic(1, {0.9_r, 0.2_r}, {0.1_r}, flat(-0.3_r, 0.3_r));
  const auto solution = solved<double>(problem);
  const double p = -0.5 - std::atan(0.9) / std::acos(-1.0);
  for (const Rational& d : {Rational(1, 1'000'000'000), Rational("1/1000000000000000000")}) {
    const double load = solution->details_at(-0.3_r + d).cumulative_load.value;
    const double expected =
        solution->singular_points().front().intensity.value * std::pow(to_real<double>(d), 1 + p) / (1 + p);
    CHECK(load == doctest::Approx(expected).epsilon(1e-7));
  }
}

TEST_CASE("the tangential displacement: its slope is periodic, and its integral over a period is 0") {
  const ContactProblem punch = all_kinds()[1], waves = all_kinds()[2];
  for (const ContactProblem& problem : {punch, waves}) {
    const auto solution = solved<double>(problem);
    std::vector<Rational> points = singular_places<double>(problem, *solution);
    points.push_back(points.front() + *problem.body().period());
    double sum = 0, size = 0;
    for (std::size_t k = 0; k + 1 < points.size(); ++k) {
      sum += integral<double>(points[k], points[k + 1], [&](const Rational& x) {
        const double slope = solution->details_at(x).shear_slope.left.value;
        size = std::max(size, std::abs(slope) * to_real<double>(points[k + 1] - points[k]));
        return slope;
      });
    }
    CHECK(std::abs(sum) < 1e-7);
    CHECK(size > 0.01);
  }
}

TEST_CASE("punches far apart: the half-plane, with the error 1/L") {
  const ContactProblem alone = reduced({0.2_r, 0.9_r}, {0.05_r}, flat(-0.3_r, 0.3_r), 1);
  const double far = closed_form<double>(alone).solution->resultants().centre_of_pressure.value;
  double before = 0;
  for (const int period : {100, 200, 400, 800}) {
    const double off = centre<double>(alone.with_body(Body::periodic(period))) - far;
    if (before != 0) CHECK(before / off == doctest::Approx(2).epsilon(0.02));
    before = off;
  }
}

TEST_CASE("the middle one of many punches on a half-plane: the error halves if their number doubles") {
  const double limit = centre<double>(periodic(1, {0.2_r, 0.9_r}, {0.05_r}, flat(-0.3_r, 0.3_r)));
  double coarse = middle_of_many(4) - limit;
  for (const int n : {8, 16, 32}) {
    const double fine = middle_of_many(n) - limit;
    CHECK(coarse / fine == doctest::Approx(2).epsilon(0.25 / n));
    CHECK(std::abs(2 * fine - coarse) < 0.0025 / (n * n));
    coarse = fine;
  }
}

TEST_CASE("a support of a whole period has no edges: the contact may lie across its ends") {
  // The same wave and the same stripe, at several places of the period.
  const auto at = [](const Rational& place) {
    std::vector<Rational> jumps, s;
    const auto inside = [](Rational x) {
      while (x >= 1) x -= 2;
      while (x < -1) x += 2;
      return x;
    };
    const Rational rear = inside(place - 0.13_r), front = inside(place + 0.13_r);
    const bool across = front < rear;
    const std::vector<Rational> values = across ? std::vector{0.8_r, 0.3_r, 0.8_r} : std::vector{0.3_r, 0.8_r, 0.3_r};
    const ContactProblem problem =
        periodic(2, values, {std::min(rear, front), std::max(rear, front)}, flat(-1, 1), 0.08_r);
    return problem.with_indenter(flat(-1, 1).with_harmonics({{1, -0.02_r, 0}}, place));
  };
  const auto centred = solved<double>(at(0));
  for (const Rational& place : {0.45_r, 0.9_r, -0.99_r, 0.99_r}) {
    const ContactProblem problem = at(place);
    const auto moved = solved<double>(problem);
    CHECK(moved->contact()[0].left.x.value ==
          doctest::Approx(to_real<double>(place) + centred->contact()[0].left.x.value));
    CHECK(moved->resultants().effective_friction.value ==
          doctest::Approx(centred->resultants().effective_friction.value));
    CHECK(moved->residuals().equation < 1e-12);
    for (const Rational& x : {-0.7_r, -0.2_r, 0.05_r, 0.5_r, 0.9_r}) {
      const DetailedSample<double> a = centred->details_at(x), b = moved->details_at(place + x);
      CHECK(b.traction.left.value == doctest::Approx(a.traction.left.value).epsilon(1e-10));
      CHECK(b.shear_slope.left.value == doctest::Approx(a.shear_slope.left.value).epsilon(1e-10));
      CHECK(problem.friction().values()[b.friction->left] == at(0).friction().values()[a.friction->left]);
    }
    CHECK(moved->samples(20).size() == 60);
  }
}

TEST_CASE("what has no closed form is refused") {
  const auto reason = [](const ContactProblem& problem) { return closed_form<double>(problem).reason; };
  CHECK(reason(periodic(2, {0.1_r}, {}, one_piece(-1, 1, {0, 0, 1}))) ==
        "with a period, a closed form is for a flat profile or for harmonics");
  CHECK(reason(periodic(2, {0.1_r}, {}, Indenter(-1, {{0, Polynomial({0})}, {1, Polynomial({1})}}))) ==
        "with a period, a closed form is for a flat profile or for harmonics");
  const std::string zones = "with a period, a closed form is for one zone of contact in each period";
  const ContactProblem plane = periodic(2, {0.1_r}, {}, flat(-1, 1));
  const Indenter hills = flat(-1, 1).with_harmonics({{2, -0.1_r, 0}});
  CHECK(reason(plane.with_indenter(hills).with_load(0.01_r)) == zones);
  std::vector<Rational> jumps;
  for (int k = 1; k < 201; ++k) jumps.push_back(Rational(k, 201) - 0.5_r);
  const ContactProblem stripes = periodic(2, std::vector<Rational>(201, 0.1_r), jumps, flat(-0.5_r, 0.5_r));
  CHECK(reason(stripes) == "too many values of friction for periodic contact; there are at most 200; 201 values");
  CHECK(closed_form<Real50>(stripes).reason ==
        "too many values of friction for periodic contact; there are at most 50; 201 values");
  const Elasticity both(Solid(0.3_r, 1), Solid(0.2_r, 2));
  CHECK(reason(ContactProblem(both, FrictionProfile({0.5_r}), flat(-0.5_r, 0.5_r), 1, Sliding::plus_x, std::nullopt,
                              Body::periodic(2))) ==
        "an elastic indenter touches with its edges, where the half-plane idealisation fails");
}
