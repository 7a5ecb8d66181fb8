// The numbers in the figures, compared with `solve` and with formulas.

#include "app/figure_problems.hpp"
#include "app/figures/moment_rule.hpp"
#include "app/figures/stress_map.hpp"
#include "numeric/interior/surface_stress.hpp"
#include "numeric/riemann_hilbert/riemann_hilbert.hpp"
#include "proofs_checks/instruments/convergence/convergence_cases.hpp"

using namespace steadyslide::app;

TEST_CASE("the pressures under flat punches agree with solve, also on cells") {
  const std::vector<Series>& series = made("flat-punch").panels.front().series;
  check_curve(series[0], {"0.2", "0", ""});
  check_curve(series[2], {"0.2", "0.3", ""});
  check_curve(series[4], {"0.2", "1", ""});
  const std::vector<Series>& rising = made("friction-jump-rising").panels.front().series;
  check_curve(rising[0], {"0.2", "0.1, 1", "0"});
  check_curve(rising[2], {"0.2", "0.55", ""});
  const std::vector<Series>& falling = made("friction-jump-falling").panels.front().series;
  check_curve(falling[0], {"0.2", "0.1, 1", "0", "0", "1", "-x"});
  std::vector<double> centres;
  for (const Point& p : rising[1].points) centres.push_back(p.x);
  const std::vector<double> found = pressures({"0.2", "0.1, 1", "0"}, centres);
  for (std::size_t k = 0; k < found.size(); ++k)
    CHECK(found[k] == doctest::Approx(rising[1].points[k].y).epsilon(0.01));
  // The curve leaves the frame at the jump up, and reaches the axis at the jump down.
  const auto highest = [](const Series& s) {
    double y = 0;
    for (const Point& p : s.points) {
      if (std::abs(p.x) < 0.5) y = std::max(y, p.y);
    }
    return y;
  };
  CHECK(highest(rising[0]) > made("friction-jump-rising").panels.front().y.to);
  CHECK(highest(falling[0]) < 0.5);
}

TEST_CASE("the parabola agrees with solve and with Galin's formula") {
  const Figure& figure = made("parabola");
  const double a = angle_of_friction(0.5), load = 0.02;
  // c = 2: R of the reduced profile is 2.
  const double half = std::sqrt(load * 2 / (2 * std::numbers::pi * (0.25 - a * a)));
  const GivenProblem given{"0", "1", "", "x^2/2", "0.02"};
  const Series& curve = figure.panels[1].series[0];
  check_curve(curve, given, half, load / half);
  CHECK(curve.points[1].x == doctest::Approx(-(1 + 2 * a)).epsilon(1e-12));
  CHECK(curve.points[curve.points.size() - 2].x == doctest::Approx(1 - 2 * a).epsilon(1e-12));
  // Surface and profile agree in the contact, and only there.
  const std::vector<Series>& heights = figure.panels[0].series;
  for (std::size_t i = 0; i < heights[0].points.size(); ++i) {
    const Point& profile = heights[0].points[i];
    const double gap = profile.y - heights[1].points[i].y;
    const bool inside = profile.x > -(1 + 2 * a) && profile.x < 1 - 2 * a;
    CHECK((inside ? std::abs(gap) < 1e-9 : gap > 1e-6));
  }
}

TEST_CASE("tractions on the body agree with solve, with lengths and angles to scale") {
  const Figure& figure = made("reactions");
  for (const int f : {0, 1}) {
    const Panel& panel = figure.panels[static_cast<std::size_t>(f)];
    const double across = 800 * (panel.frame.right - panel.frame.left) / (panel.x.to - panel.x.from);
    const double upwards = figure.height * (panel.frame.top - panel.frame.bottom) / (panel.y.to - panel.y.from);
    CHECK(across == doctest::Approx(upwards).epsilon(1e-12));
    std::vector<double> places, down;
    for (std::size_t k = 0; k < 7; ++k) {
      const Guide& arrow = panel.guides[k];
      places.push_back(arrow.from.x);
      down.push_back(arrow.from.y - arrow.to.y);
      CHECK(arrow.to.x - arrow.from.x == doctest::Approx(f * down[k]).scale(1).epsilon(1e-12));
      CHECK(arrow.from.y == doctest::Approx(arrow.from.x * arrow.from.x / 2).scale(1).epsilon(1e-12));
    }
    const std::vector<double> found = pressures({"0", std::to_string(f), "", "x^2/2", "0.25"}, places);
    for (std::size_t k = 0; k < 7; ++k) CHECK(found[k] * down[0] == doctest::Approx(found[0] * down[k]).epsilon(1e-9));
    CHECK(down[0] != doctest::Approx(down[3]).epsilon(0.1).scale(0));
  }
}

TEST_CASE("local forms have the derived slopes, also on cells") {
  const Figure& figure = made("local-forms");
  const double a = angle_of_friction(0.375), beta = angle_of_friction(0.0375) - a;
  const double weak[] = {0.5 - a, 0.5 + a, -beta};
  const double strong[] = {-0.5 - a, -0.5 + a, beta};
  for (std::size_t k = 0; k < 3; ++k) {
    for (const auto& [panel, exponent] : {std::pair(0, strong[k]), {1, weak[k]}}) {
      const std::vector<Series>& series = figure.panels[static_cast<std::size_t>(panel)].series;
      const Series& line = series[2 * k];
      CAPTURE(line.legend);
      CHECK(log_slope(line.points[0], line.points[5]) == doctest::Approx(exponent).epsilon(1e-4));
      CHECK(log_slope(line.points[0], line.points[5]) != doctest::Approx(-1 - exponent).epsilon(1e-3));
      const std::string text = decimal(exponent, 4);
      CHECK(holds(line.legend, ": " + text + ", cells " + text.substr(0, text.size() - 1)));
    }
  }
  // The wedge: differences of a logarithm. The jump of the slope is 2, c = 1.92.
  const std::vector<Point>& wedge = figure.panels[0].series[6].points;
  const double factor = (wedge[0].y - wedge[5].y) / std::log(wedge[5].x / wedge[0].x) * std::numbers::pi;
  CHECK(factor == doctest::Approx(2 / 1.92 / (1 + 0.375 * 0.375)).epsilon(1e-3));
}

TEST_CASE("contact zones agree with solve, and end b moves as derived") {
  const Figure& figure = made("contact-load");
  const std::vector<Series>& one = figure.panels[0].series;
  const double c = 2 * (1 - 0.09), gamma = 2.0 / 7;
  for (std::size_t k = 0; k < 2; ++k) {
    const bool rising = k == 0;
    const std::vector<Point>&rear = one[2 * k].points, &front = one[2 * k + 1].points;
    const Point& p = front[80];
    const std::string text =
        solve_answer({"0.3", rising ? "0.1, 2" : "2, 0.1", "0.15", "x^2/2", fmt::format("{:.17g}", p.x)});
    CHECK(value_after(text, "from x = ") == doctest::Approx(rear[80].y).epsilon(1e-9));
    CHECK(value_after(text, " to x = ") == doctest::Approx(p.y).epsilon(1e-9));
    // db/dP = c/(pi (1/2 + alpha)(b - a)), before and after the jump.
    for (const std::size_t i : {20U, 90U}) {
      const double rate = (front[i + 1].y - front[i - 1].y) / (front[i + 1].x - front[i - 1].x);
      const bool before = front[i].y < 0.15;
      CHECK(before == (i == 20));
      const double f = rising == before ? 0.1 : 2;
      const auto derived = [&](double s) {
        return c / (std::numbers::pi * (0.5 + angle_of_friction(s)) * (front[i].y - rear[i].y));
      };
      CHECK(rate == doctest::Approx(derived(gamma * f)).epsilon(0.01));
      CHECK(rate != doctest::Approx(derived(gamma * (2.1 - f))).epsilon(0.05));
    }
  }
  // The loads between which the zones merge, in examples/two_bumps.toml.
  const double merged = figure.panels[1].series[2].points.back().x;
  CHECK(merged > 0.77);
  CHECK(merged < 0.78);
  const double inner = figure.panels[1].series[2].points.back().y;
  CHECK(std::abs(inner - figure.panels[1].series[3].points.back().y) < 0.01);
}

TEST_CASE("effective friction agrees with solve, and not with the mean") {
  const Figure& figure = made("effective-friction");
  for (const std::size_t direction : {0U, 1U}) {
    const Point& p = figure.panels[0].series[2 * direction].points[60];
    const GivenProblem given{"0.2", "0.1, 1", fmt::format("\"{:.17g}\"", p.x), "0", "1", direction == 0 ? "+x" : "-x"};
    CHECK(value_after(solve_answer(given), "effective friction") == doctest::Approx(p.y).epsilon(1e-9));
    const Point& marked = figure.panels[1].series[2 * direction + 1].points[4];
    const GivenProblem other{
        "0.2", fmt::format("0.1, \"{:.17g}\"", marked.x), "0", "0", "1", direction == 0 ? "+x" : "-x"};
    CHECK(value_after(solve_answer(other), "effective friction") == doctest::Approx(marked.y).epsilon(0.01));
    CHECK(std::abs(marked.y - (0.1 + marked.x) / 2) > 0.05);
  }
}

TEST_CASE("both solvers converge as derived") {
  const Figure& figure = made("convergence");
  const std::vector<Series>& cells = figure.panels[0].series;
  const double derived[] = {1, 1, 2};
  for (std::size_t k = 0; k < 3; ++k) {
    const std::vector<Point>& marks = cells[2 * k].points;
    CHECK(-log_slope(marks.front(), marks.back()) == doctest::Approx(derived[k]).epsilon(0.1));
    CHECK(-log_slope(cells[2 * k + 1].points[0], cells[2 * k + 1].points[1]) == doctest::Approx(derived[k]));
  }
  const std::vector<Series>& rules = figure.panels[1].series;
  for (const std::size_t k : {0U, 1U}) {
    const std::vector<Point>& marks = rules[k].points;
    const double rate = std::log(marks[13].y / marks[3].y) / (marks[13].x - marks[3].x);
    CHECK(rate == doctest::Approx(-2 * std::log(3 + std::sqrt(8.0))).epsilon(0.05));
    CHECK(rate != doctest::Approx(-2 * std::log(2 + std::sqrt(3.0))).epsilon(0.1));
    CHECK(marks.back().y < 1e-50);
  }
}

TEST_CASE("the stress map reaches the tractions at the surface") {
  const ContactProblem problem = stress_map_problem();
  const auto solution = solved_by_singular_functions(problem);
  const double near = surface_error(*solution, problem, 0.001_r);
  const double nearer = surface_error(*solution, problem, Rational(1, 1000000));
  CHECK(near < 0.002);
  CHECK(nearer == doctest::Approx(near / 1000).epsilon(0.1));
  // The control: the shear with the opposite sign.
  const numeric::InteriorStress<double> interior(*solution);
  const auto below = interior.at(0.5_r, 0.001_r);
  const auto at_surface = numeric::surface_stress(problem.elasticity(), solution->details_at(0.5_r));
  CHECK(std::abs(below.xz.value + at_surface.xz.value) > 0.1);

  const Figure& figure = made("stress-map");
  const HeatMap& map = *figure.panels.front().map;
  CHECK(holds(figure.caption, "at most " + decimal(std::ceil(1e4 * near) / 1e4, 4)));
  CHECK(map.values.size() == map.x.size() * map.y.size());
  const std::size_t row = 40;
  for (const std::size_t i : {10U, 150U, 200U}) {
    const auto stress = interior.at(Rational(map.x[i]), Rational(map.y[row]));
    CHECK(map.values[row * map.x.size() + i] == doctest::Approx(stress.von_mises()->value).epsilon(1e-9));
  }
  // The first row is the limit from below.
  for (const std::size_t i : {10U, 120U, 200U, 310U}) {
    const auto stress = interior.at(Rational(map.x[i]), Rational(1, 1000000));
    CHECK(map.values[i] == doctest::Approx(stress.von_mises()->value).epsilon(1e-4));
  }
}

TEST_CASE("layouts of coatings agree with solve and with design, and the order is that of the last periods") {
  const Figure& figure = made("coating-layouts");
  const std::vector<Series>& curves = figure.panels[0].series;
  REQUIRE(curves.size() == 8);
  for (const std::size_t k : {0U, 1U, 2U, 3U}) {
    const Point& p = curves[2 * k].points[60];
    const std::string friction = k < 2 ? "0.5, 0.1, 0.5" : "0.1, 0.5, 0.1";
    const GivenProblem given{"0.2", friction, fmt::format("\"{:.17g}\", \"{:.17g}\"", p.x - 0.5, p.x + 0.5),
                             "0",   "1",      k % 2 == 0 ? "+x" : "-x"};
    CHECK(value_after(solve_answer(given), "effective friction") == doctest::Approx(p.y).epsilon(1e-9));
    for (const Point& marked : curves[2 * k + 1].points) {
      const Point& line = curves[2 * k].points[static_cast<std::size_t>(std::lround(100 * marked.x)) + 49];
      CHECK(marked.y == doctest::Approx(line.y).epsilon(0.01));
    }
  }
  const std::vector<Guide>& extremes = figure.panels[0].guides;
  for (const Point& p : curves[0].points) CHECK(p.y <= extremes[0].from.y + 1e-12);
  for (const Point& p : curves[4].points) CHECK(p.y >= extremes[1].from.y - 1e-12);
  CHECK(extremes[0].from.y == doctest::Approx(0.367149).epsilon(1e-6));
  CHECK(extremes[1].from.y == doctest::Approx(0.231489).epsilon(2e-6));
  for (const std::size_t k : {0U, 2U}) {
    const std::vector<Point>& marks = figure.panels[1].series[k].points;
    const std::vector<Point>& line = figure.panels[1].series[k + 1].points;
    const double order = std::log(line[0].y / line[1].y) / std::log(line[1].x / line[0].x);
    CHECK(order == doctest::Approx(0.5 - std::atan(2) / (2 * std::numbers::pi)));
    CHECK(std::abs(std::log2(marks[marks.size() - 2].y / marks.back().y) - order) < 0.02);
  }
}
