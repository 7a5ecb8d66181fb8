#include "app/figures/figures.hpp"

#include <algorithm>

#include "app/figures/gnuplot.hpp"
#include "app/figures/gnuplot_script.hpp"
#include "app/figures/svg.hpp"
#include "app/terminal/failure.hpp"
#include "app/terminal/progress.hpp"
#include "proofs_checks/kit/run.hpp"

namespace steadyslide::app {
namespace {

std::vector<FigureMaker> selected(const std::vector<std::string>& patterns) {
  using proofs_checks::matches_glob;
  for (const std::string& pattern : patterns) {
    const auto named = [&](const FigureMaker& figure) { return matches_glob(figure.name, pattern); };
    if (std::ranges::any_of(figures(), named)) continue;
    throw bad_command_line("--figure: no such figure", "figures --help names them", pattern);
  }
  std::vector<FigureMaker> result;
  for (const FigureMaker& figure : figures()) {
    const auto names_it = [&](const std::string& pattern) { return matches_glob(figure.name, pattern); };
    if (patterns.empty() || std::ranges::any_of(patterns, names_it)) result.push_back(figure);
  }
  return result;
}

}  // namespace

DrawnFigure draw(const Figure& figure) {
  return {figure.name, figure.title, figure.caption, command_of(figure),
          finished_svg(run_gnuplot(gnuplot_script(figure)), figure)};
}

std::vector<DrawnFigure> draw_figures(const std::vector<std::string>& patterns) {
  const std::vector<FigureMaker> wanted = selected(patterns);
  // Before the work: without gnuplot it would be for nothing.
  run_gnuplot("");
  Progress progress(wanted.size());
  std::vector<DrawnFigure> result;
  for (const FigureMaker& maker : wanted) {
    progress.show(result.size());
    result.push_back(draw(maker.make()));
  }
  return result;
}

}  // namespace steadyslide::app
