#pragma once
// Answers of `solve` for the problem of a figure.

#include <fmt/ranges.h>

#include "app/command_line.hpp"
#include "app/figures/solved.hpp"
#include "app/made_figures.hpp"

namespace steadyslide::testing {

struct GivenProblem {
  std::string poisson;
  std::string friction;
  std::string jumps;
  std::string profile = "0", load = "1", sliding = "+x", support = "-1, 1";

  std::string toml() const {
    return fmt::format(
        "load = \"{}\"\nsliding = \"{}\"\n[half_space]\npoisson = \"{}\"\n[friction]\nvalues = [{}]\njumps = [{}]\n"
        "[indenter]\nprofile = \"{}\"\nsupport = [{}]\n",
        load, sliding, poisson, friction, jumps, profile, support);
  }
};

inline std::string solve_answer(const GivenProblem& given, const Arguments& arguments = {}) {
  return output(given.toml(), arguments);
}

/// Returns -t at these places, from left to right.
inline std::vector<double> pressures(const GivenProblem& given, const std::vector<double>& places) {
  const auto rows =
      lines(solve_answer(given, {"--format", "csv", fmt::format("--at={:.17g}", fmt::join(places, ","))}));
  REQUIRE(rows[0].starts_with("x,traction,"));
  REQUIRE(rows.size() == places.size() + 1);
  std::vector<double> found;
  for (std::size_t k = 1; k < rows.size(); ++k) found.push_back(-std::stod(rows[k].substr(rows[k].find(',') + 1)));
  return found;
}

/// Returns the number that follows a word in the text.
inline double value_after(const std::string& text, const std::string& word) {
  const std::size_t at = text.find(word);
  REQUIRE(at != std::string::npos);
  return std::stod(text.substr(at + word.size()));
}

/// Checks that some points of a curve agree with `solve`, in units `length` and `stress`, and that changed ones do not.
inline void check_curve(const app::Series& series, const GivenProblem& given, double length = 1, double stress = 1) {
  REQUIRE(series.points.size() > 50);
  std::vector<double> places, drawn;
  for (const double part : {0.15, 0.3, 0.55, 0.8}) {
    const app::Point& p = series.points[static_cast<std::size_t>(part * static_cast<double>(series.points.size()))];
    places.push_back(p.x * length);
    drawn.push_back(p.y * stress);
  }
  const std::vector<double> found = pressures(given, places);
  for (std::size_t k = 0; k < found.size(); ++k) {
    CAPTURE(places[k]);
    CHECK(found[k] == doctest::Approx(drawn[k]).epsilon(1e-9).scale(0));
    CHECK(found[k] != doctest::Approx(drawn[k] * (1 + 1e-8)).epsilon(1e-9).scale(0));
  }
}

inline double angle_of_friction(double s) { return std::atan(s) / std::numbers::pi; }

inline double log_slope(const app::Point& a, const app::Point& b) { return std::log(b.y / a.y) / std::log(b.x / a.x); }

}  // namespace steadyslide::testing
