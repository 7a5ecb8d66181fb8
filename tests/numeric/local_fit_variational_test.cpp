// What fits read off the variational solver's cells: exponents that nobody told it.

#include "support/local_cases.hpp"
#include "support/numeric_test.hpp"

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
