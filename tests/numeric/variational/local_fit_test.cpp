// What fits read off cells next to singular points: on cells whose means are known, those of Riemann-Hilbert forms, on
// such cells spoilt, and on those of the variational solver: exponents that nobody told it.

#include "numeric/variational/local_cases.hpp"

TEST_CASE("intensities and constants of exact cells") {
  for (const Named& named : problems()) {
    CAPTURE(named.name);
    const SolvedCells solution = with_cells(named.problem, 4096);
    for (std::size_t j = 0; j < solution.points.size(); ++j) {
      const auto& point = solution.points[j];
      CAPTURE(point.x.value);
      const double exponent = point.exponent ? to_real<double>(*point.exponent) : 0;
      const FittedIntensity found = fitted_at(named, solution, j, exponent);
      const double theta = point.intensity.value;
      REQUIRE(found.intensity.convergence == Convergence::reached);
      CHECK(found.intensity.value == doctest::Approx(theta).epsilon(1e-6));
      CHECK(std::abs(found.intensity.value - theta) <= found.intensity.error);
      CHECK(found.intensity.error <= 2e-4 * std::abs(theta));
      CHECK(found.constant.value == doctest::Approx(point.constant.value).epsilon(1e-6));
      if (!point.exponent) continue;
      // A wrong exponent is seen by its error alone.
      const FittedIntensity wrong = fitted_at(named, solution, j, reversed(point));
      CHECK(wrong.intensity.error > 0.03 * std::abs(theta));
    }
  }
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
  for (const Named& named : problems()) {
    CAPTURE(named.name);
    SolvedCells solution = with_cells(named.problem, 16384);
    spoil(solution.cells, solution.points, 0);
    for (std::size_t j = 0; j < solution.points.size(); ++j) {
      const auto& point = solution.points[j];
      // Beside a wedge's constant a spoilt constant looks like a power: no solver spoils constants.
      if (!point.exponent || point.kind == SingularKind::wedge_and_jump) continue;
      CAPTURE(point.x.value);
      for (const Side side : sides_of(solution, j)) {
        check_exponent(fitted_exponent(solution.cells.cells(), local_place(solution.points, j), side), point, 3e-3);
      }
    }
  }
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
  for (const std::size_t j : {0, 2}) {
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
  for (const Named& named : problems()) {
    CAPTURE(named.name);
    SolvedCells solution = with_cells(named.problem, 16);
    solution.cells = variational_means(named.problem, 16384);
    const Cells cells = solution.cells.cells();
    for (std::size_t j = 0; j < solution.points.size(); ++j) {
      const auto& point = solution.points[j];
      CAPTURE(point.x.value);
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
      if (!point.exponent) continue;
      for (const Side side : sides_of(solution, j)) {
        const FittedExponent found = fitted_exponent(cells, place, side, is_end(point.kind) ? -1 : named.wedge,
                                                     free ? PlaceIs::to_one_cell : PlaceIs::exact);
        check_exponent(found, point, 1e-3);
      }
    }
  }
}
