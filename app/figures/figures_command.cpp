#include "app/figures/figures_command.hpp"

#include <filesystem>
#include <system_error>

#include "app/figures/figures.hpp"
#include "app/output.hpp"

namespace steadyslide::app {

ExitCode run(const FiguresOptions& options) {
  const std::vector<DrawnFigure> drawn = draw_figures(options.figures);
  const std::filesystem::path folder(options.folder);
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw Failure(ExitCode::failed, folder.string() + ": no folder can be made: " + error.message());
  for (const DrawnFigure& figure : drawn) {
    Output output((folder / (figure.name + ".svg")).string());
    output.write(figure.svg);
    output.commit();
  }
  return ExitCode::done;
}

}  // namespace steadyslide::app
