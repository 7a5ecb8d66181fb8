// Fits to cells next to singular points of every kind: on exact means of the traction of a Riemann-Hilbert form, on
// such means with added errors, and on the cells of the variational solver, which does not know the exponents.

#include "numeric/variational/local_fit.hpp"

#include <boost/math/quadrature/gauss.hpp>
#include <random>

#include "numeric/variational/nested_solve.hpp"
#include "support/solved_contact.hpp"

using namespace steadyslide::numeric::variational;

namespace {

struct CellMeans {
  std::vector<double> edges;
  std::vector<double> mean;
  double length;

  Cells cells() const { return {edges, mean}; }
};

/// `count` equal cells on the support, in the user's x. Gauss's rule is exact except in the cells next to a singular
/// point; no fit uses those.
CellMeans cell_means(const ContactProblem& problem, const RiemannHilbertSolution<double>& solution, std::size_t count) {
  using Rule = boost::math::quadrature::gauss<double, 7>;
  const auto& form = solution.form();
  const auto& set = form.set();
  const double unit = to_real<double>(form.problem().frame().unit);
  const double origin = to_real<double>(form.problem().frame().origin);
  const double left = to_real<double>(problem.indenter().left());
  const double right = to_real<double>(problem.indenter().right());
  CellMeans result{{}, std::vector<double>(count), (right - left) / static_cast<double>(count)};
  for (std::size_t i = 0; i <= count; ++i) result.edges.push_back(left + result.length * static_cast<double>(i));
  for (std::size_t k = 0; k < set.segments(); ++k) {
    if (!set.in_contact(k)) continue;
    for (std::size_t i = 0; i < count; ++i) {
      const double from = std::max((result.edges[i] - origin) / unit, set.x(k));
      const double to = std::min((result.edges[i + 1] - origin) / unit, set.x(k + 1));
      if (!(from < to)) continue;
      const auto t = [&](double xi) {
        return form.traction(surface_point(set, k, xi - set.x(k), set.x(k + 1) - xi)).value;
      };
      result.mean[i] += Rule::integrate(t, from, to) * unit / result.length;
    }
  }
  return result;
}

/// The variational solver's cells, in the user's x and units.
CellMeans variational_means(const ContactProblem& problem, std::size_t count) {
  const NestedResult found = solve_nested(problem, {.cells = count});
  REQUIRE(found.certificate.accepted());
  const CellMesh& mesh = found.fine.problem->mesh();
  const double unit = to_real<double>(mesh.frame().unit);
  const double origin = to_real<double>(mesh.frame().origin);
  CellMeans result{{}, {}, unit * mesh.length(0)};
  for (const double xi : mesh.edges()) result.edges.push_back(origin + unit * xi);
  const double pressure = to_real<double>(problem.load()) / unit;
  for (const double p : found.fine.found.state.pressure) result.mean.push_back(-pressure * p);
  return result;
}

/// Returns the place near x at which contact begins or ends on the cells.
double end_on_cells(const CellMeans& cells, double x, Side contact) {
  auto i = static_cast<std::size_t>((x - cells.edges.front()) / cells.length);
  const bool right = contact == Side::right;
  for (i = right ? i + 5 : i - 5; cells.mean[i] != 0; i = right ? i - 1 : i + 1) {
  }
  return cells.edges[right ? i + 1 : i];
}

/// The neighbouring singular points of the contact on both sides of point j.
LocalPlace local_place(const std::vector<SolvedSingularPoint<double>>& points, std::size_t j) {
  LocalPlace result{points[j].x.value};
  if (j > 0) result.left = points[j].x.value - points[j - 1].x.value;
  if (j + 1 < points.size()) result.right = points[j + 1].x.value - points[j].x.value;
  return result;
}

/// Adds errors: half of the value in the four cells next to each singular point, falling with the square of the
/// distance; an error as smooth as the length of the cells; and 16 `random`/d^2 at a distance of d cells, independent
/// from cell to cell.
void spoil(CellMeans& cells, const std::vector<SolvedSingularPoint<double>>& points, double random) {
  std::mt19937 generator(2016);
  std::uniform_real_distribution<double> sign(-1, 1);
  for (std::size_t i = 0; i < cells.mean.size(); ++i) {
    double error = 1e-3 * cells.length * std::cos(cells.edges[i]);
    for (const auto& point : points) {
      const double distance = std::abs((cells.edges[i] + cells.edges[i + 1]) / 2 - point.x.value) / cells.length;
      error += std::min(1.0, 16 / (distance * distance)) * (0.5 + random * sign(generator));
    }
    cells.mean[i] *= 1 + error;
  }
}

struct Named {
  std::string name;
  ContactProblem problem;
  int wedge = -1;  ///< degree of the jump of the slope
};

std::vector<Named> problems() {
  const Rational low = 0.1_r, high = 0.6_r;
  const Indenter flat = one_piece(-1, 1, {0});
  const Indenter parabola = one_piece(-1, 1, {0, 0, 2.5_r});
  const Indenter wedge(-1, {{0, Polynomial({0, -0.5_r})}, {1, Polynomial({0, 0.5_r, 0.5_r})}});
  const Indenter step(-1, {{-0.2_r, Polynomial({0.1_r, 0, 0.5_r})}, {1, Polynomial({0, 0, 0.5_r})}});
  return {{"flat punch", reduced({high}, {}, flat, 1)},
          {"flat punch, a jump down", reduced({high, low}, {0.3_r}, flat, 1)},
          {"flat punch, three jumps", reduced({low, 0.4_r, 0, 0.2_r}, {-0.5_r, 0.1_r, high}, flat, 1)},
          {"parabola", reduced({0.3_r}, {}, parabola, 1)},
          {"parabola, a jump up", reduced({low, high}, {0}, parabola, 1)},
          {"parabola, a jump down", reduced({high, low}, {0}, parabola, 1)},
          {"two bumps", reduced({0.3_r}, {}, one_piece(-2, 2, {1, 0.2_r, -2, 0, 1}), 2)},
          {"a step", reduced({0.3_r}, {}, step, 0.2_r)},
          {"wedge", reduced({0.3_r}, {}, wedge, 1), 1},
          {"wedge, a jump up", reduced({low, high}, {0}, wedge, 1), 1},
          {"wedge, a jump down", reduced({high, low}, {0}, wedge, 1), 1}};
}

struct SolvedCells {
  std::vector<SolvedSingularPoint<double>> points;
  std::vector<Side> contact;  ///< the side of contact at each end
  CellMeans cells;
};

SolvedCells with_cells(const ContactProblem& problem, std::size_t count) {
  const auto solution = solved<double>(problem);
  SolvedCells result{solution->singular_points(), {}, cell_means(problem, *solution, count)};
  for (const auto& point : result.points) {
    bool left = false;
    for (const auto& zone : solution->contact()) left = left || zone.left.x.value == point.x.value;
    result.contact.push_back(left ? Side::right : Side::left);
  }
  return result;
}

double s_at(const ContactProblem& problem, double x, Side side) {
  // Next to x: a place in double may miss the jump by rounding.
  const Rational c(x + (side == Side::left ? -1e-9 : 1e-9));
  return to_real<double>(problem.coupled_friction(problem.friction().piece(c, side)));
}

double cosine(double s) { return 1 / std::hypot(1, s); }

FittedIntensity fitted_at(const Named& named, const SolvedCells& solution, std::size_t j, double exponent) {
  const auto& point = solution.points[j];
  const LocalPlace place = local_place(solution.points, j);
  const Cells cells = solution.cells.cells();
  const double left = s_at(named.problem, place.x, Side::left);
  const double right = s_at(named.problem, place.x, Side::right);
  if (local_terms(point.kind).is_end) return fitted_end(cells, place, solution.contact[j], exponent);
  if (point.kind == SingularKind::wedge) return fitted_wedge(cells, place, left, named.wedge);
  return fitted_jump(cells, place, exponent, cosine(left), cosine(right), named.wedge);
}

/// The exponent for the opposite direction of sliding.
double reversed(const SolvedSingularPoint<double>& point) {
  const double lambda = to_real<double>(*point.exponent);
  if (point.kind == SingularKind::free) return 1 - lambda;
  return local_terms(point.kind).is_end ? -1 - lambda : -lambda;
}

std::vector<Side> sides_of(const SolvedCells& solution, std::size_t j) {
  if (local_terms(solution.points[j].kind).is_end) return {solution.contact[j]};
  return {Side::left, Side::right};
}

/// Checks that an error bar contains the derived exponent, and not the one of the opposite direction of sliding.
void check_exponent(const FittedExponent& found, const SolvedSingularPoint<double>& point, double most) {
  const double lambda = to_real<double>(*point.exponent);
  CHECK(found.exponent.convergence == Convergence::reached);
  CHECK(std::abs(found.exponent.value - lambda) <= found.exponent.error);
  CHECK(std::abs(found.exponent.value - reversed(point)) > found.exponent.error);
  CHECK(found.exponent.error <= most);
}

/// Calls act(named, solution, j) at every singular point of every problem, on `count` cells that `change` modifies.
template <class Change, class Act>
void at_all_points(std::size_t count, const Change& change, const Act& act) {
  for (const Named& named : problems()) {
    CAPTURE(named.name);
    SolvedCells solution = with_cells(named.problem, count);
    change(named, solution);
    for (std::size_t j = 0; j < solution.points.size(); ++j) {
      CAPTURE(solution.points[j].x.value);
      act(named, solution, j, solution.points[j]);
    }
  }
}

using Point = SolvedSingularPoint<double>;

}  // namespace

TEST_CASE("intensities and constants of exact cells") {
  const auto exact = [](const Named&, SolvedCells&) {};
  at_all_points(4096, exact, [](const Named& named, const SolvedCells& solution, std::size_t j, const Point& point) {
    const double exponent = point.exponent ? to_real<double>(*point.exponent) : 0;
    const FittedIntensity found = fitted_at(named, solution, j, exponent);
    const double theta = point.intensity.value;
    REQUIRE(found.intensity.convergence == Convergence::reached);
    CHECK(found.intensity.value == doctest::Approx(theta).epsilon(1e-6));
    CHECK(std::abs(found.intensity.value - theta) <= found.intensity.error);
    CHECK(found.intensity.error <= 2e-4 * std::abs(theta));
    CHECK(found.constant.value == doctest::Approx(point.constant.value).epsilon(1e-6));
    if (!point.exponent) return;
    // A wrong exponent is noticed by its error.
    const FittedIntensity wrong = fitted_at(named, solution, j, reversed(point));
    CHECK(wrong.intensity.error > 0.03 * std::abs(theta));
  });
}

TEST_CASE("the intensity of a wedge needs the step that friction makes there") {
  const Named named = problems()[8];
  const SolvedCells solution = with_cells(named.problem, 4096);
  const LocalPlace place = local_place(solution.points, 1);
  const double theta = solution.points[1].intensity.value;
  CHECK(fitted_wedge(solution.cells.cells(), place, 0.3, 1).intensity.value == doctest::Approx(theta).epsilon(1e-6));
  for (const double s : {0., -0.3, 0.33}) {
    CHECK(fitted_wedge(solution.cells.cells(), place, s, 1).intensity.value != doctest::Approx(theta).epsilon(1e-3));
  }
}

TEST_CASE("exponents of spoilt cells") {
  const auto spoilt = [](const Named&, SolvedCells& solution) { spoil(solution.cells, solution.points, 0); };
  at_all_points(16384, spoilt, [](const Named&, const SolvedCells& solution, std::size_t j, const Point& point) {
    // Beside the constant of a wedge, a wrong constant looks like a power. Solvers make no wrong constants.
    if (!point.exponent || point.kind == SingularKind::wedge_and_jump) return;
    for (const Side side : sides_of(solution, j)) {
      check_exponent(fitted_exponent(solution.cells.cells(), local_place(solution.points, j), side), point, 3e-3);
    }
  });
}

TEST_CASE("bars grow with errors that no series follows") {
  const SolvedCells exact = with_cells(problems()[5].problem, 16384);
  double before = 0;
  for (const double random : {0., 1e-4, 1e-3, 1e-2}) {
    CAPTURE(random);
    SolvedCells solution = exact;
    spoil(solution.cells, solution.points, random);
    const FittedExponent found = fitted_exponent(solution.cells.cells(), local_place(solution.points, 1), Side::left);
    CHECK(std::abs(found.exponent.value - to_real<double>(*solution.points[1].exponent)) <= found.exponent.error);
    CHECK(found.exponent.error > before);
    before = 3 * found.exponent.error;
  }
}

TEST_CASE("noise that the fits of a family share is in the bar: how often it misses the exponent") {
  std::mt19937 generator(32);
  std::uniform_real_distribution<double> sign(-1, 1);
  int told = 0, missed = 0;
  for (int draw = 0; draw < 60; ++draw) {
    const double lambda = 0.4 * sign(generator);
    CellMeans noisy{{0}, {}, 1};
    for (int i = 0; i < 250; ++i) {
      noisy.edges.push_back(i + 1);
      const double mean = (std::pow(i + 1, lambda + 1) - std::pow(i, lambda + 1)) / (lambda + 1);
      noisy.mean.push_back(-mean * (1 + 1e-9 * sign(generator)));
    }
    const LocalPlace place{0, std::numeric_limits<double>::infinity(), 200};
    const Estimate<double> found = fitted_exponent(noisy.cells(), place, Side::right, 0).exponent;
    if (!std::isfinite(found.error)) continue;
    ++told;
    if (std::abs(found.value - lambda) > found.error) ++missed;
  }
  CHECK(told > 50);
  // With the spread alone, 7 would miss.
  CHECK(missed <= 3);
  // The result of fits that agree up to noise.
  const Estimate<double> agreed = of_family({1, 1, 1.5, 1}, {0.5, 0.25, 0.25, 0.25});
  CHECK(agreed.value == 1);
  CHECK(agreed.error == 0.75);
}

TEST_CASE("cells too few for the family say so") {
  const Named named = problems()[5];
  const SolvedCells solution = with_cells(named.problem, 128);
  const FittedExponent exponent = fitted_exponent(solution.cells.cells(), local_place(solution.points, 1), Side::left);
  CHECK(exponent.exponent.convergence == Convergence::stalled);
  CHECK(std::isinf(exponent.exponent.error));
  const FittedIntensity intensity = fitted_at(named, solution, 1, to_real<double>(*solution.points[1].exponent));
  CHECK(intensity.intensity.convergence == Convergence::stalled);
}

TEST_CASE("a free end is found where it is, from the cell it lies in") {
  const Named named = problems()[4];
  const SolvedCells solution = with_cells(named.problem, 4096);
  const Cells cells = solution.cells.cells();
  for (const std::size_t j : {0U, 2U}) {
    const auto& point = solution.points[j];
    const double lambda = to_real<double>(*point.exponent);
    for (const double shift : {-1., 0.4, 1.}) {
      CAPTURE(shift);
      LocalPlace place = local_place(solution.points, j);
      place.x += shift * solution.cells.length;
      const FittedIntensity found = fitted_end(cells, place, solution.contact[j], lambda, PlaceIs::to_one_cell);
      CHECK(std::abs(found.place.value - point.x.value) < 1e-5 * solution.cells.length);
      CHECK(found.intensity.value == doctest::Approx(point.intensity.value).epsilon(1e-6));
      const FittedIntensity misplaced = fitted_end(cells, place, solution.contact[j], lambda);
      CHECK(misplaced.intensity.value != doctest::Approx(point.intensity.value).epsilon(1e-6));
      const FittedExponent exponent = fitted_exponent(cells, place, solution.contact[j], -1, PlaceIs::to_one_cell);
      check_exponent(exponent, point, 3e-3);
      CHECK(std::abs(exponent.place.value - point.x.value) < 1e-2 * solution.cells.length);
    }
  }
}

TEST_CASE("the variational solver finds the exponents that the local analysis derives") {
  const auto by_solver = [](const Named& named, SolvedCells& solution) {
    solution.cells = variational_means(named.problem, 16384);
  };
  at_all_points(16, by_solver, [](const Named& named, const SolvedCells& solution, std::size_t j, const Point& point) {
    const Cells cells = solution.cells.cells();
    LocalPlace place = local_place(solution.points, j);
    const bool free = point.kind == SingularKind::free;
    if (free) place.x = end_on_cells(solution.cells, place.x, solution.contact[j]);
    const double exponent = point.exponent ? to_real<double>(*point.exponent) : 0;
    const FittedIntensity intensity =
        free ? fitted_end(cells, place, solution.contact[j], exponent, PlaceIs::to_one_cell)
             : fitted_at(named, solution, j, exponent);
    CHECK(intensity.intensity.value == doctest::Approx(point.intensity.value).epsilon(5e-5));
    CHECK(std::abs(intensity.constant.value - point.constant.value) <= 5e-6);
    CHECK(std::abs(intensity.place.value - point.x.value) <= 0.1 * solution.cells.length);
    if (!point.exponent) return;
    for (const Side side : sides_of(solution, j)) {
      const FittedExponent found =
          fitted_exponent(cells, place, side, local_terms(point.kind).is_end ? -1 : named.wedge,
                          free ? PlaceIs::to_one_cell : PlaceIs::exact);
      check_exponent(found, point, 1e-3);
    }
  });
}

TEST_CASE("a friction jump on a layer has the half-plane's exponent on cells") {
  const Solid solid(0.2_r, 1);
  const Body layer = Body::layered({{0.4_r, solid}}, std::nullopt);
  for (const auto& [left, right] : {std::pair(0.3_r, 2_r), std::pair(2_r, 0.3_r)}) {
    const ContactProblem problem =
        ContactProblem(Elasticity(solid), FrictionProfile({left, right}, {0}), one_piece(-1, 1, {0, 0, 0.5_r}), 0.3_r)
            .with_body(layer);
    const CellMeans cells = variational_means(problem, 16384);
    const auto is_contact = [](double mean) { return mean != 0; };
    const auto first = std::ranges::find_if(cells.mean, is_contact) - cells.mean.begin();
    const auto end =
        std::ranges::find_if(cells.mean.rbegin(), cells.mean.rend(), is_contact).base() - cells.mean.begin();
    const LocalPlace place{0, -cells.edges[static_cast<std::size_t>(first)],
                           cells.edges[static_cast<std::size_t>(end)]};
    const double exponent = (std::atan(s_at(problem, 0, Side::left)) - std::atan(s_at(problem, 0, Side::right))) / M_PI;
    for (const Side side : {Side::left, Side::right}) {
      const FittedExponent found = fitted_exponent(cells.cells(), place, side);
      CHECK(found.exponent.convergence == Convergence::reached);
      CHECK(std::abs(found.exponent.value - exponent) <= std::min(found.exponent.error, 1e-3));
      CHECK(found.exponent.error < std::abs(exponent) / 10);
    }
  }
}
