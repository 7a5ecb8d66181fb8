#pragma once
// Runs the built executable as a user does.

#include <chrono>
#include <filesystem>
#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

namespace steadyslide::testing {

struct Finished {
  int code = -1;  ///< exit code; 128 + the signal's number if a signal ended the process
  std::string out;
  std::string err;
};

/// The destination of the program's standard output.
enum class Stdout { captured, closed_pipe, full_device };

/// Runs `steadyslide ARGUMENTS` in `folder` with `input` on its standard input, and waits for it.
Finished run_program(const std::vector<std::string>& arguments, const std::filesystem::path& folder,
                     const std::string& input = "", Stdout where = Stdout::captured);

/// The same as an argument of another command: {"timeout", "20"} ends a program that takes longer, with the exit code
/// 124.
Finished run_program_by(std::vector<std::string> command, const std::vector<std::string>& arguments,
                        const std::filesystem::path& folder);

/// The same with a terminal as its standard error: `err` is the text that the terminal received.
Finished run_on_terminal(const std::vector<std::string>& arguments, const std::filesystem::path& folder,
                         const std::string& input);

/// Runs another program found by PATH, in the same way.
Finished run_other(const std::vector<std::string>& command, const std::filesystem::path& folder);

/// A folder of its own with these files (names and texts). It is removed at the end.
class TemporaryFolder {
 public:
  TemporaryFolder(std::initializer_list<std::pair<const char*, std::string>> files = {});
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  void write(const std::string& name, const std::string& text) const;
  std::string read(const std::string& name) const;
  /// Returns the names of the files in it, or in a folder of it, in order.
  std::vector<std::string> names(const std::string& folder = "") const;
  /// Runs the program in this folder.
  Finished run(const std::vector<std::string>& arguments, const std::string& input = "",
               Stdout where = Stdout::captured) const {
    return run_program(arguments, path_, input, where);
  }

 private:
  std::filesystem::path path_;
};

/// Starts the program. Sends it a signal some time after `folder` has a new file, and waits for its end.
Finished run_and_interrupt(const std::vector<std::string>& arguments, const TemporaryFolder& folder, int signal,
                           std::chrono::milliseconds later = std::chrono::milliseconds(0));

/// Starts the program with a terminal as its standard error. Sends it a signal as soon as the terminal receives `sign`,
/// and waits for its end.
Finished interrupt_on_terminal(const std::vector<std::string>& arguments, const std::filesystem::path& folder,
                               const std::string& sign, int signal);

}  // namespace steadyslide::testing
