#include "app/figures/figures.hpp"

#include <boost/algorithm/string/replace.hpp>

#include "app/figures/figure_data.hpp"
#include "app/sweep/ordered_tasks.hpp"
#include "app/terminal/failure.hpp"
#include "app/terminal/progress.hpp"
#include "proofs_checks/kit/run.hpp"

// The figures of the paper come first.
#define STEADYSLIDE_FOR_EACH_FIGURE(figure)                                                                      \
  figure(sketch) figure(reactions) figure(flat_punch) figure(friction_jump_rising) figure(friction_jump_falling) \
      figure(parabola) figure(local_forms) figure(coating_layouts) figure(contact_load) figure(convergence)      \
          figure(effective_friction) figure(friction_direction) figure(jump_exponent) figure(rough_surface)      \
              figure(stress_map) figure(stress_parabola) figure(two_zones)

namespace steadyslide::app {

#define STEADYSLIDE_FIGURE(name) Figure make_##name();
STEADYSLIDE_FOR_EACH_FIGURE(STEADYSLIDE_FIGURE)
#undef STEADYSLIDE_FIGURE

const std::vector<FigureMaker>& figures() {
#define STEADYSLIDE_FIGURE(name) {boost::replace_all_copy(std::string(#name), "_", "-"), make_##name},
  static const std::vector<FigureMaker> all{STEADYSLIDE_FOR_EACH_FIGURE(STEADYSLIDE_FIGURE)};
#undef STEADYSLIDE_FIGURE
  return all;
}

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

DrawnFigure draw(const Figure& figure, Picture picture) {
  return {figure.name,        figure.title, figure.caption, figure.command(), rendered_picture(figure, picture),
          figure_data(figure)};
}

std::vector<DrawnFigure> draw_figures(const std::vector<std::string>& patterns, unsigned jobs, Picture picture) {
  const std::vector<FigureMaker> wanted = selected(patterns);
  // Fails early if gnuplot is missing.
  run_gnuplot("");
  Progress progress(wanted.size());
  std::vector<DrawnFigure> result(wanted.size());
  const auto make = [&](std::size_t k) {
    result[k] = draw(wanted[k].make(), picture);
    return std::string();
  };
  in_order({0, wanted.size()}, static_cast<int>(jobs), make, [&](std::size_t, const std::string&) { progress.next(); });
  return result;
}

}  // namespace steadyslide::app
