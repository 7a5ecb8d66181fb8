#include "app/terminal/interrupt.hpp"

#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <climits>
#include <csignal>
#include <iterator>
#include <thread>

#include "app/terminal/failure.hpp"

namespace steadyslide::app {
namespace {

// A signal handler can use only static storage. It is written while the signals are held.
constexpr std::size_t most_files = 4;
char unfinished_files[most_files][PATH_MAX] = {};
volatile std::sig_atomic_t line_to_erase = 0;
std::atomic_flag terminal;

sigset_t both_signals() {
  sigset_t set;
  sigemptyset(&set);
  sigaddset(&set, SIGINT);
  sigaddset(&set, SIGTERM);
  return set;
}

extern "C" void end_interrupted(int) {
  for (const auto& file : unfinished_files) {
    if (file[0] != '\0') ::unlink(file);
  }
  // Another thread may be writing the line. What it writes next waits for the end.
  while (terminal.test_and_set()) {
  }
  if (line_to_erase != 0 && ::write(STDERR_FILENO, "\r\x1b[K", 4) < 0) {
    // The error cannot be reported: the program ends here.
  }
  ::_exit(static_cast<int>(ExitCode::interrupted));
}

}  // namespace

void handle_signals() {
  struct sigaction action {};
  action.sa_handler = end_interrupted;
  action.sa_mask = both_signals();
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
  std::signal(SIGPIPE, SIG_IGN);
}

SignalsHeld::SignalsHeld() {
  const sigset_t set = both_signals();
  sigprocmask(SIG_BLOCK, &set, &before_);
}

SignalsHeld::~SignalsHeld() { sigprocmask(SIG_SETMASK, &before_, nullptr); }

TerminalHeld::TerminalHeld() {
  while (terminal.test_and_set()) std::this_thread::yield();
}

TerminalHeld::~TerminalHeld() { terminal.clear(); }

void remove_when_interrupted(const std::string& file) {
  const auto slot = std::ranges::find_if(unfinished_files, [](const auto& name) { return name[0] == '\0'; });
  if (slot == std::end(unfinished_files) || file.size() >= PATH_MAX) return;
  file.copy(*slot, file.size());
  (*slot)[file.size()] = '\0';
}

void keep_when_interrupted(const std::string& file) {
  for (auto& name : unfinished_files) {
    if (file == name) name[0] = '\0';
  }
}

void erase_line_when_interrupted(bool erase) { line_to_erase = erase ? 1 : 0; }

}  // namespace steadyslide::app
