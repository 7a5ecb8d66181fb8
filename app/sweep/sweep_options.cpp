#include "app/sweep/sweep_options.hpp"

#include <algorithm>
#include <thread>

#include "app/embedded.hpp"

namespace steadyslide::app {
namespace {

constexpr int most_problems = 1024;

bool names_hdf5(const std::optional<std::string>& file) {
  return file && (file->ends_with(".h5") || file->ends_with(".hdf5"));
}

}  // namespace

SweepOptions read_sweep_options(const Given& given) {
  SweepOptions options;
  options.wanted.file = given.text("SWEEP");
  options.wanted.output = given.name("--output", "file");
  options.wanted.resume = given.has("--resume");
  const int cores = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  options.wanted.jobs = given.count("--jobs", 1, most_problems).value_or(cores);
  const std::string format = given.has("--format")               ? given.text("--format")
                             : names_hdf5(options.wanted.output) ? "hdf5"
                                                                 : "csv";
  options.hdf5 = format == "hdf5";
  if (!options.hdf5 && format != "csv") {
    throw bad_command_line("--format: unknown format", "it is one of csv, hdf5", format);
  }
  return options;
}

Command sweep_command(ExitCode (*run)(const Given& given)) {
  return {"sweep",
          std::string(embedded::help_sweep),
          {{"SWEEP", "", "Sweep file, or -", Option::Kind::required},
           {"-j,--jobs", "N", "So many problems at a time, 1 to 1024; default: one for each core"},
           {"--resume", "", "Go on where an interrupted sweep has stopped: with FILE.part", Option::Kind::flag},
           {"--format", "FORMAT", "csv or hdf5; default: by the name of FILE", Option::Kind::text, "csv hdf5"},
           {"-o,--output", "FILE", "Write to FILE, whole or not at all; default: standard output"}},
          run};
}

}  // namespace steadyslide::app
