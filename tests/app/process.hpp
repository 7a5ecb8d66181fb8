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
  int code = -1;  ///< 128 + the signal's number for a process that a signal ended
  std::string out;
  std::string err;
};

/// Where the program's standard output goes.
enum class Stdout { captured, closed_pipe, full_device };

/// Runs `steadyslide ARGUMENTS` in `folder` with `input` on its standard input, and waits for it.
Finished run_program(const std::vector<std::string>& arguments, const std::filesystem::path& folder,
                     const std::string& input = "", Stdout where = Stdout::captured);

/// The same as an argument of another command: {"timeout", "20"} ends a program that does not, with the exit code 124.
Finished run_program_by(std::vector<std::string> command, const std::vector<std::string>& arguments,
                        const std::filesystem::path& folder);

/// The same with a terminal as its standard error: `err` is what the terminal was sent.
Finished run_on_terminal(const std::vector<std::string>& arguments, const std::filesystem::path& folder,
                         const std::string& input);

/// Runs another program found by PATH, the same way.
Finished run_other(const std::vector<std::string>& command, const std::filesystem::path& folder);

/// A folder of its own with these files, names and texts, gone at the end.
class TemporaryFolder {
 public:
  TemporaryFolder(std::initializer_list<std::pair<const char*, std::string>> files = {});
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  void write(const std::string& name, const std::string& text) const;
  std::string read(const std::string& name) const;
  /// The names in it, or in a folder of it, in order.
  std::vector<std::string> names(const std::string& folder = "") const;
  /// Runs the program in it.
  Finished run(const std::vector<std::string>& arguments, const std::string& input = "",
               Stdout where = Stdout::captured) const {
    return run_program(arguments, path_, input, where);
  }

 private:
  std::filesystem::path path_;
};

/// Starts the program, sends it a signal so long after `folder` holds a new file, and waits.
Finished run_and_interrupt(const std::vector<std::string>& arguments, const TemporaryFolder& folder, int signal,
                           std::chrono::milliseconds later = std::chrono::milliseconds(0));

/// Starts the program with a terminal as its standard error, sends it a signal as soon as the terminal has been sent
/// `sign`, and waits.
Finished interrupt_on_terminal(const std::vector<std::string>& arguments, const std::filesystem::path& folder,
                               const std::string& sign, int signal);

}  // namespace steadyslide::testing
