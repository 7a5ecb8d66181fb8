#include "bindings/python/picture.hpp"

#include <algorithm>

#include "app/gnuplot/gnuplot.hpp"
#include "app/results/solution_figure.hpp"
#include "library/text/one_line.hpp"

namespace steadyslide {

std::string picture(
    library::Problem problem,
    const std::variant<const numeric::ContactSolution<double>*, const numeric::ContactSolution<numeric::Real50>*,
                       const numeric::ContactSolution<numeric::Real100>*>& solution,
    int digits, const std::string& failed_condition, const std::string& kind) {
  const auto found = std::ranges::find(app::picture_names, kind);
  if (found == app::picture_names.end()) {
    throw InvalidData("path: unknown kind of picture; its name ends in .svg, .pdf or .png; " + library::excerpt(kind));
  }
  if (problem.file.empty()) problem.file = "problem";
  app::SolutionWanted wanted;
  wanted.digits = digits;
  wanted.curve = true;
  app::SolutionText text =
      std::visit([&](const auto* of) { return app::solution_text(problem, *of, wanted); }, solution);
  // On cells the solution judges its residuals itself.
  text.failed_condition = failed_condition;
  return app::rendered_picture(app::solution_figure(problem, text),
                               static_cast<app::Picture>(found - app::picture_names.begin()));
}

}  // namespace steadyslide
