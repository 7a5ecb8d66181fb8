// Bounds for pressures on cells, compared with the Riemann-Hilbert solution, which uses no cells.

#include "enclosure/cells/cell_bound.hpp"
#include "enclosure/cells/load_bounds.hpp"
#include "enclosure/cells/lowest_gap.hpp"
#include "numeric/riemann_hilbert/riemann_hilbert.hpp"
#include "numeric/variational/variational_inequality.hpp"
#include "numeric/variational/variational_solution.hpp"
#include "support/problems.hpp"
#include "support/random_problem.hpp"

namespace {

using namespace steadyslide::enclosure;
using namespace steadyslide::numeric;

/// s = 0.1 | 0.6 under a parabola.
ContactProblem parabola_over_a_rise(const Rational& jump = 0) {
  return reduced({0.1_r, 0.6_r}, {jump}, one_piece(-1, 1, {0, 0, 2.5_r}), 1);
}

std::vector<double> touching(const ContactProblem& problem, std::size_t cells) {
  const Attempt<double> attempt = variational_inequality(problem, {.cells = cells});
  REQUIRE_MESSAGE(attempt.solution, attempt.reason);
  return std::dynamic_pointer_cast<const VariationalSolution>(attempt.solution)->touching_pressures();
}

/// Checks that the enclosed numbers contain those of the Riemann-Hilbert solution. Its own errors are far smaller.
void contains_the_solution(const ContactProblem& problem, const CellBound& bound) {
  REQUIRE_MESSAGE(bound.proved, bound.reason);
  const Attempt<double> exact = riemann_hilbert<double>(problem);
  REQUIRE_MESSAGE(exact.solution, exact.reason);
  REQUIRE(exact.solution->failed_condition() == "");
  const Resultants<double> resultants = exact.solution->resultants();
  const auto contains = [](const Ball& ball, double value) {
    return ball.contains(Ball::around(Ball::exactly(value, 64), Ball(1e-11_r, 64))) || ball.contains(Rational(value));
  };
  REQUIRE(bound.load_share.size() == resultants.load_share.size());
  for (std::size_t k = 0; k < bound.load_share.size(); ++k) {
    CHECK(contains(bound.load_share[k], resultants.load_share[k].value));
  }
  CHECK(contains(bound.effective_friction, resultants.effective_friction.value));
}

double error(const CellBound& bound) { return bound.load_share.front().radius().to_double(); }

std::vector<double> scaled(std::vector<double> pressures, double factor) {
  for (double& p : pressures) p *= factor;
  return pressures;
}

/// Returns pressures that are 1 % larger on some cells in contact and 1 % smaller on others, under the same load.
std::vector<double> perturbed(std::vector<double> p) {
  const auto largest = static_cast<std::size_t>(std::max_element(p.begin(), p.end()) - p.begin());
  const double by = p[largest] / 100;
  for (const std::size_t i : {largest - 3, largest + 4}) p[i] -= by;
  for (const std::size_t i : {largest, largest + 9}) p[i] += by;
  return p;
}

}  // namespace

TEST_CASE("shares of a parabola over a rising jump are enclosed, and the closer the finer the cells") {
  const ContactProblem problem = parabola_over_a_rise();
  double last = 1, last_energy = 1;
  for (const std::size_t cells : {256U, 1024U, 4096U}) {
    const CellBound bound = bound_cells(problem, touching(problem, cells));
    contains_the_solution(problem, bound);
    CHECK(bound.cells == cells);
    CHECK(error(bound) < last / 2.5);
    CHECK(bound.energy.to_double() < last_energy / 8);
    // The search finds the lowest gap, and the enclosures are no wider than necessary.
    CHECK(bound.sharpness.to_double() > 0.95 * bound.energy.to_double());
    CHECK(bound.sharpness <= bound.energy);
    last = error(bound);
    last_energy = bound.energy.to_double();
  }
  CHECK(last < 2e-3);
}

TEST_CASE("jumps and breaks anywhere in a cell, both directions, either sign of gamma, several zones and edges") {
  const Rational c = 0.0371_r;
  const Indenter parabola = one_piece(-1, 1, {0, 0.3_r, 2.5_r});
  const Indenter polygon(-1, {{-0.41_r, Polynomial({0.2_r, -1})},
                              {0.123_r, Polynomial({0.61_r, 0})},
                              {0.5_r, Polynomial({0.5608_r, 0.4_r})},
                              {1, Polynomial({-0.2392_r, 2})}});
  const std::vector<ContactProblem> problems{
      parabola_over_a_rise(c),
      reduced({0.6_r, 0.1_r}, {c}, parabola, 1, std::nullopt, Sliding::minus_x),
      {Elasticity::reduced(-0.5_r), FrictionProfile({1.2_r, 0.1_r}, {c}), parabola, 1},
      {Elasticity(Solid(0.3_r, 7)), FrictionProfile({0.1_r, 0.4_r}, {c}),
       one_piece(1, 4, {5, -4, 0.8_r}).moved(1, -2.5_r), 0.4_r},
      reduced({0.1_r, 0.2_r, 0.2_r, 0.9_r}, {-0.2_r, c, 0.15_r}, parabola, 1),
      on_two_coatings(two_wells(), 6),
      on_two_coatings(roof(0.2_r, -0.2_r, 0.4_r), 1),
      on_two_coatings(one_piece(-1, 1, {}), 1),
      reduced({0.1_r, 0.6_r}, {c}, polygon, 0.3_r),
  };
  for (std::size_t k = 0; k < problems.size(); ++k) {
    CAPTURE(k);
    const CellBound bound = bound_cells(problems[k], touching(problems[k], 300));
    contains_the_solution(problems[k], bound);
    CHECK(error(bound) < 0.3);
  }
}

TEST_CASE("slow: a measured trace, a rough polygon on a parabola" * doctest::skip()) {
  const auto height = [](int k) {
    const double x = k / 60.0;
    const double y = x * x / 2 + 0.003 * std::cos(41 * x) + 0.002 * std::sin(67 * x + 1);
    return Rational(std::lround(y * 1e7)) / 10000000;
  };
  std::vector<Indenter::Piece> pieces;
  for (int k = -60; k < 60; ++k) {
    const Rational slope = (height(k + 1) - height(k)) * 60;
    pieces.push_back({Rational(k + 1, 60), Polynomial({height(k) - slope * Rational(k, 60), slope})});
  }
  const ContactProblem problem = reduced({0.05_r, 0.3_r}, {0.01_r}, Indenter(-1, pieces), 0.05_r);
  const CellBound bound = bound_cells(problem, touching(problem, 2048));
  contains_the_solution(problem, bound);
  CHECK(error(bound) < 0.02);
}

TEST_CASE("slow: 65536 cells enclose the shares to 1e-3" * doctest::skip()) {
  const ContactProblem problem = parabola_over_a_rise();
  const CellBound bound = bound_cells(problem, touching(problem, 65536));
  contains_the_solution(problem, bound);
  CHECK(error(bound) < 1e-3);
}

TEST_CASE("any pressures have a bound that holds; worse pressures have a larger one") {
  const ContactProblem problem = parabola_over_a_rise();
  const std::vector<double> good = touching(problem, 512);
  const CellBound best = bound_cells(problem, good);
  const CellBound worse = bound_cells(problem, perturbed(good));
  contains_the_solution(problem, worse);
  CHECK(worse.energy.to_double() > 2 * best.energy.to_double());
  const CellBound worst = bound_cells(problem, std::vector<double>(512, 0.5));
  contains_the_solution(problem, worst);
  CHECK(worst.energy.to_double() > 100 * best.energy.to_double());
  // The pressures are scaled to the load.
  CHECK(bound_cells(problem, scaled(good, 1 + 1e-9)).energy.to_double() == doctest::Approx(best.energy.to_double()));
}

TEST_CASE("a search whose budget is spent bounds nothing, and says where it was") {
  const ContactProblem problem = parabola_over_a_rise();
  const std::vector<double> p = touching(problem, 256);
  CHECK(bound_cells(problem, p, WorkBudget(100'000)).proved);
  const CellBound bound = bound_cells(problem, p, WorkBudget(12'800));
  CHECK_FALSE(bound.proved);
  CHECK(holds(bound.reason, "the budget of work is spent before the lowest gap is found; x = "));
}

namespace {

/// H at y = i + z without friction (cell_gap.hpp), by summing the logarithms of all nodes.
Ball gap_by_logarithms(const ContactProblem& problem, const CellPressures& pressures, std::size_t i, double z) {
  constexpr Bits bits = 200;
  const Rational h = (problem.indenter().right() - problem.indenter().left()) / Rational(pressures.size());
  const Ball y = Ball(static_cast<int>(i), bits) + Ball::exactly(z, bits);
  const Ball x = Ball(problem.indenter().left(), bits) + Ball(h, bits) * y;
  Ball potential(0, bits);
  const std::vector<std::int64_t> rises = pressures.rises();
  for (std::size_t m = 0; m < rises.size(); ++m) {
    const Ball d = y - Ball(static_cast<int>(m), bits);
    if (!d.is_zero()) potential += Ball(Rational(rises[m]), bits) * d * log(abs(d));
  }
  const Rational height = problem.elasticity().compliance() * problem.load();
  return value_at(in_balls(problem.indenter().pieces()[0].profile, bits), x) / Ball(height, bits) -
         potential / (Ball::pi(bits) * Ball(Rational(pressures.total()), bits));
}

}  // namespace

TEST_CASE(
    "the gap is no further from its polynomial within a cell than distant nodes may take it, and the lowest is below it") {
  // Pressures that fall far to the left of cell 5 and rise far to the right of it. The profile is lowest within that
  // cell.
  const CellPressures pressures(std::vector<double>{1, 1, 0, 0, 0, 0, 0, 0, 0, 1, 1});
  const NearLogarithms e(128);
  for (const double lowest_at : {0.146, 0.854}) {
    const Rational x = -1 + Rational(2, 11) * (5 + Rational(lowest_at));
    const ContactProblem problem = reduced({0}, {}, one_piece(-1, 1, {100 * x * x, -200 * x, 100}), 1);
    const CellGap gap(problem, pressures, 128);
    const GapPart part = gap.parts(5).front();
    double furthest = 0, lowest = 1e300;
    for (int k = 0; k <= 4096; ++k) {
      const double z = k / 4096.0;
      const Ball exact = gap_by_logarithms(problem, pressures, 5, z);
      const Ball off = abs(part.value(z, e) - exact);
      CHECK(off < part.rest + Ball(1e-30_r, 64));
      furthest = std::max(furthest, (off / part.rest).to_double());
      lowest = std::min(lowest, exact.to_double());
    }
    CHECK(furthest > 0.05);
    // If the mean is as low as the least value, the cell is halved until only the remainder is left.
    const Ball at = part.value(lowest_at, e);
    WorkBudget work;
    const LowestGap found = lowest_gap(gap, at, at, work);
    CHECK(found.bound.to_double() < lowest);
    CHECK(found.bound.to_double() > lowest - 3 * part.rest.to_double());
  }
}

TEST_CASE("the largest gap is one above the lowest that there is, not above the lowest that was met") {
  int tighter = 0;
  for (const std::size_t cells : {20U, 32U, 64U}) {
    const ContactProblem problem = parabola_over_a_rise(0.03_r);
    const std::vector<double> p = touching(problem, cells);
    const CellBound bound = bound_cells(problem, p);
    REQUIRE(bound.proved);
    const CellPressures pressures(p);
    const CellGap gap(problem, pressures, 128);
    const NearLogarithms e(128);
    std::optional<Ball> most, lowest;
    for (std::size_t i = 0; i < gap.size(); ++i) {
      if (pressures.weights()[i] > 0) most = most ? max(*most, gap.mean(i)) : gap.mean(i);
      for (const GapPart& part : gap.parts(i)) {
        for (int k = 0; k <= 500; ++k) {
          const Ball value = part.value(part.from + (part.to - part.from) * k / 512, e) + part.rest;
          lowest = lowest ? min(*lowest, value) : value;
        }
      }
    }
    // The least gap is no higher than any gap at the tested places.
    CHECK(bound.largest_gap >= (*most - *lowest).lower());
    tighter += bound.largest_gap < (*most - *lowest) * Ball(1.02_r, 64) ? 1 : 0;
  }
  CHECK(tighter == 3);
}

TEST_CASE("the energy bounds errors where s nowhere decreases, without steps and with a given attitude") {
  const auto why = [](const Rational& gamma, std::vector<Rational> f, Sliding sliding = Sliding::plus_x) {
    std::vector<Rational> jumps;
    for (std::size_t k = 1; k < f.size(); ++k) jumps.push_back(Rational(static_cast<int>(k), 10));
    return why_energy_bounds_nothing(ContactProblem(
        Elasticity::reduced(gamma), FrictionProfile(std::move(f), std::move(jumps)), one_piece(-1, 1, {}), 1, sliding));
  };
  const Rational gamma(2, 7);
  CHECK(why(gamma, {1}) == "");
  CHECK(why(0, {3, 1, 2}) == "");
  CHECK(why(gamma, {1, 2, 2, 3}) == "");
  CHECK(why(gamma, {1, 2, 1}) == "s = gamma f decreases towards the front at x = 0.2");
  // For the other direction of sliding, and for the other sign of gamma, front and rear change places.
  CHECK(why(gamma, {2, 1}, Sliding::minus_x) == "");
  CHECK(why(gamma, {1, 2}, Sliding::minus_x) != "");
  CHECK(why(-gamma, {2, 1}) == "");
  CHECK(why(-gamma, {1, 2}) != "");
  for (const Rational& height : {0_r, 0.001_r, -0.001_r}) {
    const Indenter indenter(-1, {{0.25_r, Polynomial({0, -0.5_r})}, {1, Polynomial({height - 0.25_r, 0.5_r})}});
    CHECK(why_energy_bounds_nothing(reduced({0.1_r, 0.3_r}, {0}, indenter, 1)).empty() == (height == 0));
  }
  CHECK(rc::check([] {
    const ContactProblem problem = *coincidences();
    const std::string here = why_energy_bounds_nothing(problem);
    RC_ASSERT(why_energy_bounds_nothing(problem.mirrored()).empty() == here.empty());
    RC_ASSERT(why_energy_bounds_nothing(problem.mirrored().mirrored()) == here);
  }));
}

TEST_CASE("refused: friction that falls, a tilting indenter, another load, what is no pressure") {
  const ContactProblem problem = parabola_over_a_rise();
  std::vector<double> p = touching(problem, 64);
  const auto reason = [](const ContactProblem& asked, const std::vector<double>& pressures) {
    const CellBound bound = bound_cells(asked, pressures);
    CHECK_FALSE(bound.proved);
    return bound.reason;
  };
  CHECK(reason(problem.with_sliding(Sliding::minus_x), p) ==
        "the energy bounds no error: s = gamma f decreases towards the front at x = 0");
  CHECK(holds(reason(reduced({0.1_r, 0.6_r}, {0}, one_piece(-1, 1, {0, 0, 2.5_r}), 1, 0.1_r), p), "tilt"));
  const Indenter step(-1, {{-0.3_r, Polynomial({0.1_r, 0, 1})}, {1, Polynomial({0, 0, 1})}});
  CHECK(holds(reason(on_two_coatings(step, 0.5_r), p), "a step at x = -0.3"));
  CHECK(holds(reason(problem.with_load(2), p), "the pressures carry 0.5"));
  CHECK(holds(reason(problem, scaled(p, 1.00001)), "of the load"));
  CHECK(reason(problem, {}) == "number of cells");
  CHECK(reason(problem, std::vector<double>(64, 0.0)) == "no cell has a pressure");
  p[3] = -1e-300;
  CHECK(holds(reason(problem, p), "negative or no number"));
  p[3] = std::nan("");
  CHECK(holds(reason(problem, p), "negative or no number"));
}

TEST_CASE("control: a gap looked at in nodes or middles alone would give too small a bound") {
  const ContactProblem problem = parabola_over_a_rise();
  for (const bool middles : {false, true}) {
    const std::vector<double> p = touching(problem, 256);
    const CellPressures pressures(p);
    const CellGap gap(problem, pressures, 128);
    const NearLogarithms e(128);
    Ball mean(0, 128);
    double lowest = 1e300;
    for (std::size_t i = 0; i < gap.size(); ++i) {
      mean += Ball(Rational(pressures.weights()[i]), 128) / Ball(Rational(pressures.total()), 128) * gap.mean(i);
      lowest = std::min(lowest, gap.parts(i).front().value(middles ? 0.5 : 0, e).to_double());
    }
    const double claimed = mean.to_double() - lowest;
    const CellBound bound = bound_cells(problem, p);
    // No bound for these pressures can be smaller: the gap is negative somewhere between.
    CHECK(claimed < 0.99 * bound.sharpness.to_double());
  }
}

TEST_CASE("the gap within cells is that of the logarithm's integrals, and its mean that of Galerkin's operator") {
  const ContactProblem problem(Elasticity::reduced(0.5_r), FrictionProfile({0.2_r, 1.2_r, 3}, {-0.21_r, 0.333_r}),
                               {-1, {{0.111_r, Polynomial({0, 0.1_r, 0.4_r})}, {1, Polynomial({0.3_r, 0, 0, 1})}}},
                               1.5_r);
  constexpr std::size_t n = 23;
  std::vector<double> p(n);
  for (std::size_t i = 0; i < n; ++i) p[i] = i % 7 == 3 ? 0 : 1 + std::sin(static_cast<double>(3 * i));
  double sum = 0;
  for (const double x : p) sum += x;
  const CellPressures pressures(p);
  const CellGap gap(problem, pressures, 128);
  const NearLogarithms e(128);

  const auto friction = [&](double y) {  // int_0^y s p
    double result = 0;
    constexpr int steps = 20000;
    for (int k = 0; k < steps; ++k) {
      const double at = y * (k + 0.5) / steps;
      const double x = -1 + 2 * at / n;
      result += (x < -0.21 ? 0.1 : x < 0.333 ? 0.6 : 1.5) * p[static_cast<std::size_t>(at)] * y / steps;
    }
    return result / sum;
  };
  const auto direct = [&](double y) {
    const auto once = [](double u) { return u == 0 ? 0 : u * std::log(std::abs(u)) - u; };
    double log_part = 0;
    for (std::size_t j = 0; j < n; ++j) {
      const double u = y - static_cast<double>(j);
      log_part += p[j] * (once(u) - once(u - 1));
    }
    const double x = -1 + 2 * y / n;
    const double psi = x < 0.111 ? 0.1 * x + 0.4 * x * x : 0.3 + x * x * x;
    return psi / 1.5 - (log_part / sum + 1) / std::numbers::pi + friction(y);
  };
  double furthest = 0;
  for (std::size_t i = 0; i < n; ++i) {
    for (const GapPart& part : gap.parts(i)) {
      for (const double z : {part.from, (3 * part.from + part.to) / 4, (part.from + part.to) / 2, part.to}) {
        if (std::abs(z - 0.78) < 0.01) continue;  // the step of the profile
        const double y = static_cast<double>(i) + z;
        const bool at_break = std::abs(y - 1.111 * n / 2) < 1e-3;
        if (at_break) continue;
        const double off = std::abs(part.value(z, e).to_double() - direct(y));
        furthest = std::max(furthest, off - part.rest.to_double());
      }
    }
  }
  CHECK(furthest < 2e-4);  // error of the rule for int s p

  const variational::DiscreteProblem discrete(problem, variational::CellMesh(problem, n));
  variational::DiscreteState state;
  for (const double x : p) state.pressure.push_back(x / sum * n);
  const std::vector<double> means = variational::gaps(discrete, state);
  for (std::size_t i = 1; i < n; ++i) {
    CHECK((gap.mean(i) - gap.mean(0)).to_double() == doctest::Approx(means[i] - means[0]).epsilon(1e-11).scale(1));
  }

  // The lower bound is below the gap at many places, but not by more than its sharpness.
  Ball mean(0, 128);
  for (std::size_t i = 0; i < n; ++i) mean += gap.mean(i) * Ball::exactly(p[i] / sum, 128);
  WorkBudget work;
  const LowestGap lowest = lowest_gap(gap, mean, mean, work);
  double seen = 1e300;
  for (int k = 0; k < 23 * 64; ++k) seen = std::min(seen, direct((k + 0.5) / 64));
  CHECK(lowest.bound.to_double() < seen + 2e-4);
  CHECK(lowest.bound.to_double() > seen - 0.02 * (mean.to_double() - seen) - 2e-4);
  CHECK(lowest.bound <= lowest.somewhere);
}

TEST_CASE("what is said of the load left of a jump holds for the energy of any two pressures") {
  REQUIRE(rc::check([] {
    constexpr int n = 40;
    const std::vector<Rational> jumps{Rational(uniform(-90, -1)) / 100, Rational(uniform(1, 90)) / 100};
    // Up to steep rises, for which the bound by jumps is attained.
    const double steepest = std::pow(10, uniform(0, 6));
    const Rational low = Rational(uniform(0, 10)) / 10;
    const Rational middle = low + Rational(uniform(0, 10)) / 20 * Rational(steepest);
    const Rational high = middle + Rational(uniform(0, 10)) / 20 * Rational(steepest);
    const ContactProblem problem = reduced({low, middle, high}, jumps, one_piece(-1, 1, {}), 1);
    const auto random_pressures = [&] {
      std::vector<double> p(n);
      const int zones = uniform(1, 4);
      for (int k = 0; k < zones; ++k) {
        const int begin = uniform(0, n - 1), end = uniform(begin, std::min(begin + 10, n - 1));
        for (int i = begin; i <= end; ++i) p[static_cast<std::size_t>(i)] += uniform(1, 10);
      }
      return p;
    };
    const std::vector<double> one = random_pressures(), two = random_pressures();
    const CellPressures a(one), b(two);
    // d B d by Galerkin's operator, with the same s as on the cells.
    const variational::DiscreteProblem discrete(problem, variational::CellMesh(problem, n));
    std::vector<double> d(n), image(n);
    for (std::size_t i = 0; i < n; ++i) {
      d[i] = n * (static_cast<double>(a.weights()[i]) / static_cast<double>(a.total()) -
                  static_cast<double>(b.weights()[i]) / static_cast<double>(b.total()));
    }
    discrete.galerkin_operator().multiply(d, image);
    double energy = 0;
    for (std::size_t i = 0; i < n; ++i) energy += d[i] * image[i] / n;
    RC_ASSERT(energy > -1e-12 * steepest);
    const LoadBounds bounds(problem, b, Ball::exactly(std::max(energy, 0.0) + 1e-12 * steepest, 64));
    std::vector<Rational> deviations;
    for (const Rational& c : jumps) {
      const Rational y = (c + 1) / 2 * n;
      deviations.push_back(a.load_before(y) / a.total() - b.load_before(y) / b.total());
    }
    for (const std::vector<Rational>& factors : {std::vector<Rational>{1, 0}, {0, 1}, {-1, 1}, {2, 3}}) {
      const Rational deviation = abs(factors[0] * deviations[0] + factors[1] * deviations[1]);
      RC_ASSERT(Ball(deviation, 128) <= bounds.deviation(factors));
    }
  }));
}

TEST_CASE("the charge of two plates all but attains the bound by capacity") {
  constexpr int n = 400, gap = 10;  // between -0.05 and 0.05
  const ContactProblem problem = reduced({0, 0}, {0}, one_piece(-1, 1, {}), 1);
  std::vector<double> left(n), right(n);
  double total = 0;
  for (int i = 0; i < n / 2 - gap; ++i) {
    // 1/sqrt((x+1)(-0.05-x)) over the cell, by arcsin, times the rest in its middle.
    const auto angle = [](int j) { return std::asin(2.0 * j / (n / 2 - gap) - 1); };
    const double x = -1 + (i + 0.5) * 2 / n;
    const double charge = (angle(i + 1) - angle(i)) / std::sqrt((0.05 - x) * (1 - x));
    left[static_cast<std::size_t>(i)] = right[static_cast<std::size_t>(n - 1 - i)] = charge;
    total += charge;
  }
  std::vector<double> before(n), d(n), image(n);
  constexpr double moved = 0.1;  // moved from the right plate to the left one
  for (std::size_t i = 0; i < n; ++i) {
    before[i] = (left[i] + right[i]) / 2;
    d[i] = moved * (left[i] - right[i]) / total * n;
  }
  variational::DiscreteProblem(problem, variational::CellMesh(problem, n)).galerkin_operator().multiply(d, image);
  double energy = 0;
  for (std::size_t i = 0; i < n; ++i) energy += d[i] * image[i] / n;
  const LoadBounds bounds(problem, CellPressures(before), Ball::exactly(energy, 64));
  const double bound = bounds.deviation({1}).to_double();
  CHECK(bound > moved);
  CHECK(bound < 1.25 * moved);
}
