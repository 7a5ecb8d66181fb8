#include "app/figures/figures.hpp"

#include <boost/algorithm/string/replace.hpp>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>

#include "app/figures/figure_data.hpp"
#include "app/terminal/failure.hpp"
#include "app/terminal/progress.hpp"
#include "proofs_checks/kit/processes.hpp"

// The paper's first.
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

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(DrawnFigure, name, title, caption, command, picture, data)

namespace {

std::vector<FigureMaker> selected(const std::vector<std::string>& patterns) {
  using proofs_checks::select;
  for (const std::string& pattern : patterns) {
    if (!select(figures(), {pattern}, &FigureMaker::name).empty()) continue;
    throw bad_command_line("--figure: no such figure", "figures --help names them", pattern);
  }
  return select(figures(), patterns, &FigureMaker::name);
}

/// What a process has to say of a figure: how it is drawn, or why it is not.
struct Said {
  ExitCode code = ExitCode::done;  ///< of a Failure
  std::string complaint;
  DrawnFigure figure;
};

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Said, code, complaint, figure)

Said said_of(const FigureMaker& maker, Picture picture) {
  try {
    return {ExitCode::done, "", draw(maker.make(), picture)};
  } catch (const Failure& failure) {
    return {failure.code(), failure.what(), {}};
  } catch (const std::exception& error) {
    return {ExitCode::done, error.what(), {}};
  }
}

DrawnFigure drawn_as_said(const std::string& bytes) {
  Said said = nlohmann::json::from_cbor(bytes);
  if (said.code != ExitCode::done) throw Failure(said.code, said.complaint);
  if (!said.complaint.empty()) throw std::runtime_error(said.complaint);
  return std::move(said.figure);
}

}  // namespace

DrawnFigure draw(const Figure& figure, Picture picture) {
  return {figure.name, figure.title, figure.caption, figure.command(), drawn(figure, picture), figure_data(figure)};
}

std::vector<DrawnFigure> draw_figures(const std::vector<std::string>& patterns, unsigned processes, Picture picture) {
  const std::vector<FigureMaker> wanted = selected(patterns);
  // Before the work: without gnuplot it would be for nothing.
  run_gnuplot("");
  Progress progress(wanted.size());
  const auto ends = proofs_checks::do_in_processes(
      wanted.size(), processes,
      [&](std::size_t k) {
        std::string bytes;
        nlohmann::json::to_cbor(said_of(wanted[k], picture), bytes);
        return bytes;
      },
      [&](std::size_t k) {
        if (k >= processes) progress.next();  // another one is done
      });
  std::vector<DrawnFigure> result;
  for (std::size_t k = 0; k < wanted.size(); ++k) {
    if (!ends[k].bytes) throw std::runtime_error(wanted[k].name + ": its process ended " + ends[k].how);
    result.push_back(drawn_as_said(*ends[k].bytes));
  }
  return result;
}

}  // namespace steadyslide::app
