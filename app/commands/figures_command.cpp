#include "app/commands/figures_command.hpp"

#include <filesystem>
#include <system_error>

#include "app/figures/figures.hpp"
#include "app/terminal/output.hpp"

namespace steadyslide::app {

ExitCode run(const FiguresOptions& options) {
  namespace fs = std::filesystem;
  const fs::path folder(options.folder);
  const auto fail = [&](const std::string& what) -> Failure {
    return {ExitCode::failed, folder.string() + ": " + what};
  };
  std::error_code error;
  if (fs::exists(folder, error) && !fs::is_directory(folder, error)) throw fail("is no folder");
  const std::vector<DrawnFigure> drawn = draw_figures(options.figures);
  fs::create_directories(folder, error);
  if (error) throw fail("cannot be made: " + error.message());
  for (const DrawnFigure& figure : drawn) {
    Output output((folder / (figure.name + ".svg")).string());
    output.write(figure.svg);
    output.commit();
  }
  return ExitCode::done;
}

}  // namespace steadyslide::app
