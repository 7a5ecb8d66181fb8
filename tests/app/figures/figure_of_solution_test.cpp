// The picture of `solve --plot` as data: its curves are the samples of the result, for every method.

#include "app/commands/solver.hpp"
#include "app/results/solution_figure.hpp"
#include "support/test.hpp"

using namespace steadyslide::app;

namespace {

Problem example(const std::string& file) { return read_problem(STEADYSLIDE_EXAMPLES "/" + file); }

/// Solves with the curves of a picture, and with samples at the same places.
SolutionText solved_with_curve(const Problem& problem, Solver::Wanted wanted = {}) {
  wanted.solution.samples = 400;
  wanted.solution.curve = true;
  return Solver(std::move(wanted)).solve(problem);
}

bool has_point(const Series& series, double x, double y) {
  return std::ranges::any_of(series.points, [&](const Point& point) {
    return std::abs(point.x - x) <= 1e-12 && std::abs(point.y - y) <= 1e-9 * std::abs(y) + 1e-12;
  });
}

/// Returns the number of finite tractions in contact, and how many of them, times `factor`, the panel lacks.
std::pair<std::size_t, std::size_t> lacked(const Panel& panel, const SolutionText& solution, double factor = 1) {
  std::size_t all = 0, lacked = 0;
  for (const SampleText& sample : solution.samples) {
    if (std::stod(sample.gap.value) > 0) continue;
    for (const auto limit : {&LimitText::left, &LimitText::right}) {
      const double tractions[] = {-std::stod((sample.traction.*limit).value), std::stod((sample.shear.*limit).value)};
      for (std::size_t k = 0; k < 2; ++k) {
        if (!std::isfinite(tractions[k])) continue;
        ++all;
        lacked += !has_point(panel.series[k], std::stod(sample.x), factor * tractions[k]);
      }
    }
  }
  return {all, lacked};
}

}  // namespace

TEST_CASE("the curves are the samples of the result, for every method") {
  const auto bumps = [](double x) { return (x * x - 1) * (x * x - 1) / 4; };
  const auto flat = [](double) { return 0.0; };
  Solver::Wanted on_cells, proved;
  on_cells.method = Method::variational;
  on_cells.variational.cells = 512;
  on_cells.cells_chosen = true;
  proved.certify = true;
  proved.solution.digits = 30;
  struct Drawn {
    const char* file;
    Solver::Wanted wanted;
    double (*psi)(double);
    std::string method, exponents;
  };
  for (const Drawn& drawn : {Drawn{"two_bumps.toml", {}, bumps, "riemann-hilbert", "0.491 0.563"},
                             {"two_bumps.toml", on_cells, bumps, "variational", ""},
                             {"two_coatings_backward.toml", proved, flat, "closed-form", "0.0471 exponent"},
                             {"three_jumps.toml", {}, flat, "closed-form", "−0.532 −0.0894 0.121 −0.0628 −0.437"}}) {
    const auto& [file, wanted, psi, method, exponents] = drawn;
    CAPTURE(drawn.file);
    const SolutionText solution = solved_with_curve(example(file), wanted);
    const Figure figure = solution_figure(example(file), solution);
    CHECK(figure.title.starts_with(std::string(file) + ", load "));
    CHECK(figure.origin.ends_with(", " + method));
    const Panel &above = figure.panels[0], &below = figure.panels[1];
    for (const std::string& exponent : words(exponents)) {
      CHECK(std::ranges::any_of(below.notes, [&](const Note& note) { return note.text == exponent; }));
    }
    const auto [all, lost] = lacked(below, solution);
    CHECK(all > 1200);
    CHECK(lost == 0);
    // The control: other tractions are not in the picture.
    CHECK(lacked(below, solution, 1.002).second > all / 2);
    for (const SampleText& sample : solution.samples) {
      const double x = std::stod(sample.x);
      if (x < above.x.from || x > above.x.to) continue;
      CHECK(has_point(above.series[2], x, psi(x) - std::stod(sample.gap.value)));
    }
    const std::vector<Point>& bars = above.series[3].points;
    REQUIRE(bars.size() == 2 * solution.contact.size());
    for (std::size_t k = 0; k < solution.contact.size(); ++k) {
      CHECK(bars[2 * k].x == doctest::Approx(std::stod(solution.contact[k].first.x.value)));
      CHECK(bars[2 * k + 1].x == doctest::Approx(std::stod(solution.contact[k].second.x.value)));
    }
  }
}

TEST_CASE("one picture has the tractions of both directions of sliding") {
  const Problem problem = example("two_bumps.toml");
  const Problem turned{problem.contact.with_sliding(Sliding::minus_x), problem.file, problem.measured};
  const BothText both{solved_with_curve(problem), solved_with_curve(turned), {}};
  const Figure figure = solution_figure(problem, turned, both);
  CHECK(lacked(figure.panels[1], both.as_given).second == 0);
  CHECK(lacked(figure.panels[2], both.opposite).second == 0);
  const auto [all, lost] = lacked(figure.panels[1], both.opposite);
  CHECK(lost > all / 2);  // the control
}
