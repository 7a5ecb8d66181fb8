// Runs of wear on cells: their end, their order, their volume, and theorem W.

#include "numeric/wear/wear_run.hpp"
#include "support/problems.hpp"

namespace {

using numeric::wear::WearProcess;
using numeric::wear::WearRow;
using numeric::wear::WearRun;
using numeric::wear::WearState;
using numeric::wear::WearWanted;

const std::vector<Rational> rising{0.05_r, 0.1_r, 0.25_r};
const std::vector<Rational> jumps{-0.3_r, 0.4_r};

ContactProblem three_coatings(const std::vector<Rational>& profile = {0},
                              const std::optional<Rational>& load_at = std::nullopt,
                              Sliding sliding = Sliding::plus_x) {
  return reduced(rising, jumps, one_piece(-1, 1, profile), 1, load_at, sliding);
}
Wear wear_of(const ContactProblem& problem, std::vector<Rational> k = {1, 3, 0.5_r}, const Rational& body = 0) {
  return {std::move(k), body, problem};
}

/// All rows of a run, and its last state.
struct History {
  std::vector<WearRow> rows;
  WearState last;
};
History history(WearRun run) {
  History result{{run.row()}, {}};
  while (!run.is_over()) {
    run.advance();
    result.rows.push_back(run.row());
  }
  result.last = run.state();
  return result;
}
History history(const ContactProblem& problem, const Wear& wear, const WearWanted& wanted) {
  return history(WearRun(problem, wear, wanted));
}

double distance(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += std::abs(a[i] - b[i]);
  return sum / static_cast<double>(a.size());
}

/// The integral of the wear rate by the rectangles of implicit Euler.
double summed_rate(const std::vector<WearRow>& rows) {
  double sum = 0;
  for (std::size_t n = 1; n < rows.size(); ++n) sum += (rows[n].distance - rows[n - 1].distance) * rows[n].wear_rate;
  return sum;
}

bool all_solved(const std::vector<WearRow>& rows) {
  return std::all_of(rows.begin(), rows.end(), [](const WearRow& row) { return row.failed_condition.empty(); });
}

}  // namespace

TEST_CASE("wear of three coatings ends with k p constant") {
  for (const std::vector<Rational>& profile : {std::vector<Rational>{0}, {0, 0, 0.5_r}}) {
    const ContactProblem problem = three_coatings(profile);
    const WearRun run(problem, wear_of(problem), {1e6, 0, 1e-3, 500, 1e-6});
    const auto [rows, last] = history(run);
    CHECK(rows.size() <= 201);
    CHECK(all_solved(rows));
    CHECK(rows.back().distance < 1e6);
    CHECK(*rows.back().from_run_in <= 1e-6);
    // A/k with A = P/sum of length/k; 500 cells have both jumps at ends of cells.
    const double a = 1 / (0.7 / 1 + 0.7 / 3 + 0.6 / 0.5);
    CHECK(rows.back().wear_rate == doctest::Approx(2 * a).epsilon(2e-6));
    const std::vector<double> p = run.process().pressures(last);
    for (const auto& [cell, expected] : {std::pair(10, a), {174, a}, {175, a / 3}, {349, a / 3}, {350, 2 * a}}) {
      CHECK(p[static_cast<std::size_t>(cell)] == doctest::Approx(expected).epsilon(1e-5));
    }
    CHECK(rows.back().effective_friction ==
          doctest::Approx(2 * a * (0.05 * 0.7 + 0.1 * 0.7 / 3 + 0.25 * 1.2)).epsilon(1e-5));
  }
}

TEST_CASE("wear with a free tilt ends with k p = A + B x where this is positive") {
  for (const auto& [load_at, has_gap] : {std::pair(0.1_r, false), {0.6_r, false}, {-0.9_r, true}, {0.95_r, true}}) {
    const ContactProblem problem = three_coatings({0, 0, 0.1_r}, load_at);
    WearRun run(problem, wear_of(problem), {1e9, 0, 1e-3, 500, 1e-7});
    const auto [rows, last] = history(run);
    CHECK(all_solved(rows));
    REQUIRE(*rows.back().from_run_in <= 1e-7);
    CHECK(rows.back().centre_of_pressure == doctest::Approx(load_at.convert_to<double>()));
    const std::vector<double> p = run.process().pressures(last);
    std::vector<double> kp, x;
    for (std::size_t i = 0; i < p.size(); ++i) {
      x.push_back(-1 + (static_cast<double>(i) + 0.5) / 250);
      kp.push_back(p[i] * (i < 175 ? 1 : i < 350 ? 3 : 0.5));
    }
    const bool at_rear = load_at < 0;
    const std::size_t a = at_rear ? 0 : 499, b = at_rear ? 20 : 479;
    const double slope = (kp[a] - kp[b]) / (x[a] - x[b]);
    std::size_t gaps = 0;
    for (std::size_t i = 0; i < p.size(); ++i) {
      const double line = kp[a] + slope * (x[i] - x[a]);
      CHECK(kp[i] == doctest::Approx(std::max(line, 0.0)).epsilon(1e-4));
      gaps += p[i] == 0 ? 1U : 0U;
    }
    CHECK((gaps > 100) == has_gap);
  }
}

TEST_CASE("half the step of wear halves the error") {
  const ContactProblem problem = three_coatings({0, 0, 0.5_r});
  const Wear wear = wear_of(problem);
  const auto depth = [&](int steps) { return history(problem, wear, {0.3, steps, 1e-3, 200}).last.depth; };
  const std::vector<double> fine = depth(1280);
  std::vector<double> errors;
  for (const int steps : {20, 40, 80}) errors.push_back(distance(depth(steps), fine));
  // An error C/N against N = 1280 has the ratios 2.03 and 2.07.
  CHECK(errors[0] / errors[1] == doctest::Approx(2).epsilon(0.1));
  CHECK(errors[1] / errors[2] == doctest::Approx(2).epsilon(0.1));
  // Automatic steps: the errors of all steps together are larger than the true one.
  const auto [rows, last] = history(problem, wear, {0.3, 0, 1e-3, 200});
  double allowed = 0;
  for (const WearRow& row : rows) allowed += row.step_error * row.wear_volume;
  const double found = 2 * distance(last.depth, fine);
  CHECK(found < allowed);
  CHECK(found > allowed / 10);
}

TEST_CASE("the wear volume is the integral of k p over x and S") {
  const ContactProblem problem = three_coatings({0, 0.3_r, 0.5_r});
  const std::vector<WearRow> rows = history(problem, wear_of(problem), {2, 100, 1e-3, 300}).rows;
  CHECK(rows.back().wear_volume == doctest::Approx(summed_rate(rows)).epsilon(1e-12));
  double trapezoids = 0;
  for (std::size_t n = 1; n < rows.size(); ++n) trapezoids += 0.01 * (rows[n].wear_rate + rows[n - 1].wear_rate);
  CHECK(rows.back().wear_volume == doctest::Approx(trapezoids).epsilon(0.01));
  CHECK(rows.back().wear_volume != doctest::Approx(trapezoids).epsilon(1e-4));
  // One coefficient for all: k P S.
  const auto one = history(problem, wear_of(problem, {0.25_r}), {8, 0, 1e-2, 300}).rows;
  CHECK(one.back().wear_volume == doctest::Approx(2).epsilon(1e-12));
}

TEST_CASE("a run of wear goes on from any state, bit for bit") {
  const ContactProblem problem = three_coatings({0, 0, 0.5_r}, 0.1_r);
  const WearRun start(problem, wear_of(problem), {5, 0, 1e-3, 400});
  for (const int stop : {0, 7, 30}) {
    WearRun before = start;
    for (int n = 0; n < stop; ++n) before.advance();
    WearRun after = start;
    after.go_on(before.state(), stop, before.row().step_error);
    CHECK(after.row().from_run_in == before.row().from_run_in);
    const auto [rows, last] = history(after);
    const auto [whole, end] = history(start);
    CHECK(rows.size() + static_cast<std::size_t>(stop) == whole.size());
    CHECK(last.depth == end.depth);
    CHECK(last.contact.pressure == end.contact.pressure);
    CHECK(rows.back().distance == 5);
    CHECK(rows.back().step_error == whole.back().step_error);
  }
}

TEST_CASE("wear through contacts that lose and gain zones is solved at each step") {
  // A zigzag of 24 teeth of different heights.
  std::vector<Indenter::Piece> pieces;
  Rational height = 0;
  for (int k = 0; k < 48; ++k) {
    const Rational next = k % 2 == 0 ? Rational((7 * k) % 11, 400) : Rational(4 + (5 * k) % 7, 100);
    const Rational left(k - 24, 24), right(k - 23, 24), slope = (next - height) * 24;
    pieces.push_back({right, Polynomial({height - slope * left, slope})});
    height = next;
  }
  const ContactProblem problem = reduced({0.3_r, 0.1_r, 0.6_r}, jumps, Indenter(-1, pieces), 0.02_r);
  const auto rows = history(problem, wear_of(problem), {2, 60, 1e-3, 2000}).rows;
  CHECK(rows.size() == 61);
  CHECK(all_solved(rows));
  int gained = 0, lost = 0;
  for (std::size_t n = 1; n < rows.size(); ++n) {
    gained += rows[n].zones > rows[n - 1].zones ? 1 : 0;
    lost += rows[n].zones < rows[n - 1].zones ? 1 : 0;
  }
  CHECK(gained >= 2);
  CHECK(lost >= 2);
}

TEST_CASE("two histories of wear approach each other for rising friction") {
  const ContactProblem flat = three_coatings({0, 0.2_r}), round = three_coatings({0, 0, 0.5_r});
  const std::vector<double> k{1, 3, 0.5};
  const WearProcess a(flat, wear_of(flat), 200), b(round, wear_of(round), 200);
  const std::vector<double> psi_a = a.data(), psi_b = b.data();  // k, f and then the profiles
  const auto apart = [&](const WearState& first, const WearState& second) {
    double mean = 0, sum = 0, weight = 0;
    std::vector<double> difference;
    for (std::size_t i = 0; i < 200; ++i) {
      const double inverse = 1 / (i < 70 ? k[0] : i < 140 ? k[1] : k[2]);
      difference.push_back(psi_a[5 + 400 + i] + first.depth[i] - psi_b[5 + 400 + i] - second.depth[i]);
      mean += inverse * difference.back();
      weight += inverse;
    }
    for (std::size_t i = 0; i < 200; ++i) {
      const double inverse = 1 / (i < 70 ? k[0] : i < 140 ? k[1] : k[2]);
      sum += inverse * std::pow(difference[i] - mean / weight, 2);
    }
    return sum / 200;
  };
  WearState first = a.start(), second = b.start();
  double last = apart(first, second);
  const double begin = last;
  for (double step = 0.001; step < 10; step *= 1.3) {
    first = a.advanced(first, step).state;
    second = b.advanced(second, step).state;
    const double now = apart(first, second);
    CHECK(now < last);
    last = now;
  }
  CHECK(begin > 0.01);
  CHECK(last < 1e-3 * begin);
  CHECK(distance(first.contact.pressure, second.contact.pressure) < 1e-3);
}

TEST_CASE("a coating that does not wear carries the whole load in the end") {
  const ContactProblem problem = three_coatings({0, 0, 0.5_r});
  const WearRun run(problem, wear_of(problem, {1, 0, 2}), {1e8, 0, 1e-3, 200, 1e-4});
  const auto [rows, last] = history(run);
  CHECK(all_solved(rows));
  CHECK(*rows.back().from_run_in <= 1e-4);
  double middle = 0;
  for (std::size_t i = 70; i < 140; ++i) middle += last.contact.pressure[i] / 200;
  CHECK(middle == doctest::Approx(1).epsilon(1e-4));
  CHECK(rows.back().effective_friction == doctest::Approx(2 * 0.1).epsilon(1e-3));
  // The load at a place that this coating cannot reach: no run-in pressure is known.
  const ContactProblem tilting = three_coatings({0, 0, 0.5_r}, 0.8_r);
  CHECK_FALSE(WearRun(tilting, wear_of(tilting, {1, 0, 2}), {1, 2, 1e-3, 200}).row().from_run_in);
  CHECK_THROWS_WITH(
      WearRun(tilting, wear_of(tilting, {1, 0, 2}), {1, 2, 1e-3, 200, 0.1}),
      "no run-in pressure; the cells that do not wear carry the load at its place in the end; they cannot");
}

TEST_CASE("wear of the body lowers the friction of the surface's displacement") {
  // c = 1, gamma = 1/2: k_b = 1/20 takes 1/20 off s, which is 1/10 of f.
  const ContactProblem problem = three_coatings({0, 0, 0.5_r});
  const ContactProblem lower = reduced({0, 0.05_r, 0.2_r}, jumps, one_piece(-1, 1, {0, 0, 0.5_r}), 1);
  const auto worn = history(problem, wear_of(problem, {1, 3, 0.5_r}, 0.05_r), {1, 10, 1e-3, 200});
  const auto less = history(lower, wear_of(lower), {1, 10, 1e-3, 200});
  CHECK(distance(worn.last.depth, less.last.depth) < 1e-12);
  CHECK(worn.rows.front().centre_of_pressure == doctest::Approx(less.rows.front().centre_of_pressure).epsilon(1e-12));
  CHECK(worn.rows.back().effective_friction > less.rows.back().effective_friction + 0.05);
}

TEST_CASE("a mirrored problem wears like the mirror image") {
  const ContactProblem problem = three_coatings({0, 0.1_r, 0.5_r});
  const ContactProblem mirrored = problem.mirrored();
  REQUIRE(mirrored.sliding() == Sliding::minus_x);
  const auto one = history(problem, wear_of(problem, {1, 3, 0.5_r}, 0.05_r), {1, 10, 1e-3, 200}).last;
  auto other = history(mirrored, wear_of(mirrored, {0.5_r, 3, 1}, 0.05_r), {1, 10, 1e-3, 200}).last;
  std::reverse(other.depth.begin(), other.depth.end());
  CHECK(distance(one.depth, other.depth) < 1e-10);
  const auto without = history(mirrored, wear_of(mirrored, {0.5_r, 3, 1}), {1, 10, 1e-3, 200}).last;
  CHECK(distance(without.depth, other.depth) > 1e-3);
}

TEST_CASE("random wear: the volume is the integral of the rate, and the certificate accepts each step") {
  REQUIRE(rc::check([] {
    std::vector<Rational> k;
    for (int i = 0; i < 3; ++i) k.emplace_back(uniform(i == 0 ? 1 : 0, 50), 10);
    const ContactProblem problem = reduced(
        {Rational(uniform(0, 9), 10), Rational(uniform(0, 9), 10), Rational(uniform(0, 9), 10)},
        {Rational(uniform(-9, 0), 10), Rational(uniform(1, 9), 10)},
        one_piece(-1, 1, {0, Rational(uniform(-9, 9), 10), Rational(uniform(-9, 9), 5)}), Rational(uniform(1, 30), 10));
    const Wear wear(k, Rational(uniform(0, 5), 20), problem);
    const double end = uniform(1, 40) / 10.0;
    const WearRun run(problem, wear, {end, 0, 1e-2, 256});
    const auto [rows, last] = history(run);
    RC_ASSERT(all_solved(rows));
    RC_ASSERT(rows.back().distance == end);
    RC_ASSERT(std::abs(rows.back().wear_volume - summed_rate(rows)) < 1e-10 * rows.back().wear_volume);
    double load = 0;
    for (const double p : run.process().pressures(last)) load += p * 2 / 256;
    RC_ASSERT(std::abs(load / problem.load().convert_to<double>() - 1) < 1e-10);
  }));
}

TEST_CASE("a zone across the end of the period is one zone: the data moved by half a period") {
  const Indenter flat = one_piece(-1, 1, {0});
  const auto wave = [&](std::vector<Rational> s, std::vector<Rational> at, const Rational& cosine) {
    return reduced(std::move(s), std::move(at), flat, 0.02_r)
        .with_body(Body::periodic(2))
        .with_indenter(flat.with_harmonics({{1, cosine, 0}}));
  };
  const ContactProblem here = wave({0.1_r, 0.4_r}, {0.3_r}, 0.01_r),
                       there = wave({0.1_r, 0.4_r, 0.1_r}, {-0.7_r, 0}, -0.01_r);
  const WearProcess a(here, wear_of(here, {1, 2}), 320), b(there, wear_of(there, {1, 2, 1}), 320);
  const auto compare = [&](const WearState& in_a, const WearState& in_b) {
    const WearRow p = a.row(in_a, 0), q = b.row(in_b, 0);
    CHECK(p.zones == 1);
    CHECK(q.zones == 1);
    CHECK(p.left + 1 == doctest::Approx(q.left).epsilon(1e-9));
    CHECK(p.right + 1 == doctest::Approx(q.right).epsilon(1e-9));
    CHECK(p.centre_of_pressure + 1 == doctest::Approx(q.centre_of_pressure).epsilon(1e-9));
    CHECK(p.effective_friction == doctest::Approx(q.effective_friction).epsilon(1e-9));
    CHECK(p.wear_rate == doctest::Approx(q.wear_rate).epsilon(1e-9));
  };
  compare(a.start(), b.start());
  const double step = a.natural_distance() / 4;
  compare(a.advanced(a.start(), step).state, b.advanced(b.start(), step).state);
}

TEST_CASE("a body that comes back with a period has no wear of its own") {
  const ContactProblem periodic = three_coatings().with_body(Body::periodic(4));
  CHECK(wear_of(periodic).body() == 0);
  CHECK_THROWS_WITH(wear_of(periodic, {1}, 1),
                    "a body that comes back; wear.body is for a body that is passed once; period 4");
}

TEST_CASE("wear in double has a range") {
  const ContactProblem problem = three_coatings();
  CHECK_THROWS_WITH(WearRun(problem, wear_of(problem), {0}),
                    "out of range; a sliding distance is positive, at most 1e300; 0");
  CHECK_THROWS_WITH(WearRun(problem, wear_of(problem, {parse_rational("1e-400")}), {1}),
                    "wear.coefficients: values out of the range of double");
}
