#include "app/process.hpp"

#include <fcntl.h>
#include <sys/wait.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <thread>

#include "app/terminal/memory_file.hpp"

namespace steadyslide::testing {
namespace {

using app::MemoryFile;
namespace fs = std::filesystem;

int open_stdout(const MemoryFile& captured, Stdout where) {
  if (where == Stdout::full_device) return ::open("/dev/full", O_WRONLY | O_CLOEXEC);
  if (where == Stdout::captured) return captured.descriptor();
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) throw std::runtime_error("no pipe");
  ::close(ends[0]);
  return ends[1];
}

pid_t start(const std::vector<std::string>& command, const fs::path& folder, int in, int out, int err) {
  std::vector<char*> argv;
  argv.reserve(command.size() + 1);
  for (const std::string& argument : command) argv.push_back(const_cast<char*>(argument.c_str()));
  argv.push_back(nullptr);
  const pid_t child = ::fork();
  if (child != 0) return child;
  if (::chdir(folder.c_str()) != 0) ::_exit(126);
  ::dup2(in, STDIN_FILENO);
  ::dup2(out, STDOUT_FILENO);
  ::dup2(err, STDERR_FILENO);
  ::execvp(argv[0], argv.data());
  ::_exit(127);
}

/// Waits for the child. Returns its exit code, or 128 + the number of the signal that ended it.
int wait_for(pid_t child) {
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

/// Calls `meanwhile` with the process as soon as it runs.
template <class Act>
Finished run(const std::vector<std::string>& command, const fs::path& folder, const std::string& input, Stdout where,
             const Act& meanwhile) {
  const MemoryFile in(input);
  const MemoryFile out;
  const MemoryFile err;
  const int target = open_stdout(out, where);
  const pid_t child = start(command, folder, in.descriptor(), target, err.descriptor());
  if (target != out.descriptor()) ::close(target);
  meanwhile(child);
  const int code = wait_for(child);
  return {code, out.text(), err.text()};
}

std::vector<std::string> program(const std::vector<std::string>& arguments) {
  // The environment may name another executable to test: a mutant.
  const char* const other = std::getenv("STEADYSLIDE_EXECUTABLE");
  std::vector<std::string> command{other != nullptr ? other : STEADYSLIDE_EXECUTABLE};
  command.insert(command.end(), arguments.begin(), arguments.end());
  return command;
}

/// `watch` gets the child and all text that was sent to the terminal so far.
template <class Watch>
Finished run_watched(const std::vector<std::string>& arguments, const fs::path& folder, const std::string& input,
                     Watch watch) {
  const MemoryFile in(input);
  const MemoryFile out;
  const int terminal = ::posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC);
  if (terminal < 0 || ::grantpt(terminal) != 0 || ::unlockpt(terminal) != 0) throw std::runtime_error("no terminal");
  const int end = ::open(::ptsname(terminal), O_RDWR | O_NOCTTY | O_CLOEXEC);
  if (end < 0) throw std::runtime_error("no terminal");
  const pid_t child = start(program(arguments), folder, in.descriptor(), out.descriptor(), end);
  ::close(end);
  std::string shown;
  std::array<char, 4096> block;
  // read() fails when the child has closed its end.
  for (ssize_t n = 0; (n = ::read(terminal, block.data(), block.size())) > 0;) {
    shown.append(block.data(), static_cast<std::size_t>(n));
    watch(child, shown);
  }
  const int code = wait_for(child);
  ::close(terminal);
  return {code, out.text(), shown};
}

}  // namespace

Finished run_program(const std::vector<std::string>& arguments, const fs::path& folder, const std::string& input,
                     Stdout where) {
  return run(program(arguments), folder, input, where, [](pid_t) {});
}

Finished run_program_by(std::vector<std::string> command, const std::vector<std::string>& arguments,
                        const fs::path& folder) {
  const std::vector<std::string> whole = program(arguments);
  command.insert(command.end(), whole.begin(), whole.end());
  return run_other(command, folder);
}

Finished run_on_terminal(const std::vector<std::string>& arguments, const fs::path& folder, const std::string& input) {
  return run_watched(arguments, folder, input, [](pid_t, const std::string&) {});
}

Finished interrupt_on_terminal(const std::vector<std::string>& arguments, const fs::path& folder,
                               const std::string& sign, int signal) {
  bool sent = false;
  return run_watched(arguments, folder, "", [&](pid_t child, const std::string& shown) {
    if (sent || shown.find(sign) == std::string::npos) return;
    ::kill(child, signal);
    sent = true;
  });
}

Finished run_other(const std::vector<std::string>& command, const fs::path& folder) {
  return run(command, folder, "", Stdout::captured, [](pid_t) {});
}

TemporaryFolder::TemporaryFolder(std::initializer_list<std::pair<const char*, std::string>> files) {
  std::string name = (fs::temp_directory_path() / "steadyslide-test-XXXXXX").string();
  if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
  path_ = name;
  for (const auto& [file, text] : files) write(file, text);
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

void TemporaryFolder::write(const std::string& name, const std::string& text) const {
  std::ofstream(path_ / name, std::ios::binary) << text;
}

std::string TemporaryFolder::read(const std::string& name) const {
  std::ifstream file(path_ / name, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::vector<std::string> TemporaryFolder::names(const std::string& folder) const {
  std::vector<std::string> result;
  for (const fs::directory_entry& entry : fs::directory_iterator(path_ / folder))
    result.push_back(entry.path().filename());
  std::sort(result.begin(), result.end());
  return result;
}

Finished run_and_interrupt(const std::vector<std::string>& arguments, const TemporaryFolder& folder, int signal,
                           std::chrono::milliseconds later) {
  const std::size_t before = folder.names().size();
  return run(program(arguments), folder.path(), "", Stdout::captured, [&](pid_t child) {
    const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(60);
    while (folder.names().size() == before && std::chrono::steady_clock::now() < deadline) {
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    std::this_thread::sleep_for(later);
    ::kill(child, signal);
  });
}

}  // namespace steadyslide::testing
