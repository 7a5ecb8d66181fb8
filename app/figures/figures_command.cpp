// steadyslide figures

#include <fmt/ranges.h>

#include <filesystem>
#include <system_error>

#include "app/commands/command_line.hpp"
#include "app/embedded.hpp"
#include "app/figures/figures.hpp"
#include "proofs_checks/kit/processes.hpp"

namespace steadyslide::app {
namespace {

namespace fs = std::filesystem;

/// Checks the folder before the work.
void check_folder(const fs::path& folder) {
  std::error_code error;
  if (fs::exists(folder, error) && !fs::is_directory(folder, error))
    throw Failure(ExitCode::failed, folder.string() + ": is no folder");
}

Picture picture_of(const std::string& format) {
  const auto found = std::ranges::find(picture_names, format);
  if (found != picture_names.end()) return static_cast<Picture>(found - picture_names.begin());
  throw bad_command_line("--format: unknown format", fmt::format("it is one of {}", fmt::join(picture_names, ", ")),
                         format);
}

void write(const fs::path& folder, const std::string& name, const std::string& bytes) {
  make_folder(folder);
  write_whole((folder / name).string(), bytes);
}

ExitCode run_figures(const Given& given) {
  const fs::path folder(given.folder());
  const std::optional<std::string> data = given.name("--data", "folder");
  check_folder(folder);
  if (data) check_folder(*data);
  const std::string ending = given.has("--format") ? given.text("--format") : "svg";
  const Picture picture = picture_of(ending);
  const unsigned at_a_time = given.jobs(proofs_checks::available_processes());
  for (const DrawnFigure& figure : draw_figures(given.texts("--figure"), at_a_time, picture)) {
    write(folder, figure.name + "." + ending, figure.picture);
    if (data) write(*data, figure.name + ".csv", figure.data);
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
           {"--format", "FORMAT", "Of the pictures; svg without", Option::Kind::text,
            fmt::format("{}", fmt::join(picture_names, " "))},
           {"--data", "DIR", "Writes the numbers of every curve there, too, as DIR/NAME.csv"},
           jobs_option("Figures drawn"),
           folder_option()},
          run_figures};
}

}  // namespace steadyslide::app
