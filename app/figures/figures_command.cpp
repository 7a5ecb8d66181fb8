// steadyslide figures

#include <filesystem>
#include <system_error>

#include "app/commands/command_line.hpp"
#include "app/embedded.hpp"
#include "app/figures/figures.hpp"

namespace steadyslide::app {
namespace {

ExitCode run_figures(const Given& given) {
  namespace fs = std::filesystem;
  const fs::path folder(given.folder());
  const auto fail = [&](const std::string& what) -> Failure {
    return {ExitCode::failed, folder.string() + ": " + what};
  };
  std::error_code error;
  if (fs::exists(folder, error) && !fs::is_directory(folder, error)) throw fail("is no folder");
  const std::vector<DrawnFigure> drawn = draw_figures(given.texts("--figure"));
  fs::create_directories(folder, error);
  if (error) throw fail("cannot be made: " + error.message());
  for (const DrawnFigure& figure : drawn) {
    Output output((folder / (figure.name + ".svg")).string());
    output.write(figure.svg);
    output.commit();
  }
  return ExitCode::done;
}

}  // namespace

Command figures_command() {
  std::string help = std::string(embedded::help_figures) + "Figures:\n";
  for (const FigureMaker& figure : figures()) help += "  " + figure.name + "\n";
  return {"figures",
          help,
          {{"--figure", "GLOB", "Only figures whose name matches, * and ? being wildcards; repeatable",
            Option::Kind::repeatable},
           folder_option()},
          run_figures};
}

}  // namespace steadyslide::app
