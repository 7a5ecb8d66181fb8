#include "app/figures/figures.hpp"

#include "app/gnuplot/gnuplot.hpp"
#include "app/terminal/failure.hpp"
#include "app/terminal/progress.hpp"
#include "proofs_checks/kit/run.hpp"

namespace steadyslide::app {
namespace {

std::vector<FigureMaker> selected(const std::vector<std::string>& patterns) {
  using proofs_checks::select;
  for (const std::string& pattern : patterns) {
    if (!select(figures(), {pattern}, &FigureMaker::name).empty()) continue;
    throw bad_command_line("--figure: no such figure", "figures --help names them", pattern);
  }
  return select(figures(), patterns, &FigureMaker::name);
}

}  // namespace

DrawnFigure draw(const Figure& figure) {
  return {figure.name, figure.title, figure.caption, figure.command(), drawn(figure)};
}

std::vector<Figure> make_figures(const std::vector<std::string>& patterns) {
  const std::vector<FigureMaker> wanted = selected(patterns);
  // Before the work: without gnuplot it would be for nothing.
  run_gnuplot("");
  Progress progress(wanted.size());
  std::vector<Figure> result;
  for (const FigureMaker& maker : wanted) {
    result.push_back(maker.make());
    progress.next();
  }
  return result;
}

std::vector<DrawnFigure> draw_figures(const std::vector<std::string>& patterns) {
  std::vector<DrawnFigure> result;
  for (const Figure& figure : make_figures(patterns)) result.push_back(draw(figure));
  return result;
}

}  // namespace steadyslide::app
