// The sketch, maps, zones and exponents in the figures, compared with `solve` and with formulas.

#include <cmath>
#include <regex>
#include <set>

#include "app/figure_problems.hpp"
#include "app/figures/stress_map.hpp"

using namespace steadyslide::app;

namespace {

/// Checks that the labels of a map's contours are at places where `function` has their value, and that each value is a
/// level of the map. Returns the number of labelled levels.
template <class Function>
std::size_t check_labels(const Figure& figure, Function function) {
  constexpr double size = 11;
  const auto& [left, right, bottom, top] = figure.panels.front().frame;
  const Axis &across = figure.panels.front().x, &up = figure.panels.front().y;
  static const std::regex label(
      "translate\\(([0-9.]+),([0-9.]+)\\)\"[^>]*font-size=\"11.00\"[^>]*>\\s*<text><tspan[^>]*>((?:−)?)([0-9.]+)<");
  const std::string svg = draw(figure).picture;
  const std::vector<double>& levels = figure.panels.front().map->contours;
  std::set<std::ptrdiff_t> labelled;
  for (std::sregex_iterator found(svg.begin(), svg.end(), label), end; found != end; ++found) {
    const double number = std::stod(found->str(4)) * (found->length(3) > 0 ? -1 : 1);
    // The text's place is on its base line; the middle of a label is its place on the map.
    const double right_of = std::stod(found->str(1)) / 800,
                 above = 1 - (std::stod(found->str(2)) - size / 3) / figure.height;
    const double x = across.from + (right_of - left) / (right - left) * (across.to - across.from);
    const double y = up.from + (above - bottom) / (top - bottom) * (up.to - up.from);
    CAPTURE(number);
    const auto level = std::ranges::find_if(levels, [&](double one) { return std::abs(one - number) < 1e-9; });
    REQUIRE(level != levels.end());
    labelled.insert(level - levels.begin());
    CHECK(function(x, y) == doctest::Approx(number).epsilon(0.02).scale(0.1));
    CHECK(function(x, y) != doctest::Approx(number + 0.02).epsilon(0.02).scale(0.1));
  }
  return labelled.size();
}

bool has_note(const Panel& panel, const std::string& text) {
  return std::ranges::any_of(panel.notes, [&](const Note& note) { return note.text == text; });
}

}  // namespace

TEST_CASE("the sketch has the contact of solve, and the surface beside it lies below the indenter") {
  const Panel& panel = made("sketch").panels.front();
  CHECK(panel.bare);
  const double left = panel.guides[6].from.x, right = panel.guides[7].from.x;
  const std::vector<double> pressure =
      pressures({"0.2", "0.3, 1", "0.2", "x^2/3", "0.25"}, {left - 0.001, left + 0.001, right - 0.001, right + 0.001});
  CHECK(pressure[0] == 0);
  CHECK(pressure[1] > 0);
  CHECK(pressure[2] > 0);
  CHECK(pressure[3] == 0);
  for (const Point& surface : panel.series[2].points) {
    const double gap = surface.x * surface.x / 3 - surface.y;
    const bool inside = surface.x >= left && surface.x <= right;
    CHECK((inside ? std::abs(gap) < 1e-9 : gap > 0));
  }
  // z = 0 is the mean height of the surface's ends.
  const std::vector<Point>& surface = panel.series[2].points;
  CHECK(panel.guides[2].from.y == doctest::Approx((surface.front().y + surface.back().y) / 2));
  // The coatings meet at the jump.
  CHECK(panel.series[3].points.back().x == doctest::Approx(0.2));
  CHECK(panel.series[4].points.front().x == doctest::Approx(0.2));
}

TEST_CASE("the map of exponents agrees with `exponents`, is 0 without a jump, and has its labels on their contours") {
  const Panel& panel = made("jump-exponent").panels.front();
  const HeatMap& map = *panel.map;
  CHECK(map.from == -map.to);
  const std::size_t n = map.x.size();
  for (const auto& [i, j] : {std::pair(25, 75), {80, 10}}) {
    const GivenProblem given{"0.2", fmt::format("\"{}\", \"{}\"", map.x[std::size_t(i)], map.y[std::size_t(j)]), "0"};
    const std::string rows = out_of(run_alone({"exponents", "-", "--format", "csv"}, given.toml()));
    const std::size_t at = rows.find("friction_jump,both,");
    REQUIRE(at != std::string::npos);
    const double exponent = std::stod(rows.substr(rows.find(',', at + 19) + 1));
    const double drawn = map.values[std::size_t(j) * n + std::size_t(i)];
    CHECK(drawn == doctest::Approx(exponent).epsilon(1e-9).scale(0));
    CHECK((i < j ? drawn < 0 : drawn > 0));
  }
  for (std::size_t i = 0; i < n; ++i) CHECK(map.values[i * n + i] == 0);
  const auto beta = [](double left, double right) {
    return angle_of_friction(0.375 * left) - angle_of_friction(0.375 * right);
  };
  CHECK(check_labels(made("jump-exponent"), beta) == map.contours.size());
}

TEST_CASE("the figures of two zones and of one agree with solve") {
  const Figure& figure = made("two-zones");
  const std::vector<Series>& surfaces = figure.panels[0].series;
  const std::vector<Series>& curves = figure.panels[1].series;
  REQUIRE(curves.size() == 4);
  const char* loads[] = {"0.1", "0.4", "0.77", "1.1"};
  for (std::size_t k = 0; k < 4; ++k) {
    const GivenProblem given{"0.3", "0.1, 0.7", "0", "(x^2-1)^2/4", loads[k], "+x", "-2, 2"};
    check_curve(curves[k], given);
    const std::string text = solve_answer(given);
    CHECK(holds(curves[k].legend, k < 3 ? "two zones" : "one zone"));
    CHECK(std::ranges::count_if(lines(text), [](const std::string& line) { return line.starts_with("  from x = "); }) ==
          (k < 3 ? 2 : 1));
    // The surface never rises above the bumps.
    for (const Point& p : surfaces[k + 1].points) {
      CHECK(p.y <= (p.x * p.x - 1) * (p.x * p.x - 1) / 4 + 1e-12);
    }
  }
  CHECK(
      has_note(figure.panels[1], "β = " + decimal(angle_of_friction(0.1 * 2 / 7) - angle_of_friction(0.7 * 2 / 7), 4)));
}

TEST_CASE("the rough surface agrees with its example") {
  const Figure& figure = made("rough-surface");
  const std::vector<Point>& curve = figure.panels[1].series[0].points;
  std::vector<double> x, drawn;
  for (const double part : {0.11, 0.41, 0.6, 0.83}) {
    const Point& p = curve[static_cast<std::size_t>(part * static_cast<double>(curve.size()))];
    x.push_back(p.x);
    drawn.push_back(p.y);
  }
  const auto rows =
      lines(out_of(run_example("rough_surface.toml", {"--method", "variational", "--cells", "65536", "--format", "csv",
                                                      fmt::format("--at={:.17g}", fmt::join(x, ","))})));
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double found = -std::stod(rows[i + 1].substr(rows[i + 1].find(',') + 1));
    CHECK(found == doctest::Approx(drawn[i]).epsilon(1e-9).scale(1e-3));
  }
  // Bars for 36 zones, and the surface below the trace.
  CHECK(figure.panels[0].series[2].points.size() == 2 * 36);
  const std::vector<Series>& heights = figure.panels[0].series;
  for (std::size_t i = 0; i < heights[0].points.size(); ++i) {
    CHECK(heights[1].points[i].y <= heights[0].points[i].y + 1e-12);
  }
}

TEST_CASE("the largest stress is at the place that solve finds, and contours have their values as labels") {
  const Figure& parabola = made("stress-parabola");
  const std::string text =
      output(GivenProblem{"0.3", "0.2", "", "x^2/2", "0.02"}.toml(), {"--max-stress", "--format", "json"});
  const std::string told = text.substr(text.find("\"largest_stress\""));
  const auto value_of = [](const std::string& in, const char* key) {
    return value_after(in.substr(in.find(std::string("\"") + key + "\":")), "\"value\": ");
  };
  const auto number = [&](const char* key) { return value_of(told, key); };
  const double a = value_of(text, "contact_width") / 2;
  const Point& mark = parabola.panels.front().series.back().points.front();
  CHECK(mark.x * a == doctest::Approx(number("x")).epsilon(1e-6).scale(0));
  CHECK(mark.y * a == doctest::Approx(number("z")).epsilon(1e-6).scale(0));
  CHECK(mark.x * a != doctest::Approx(-number("x")).epsilon(1e-6).scale(0));
  CHECK(has_note(parabola.panels.front(), "largest: " + decimal(number("von_mises") * a / 0.02, 3)));
  const HeatMap& map = *parabola.panels.front().map;
  CHECK(*std::ranges::max_element(map.values) <= number("von_mises") * a / 0.02);
  CHECK(*std::ranges::max_element(map.values) > 0.999 * number("von_mises") * a / 0.02);

  const auto solution = solved(stress_parabola_problem());
  const numeric::InteriorStress<double> interior(*solution);
  CHECK(check_labels(parabola, [&](double x, double z) {
          return interior.at(Rational(x * a), Rational(std::max(z, 1e-6) * a)).von_mises()->value * a / 0.02;
        }) == map.contours.size());
  const auto punch = solved(stress_map_problem());
  const numeric::InteriorStress<double> below(*punch);
  // The contours for 0.8, around the edges, are too short for labels.
  CHECK(check_labels(made("stress-map"), [&](double x, double z) {
          return below.at(Rational(x), Rational(std::max(z, 1e-6))).von_mises()->value;
        }) >= 6);
}

TEST_CASE("friction by direction agrees with solve, and its marks are those of two equal coatings") {
  const Panel& panel = made("friction-direction").panels.front();
  for (const std::size_t k : {0U, 1U}) {
    const Point& p = panel.series[2 * k].points[30];
    const GivenProblem given{"0.2", "0.1, 0.5", fmt::format("\"{:.17g}\"", p.x), "0", "1", k == 0 ? "+x" : "-x"};
    CHECK(value_after(solve_answer(given), "effective friction") == doctest::Approx(p.y).epsilon(1e-9));
    CHECK(has_note(panel, k == 0 ? "0.283" : "0.316"));
    CHECK(panel.series[2 * k + 1].points.front().y == doctest::Approx(k == 0 ? 0.2828077353 : 0.3159).epsilon(1e-3));
  }
  CHECK_FALSE(has_note(panel, "0.300"));
}

TEST_CASE("the exponents beside the pressures agree with the formulas") {
  const auto text = [](const std::string& symbol, double value) { return symbol + " = " + decimal(value, 4); };
  const Panel& uniform = made("flat-punch").panels.front();
  for (const double f : {0.0, 0.3, 1.0}) {
    CHECK(has_note(uniform, text("−½ − α", -0.5 - angle_of_friction(0.375 * f))));
    CHECK(has_note(uniform, text("−½ + α", -0.5 + angle_of_friction(0.375 * f))));
  }
  CHECK_FALSE(has_note(uniform, text("−½ + α", -0.5 - angle_of_friction(0.375))));
  const double left = angle_of_friction(0.0375), right = angle_of_friction(0.375);
  for (const int sign : {1, -1}) {
    const Panel& coated = made(sign == 1 ? "friction-jump-rising" : "friction-jump-falling").panels.front();
    CHECK(has_note(coated, text("β", sign * (left - right))));
    CHECK(has_note(coated, text("−½ − α_{−}", -0.5 - sign * left)));
    CHECK(has_note(coated, text("−½ + α_{+}", -0.5 + sign * right)));
  }
  const Panel& parabola = made("parabola").panels[1];
  CHECK(has_note(parabola, text("½ − α", 0.5 - angle_of_friction(0.5))));
  CHECK(has_note(parabola, text("½ + α", 0.5 + angle_of_friction(0.5))));
}
