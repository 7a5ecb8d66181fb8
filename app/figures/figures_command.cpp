// steadyslide figures

#include <fmt/ranges.h>

#include <filesystem>
#include <system_error>

#include "app/commands/jobs.hpp"
#include "app/embedded.hpp"
#include "app/figures/figures.hpp"
#include "proofs_checks/kit/processes.hpp"

namespace steadyslide::app {
namespace {

namespace fs = std::filesystem;

Failure cannot(const fs::path& folder, const std::string& what) {
  return {ExitCode::failed, folder.string() + ": " + what};
}

/// Before the work.
void check_folder(const fs::path& folder) {
  std::error_code error;
  if (fs::exists(folder, error) && !fs::is_directory(folder, error)) throw cannot(folder, "is no folder");
}

Picture picture_of(const std::string& format) {
  const auto found = std::ranges::find(picture_names, format);
  if (found != picture_names.end()) return static_cast<Picture>(found - picture_names.begin());
  throw bad_command_line("--format: unknown format", fmt::format("it is one of {}", fmt::join(picture_names, ", ")),
                         format);
}

struct File {
  fs::path folder;
  std::string name;
  std::string bytes;
};

void write(const File& file) {
  std::error_code error;
  fs::create_directories(file.folder, error);
  if (error) throw cannot(file.folder, "cannot be made: " + error.message());
  Output output((file.folder / file.name).string());
  output.write(file.bytes);
  output.commit();
}

ExitCode run_figures(const Given& given) {
  const fs::path folder(given.folder());
  const std::optional<std::string> data = given.name("--data", "folder");
  check_folder(folder);
  if (data) check_folder(*data);
  const std::string ending = given.has("--format") ? given.text("--format") : "svg";
  const Picture picture = picture_of(ending);
  const unsigned processes = jobs(given, proofs_checks::available_processes());
  std::vector<File> files;
  for (const DrawnFigure& figure : draw_figures(given.texts("--figure"), processes, picture)) {
    files.push_back({folder, figure.name + "." + ending, figure.picture});
    if (data) files.push_back({*data, figure.name + ".csv", figure.data});
  }
  for (const File& file : files) write(file);
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
