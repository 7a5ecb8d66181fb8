// steadyslide sweep

#include <unistd.h>

#include <filesystem>

#include "app/commands/command_line.hpp"
#include "app/sweep/sweep_options.hpp"

namespace steadyslide::app {
namespace {

/// Replaces this process by the other program, with the same options.
[[noreturn]] void run_beside(const Given& given) {
  std::error_code unknown;
  const std::filesystem::path self = std::filesystem::read_symlink("/proc/self/exe", unknown);
  const std::string program = (self.parent_path() / "steadyslide-sweep").string();
  std::vector<std::string> words{program, given.text("SWEEP"), "--format", "hdf5"};
  for (const char* option : {"--jobs", "--output"}) {
    if (given.has(option)) words.insert(words.end(), {option, given.text(option)});
  }
  if (given.has("--resume")) words.emplace_back("--resume");
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  ::execv(program.c_str(), argv.data());
  throw bad_command_line("--format: no HDF5 here", "steadyslide-sweep writes it, which is built with MPI and HDF5",
                         program);
}

ExitCode run(const Given& given) {
  const SweepOptions options = read_sweep_options(given);
  if (options.hdf5) run_beside(given);
  run_sweep(options.wanted);
  return ExitCode::done;
}

}  // namespace

Command sweep_command() { return sweep_command(run); }

}  // namespace steadyslide::app
