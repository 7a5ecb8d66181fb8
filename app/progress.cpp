#include "app/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <string>

#include "app/interrupt.hpp"

namespace steadyslide::app {
namespace {

constexpr std::size_t width = 24;
constexpr std::chrono::milliseconds pause{100};

std::string clock_text(long seconds) {
  if (seconds < 3600) return fmt::format("{}:{:02}", seconds / 60, seconds % 60);
  return fmt::format("{}:{:02}:{:02}", seconds / 3600, seconds / 60 % 60, seconds % 60);
}

}  // namespace

Progress::Progress(std::size_t total) : total_(total), on_terminal_(::isatty(STDERR_FILENO) == 1) {
  if (!on_terminal_) return;
  erase_line_when_interrupted(true);
  show(0);
}

Progress::~Progress() {
  if (!on_terminal_) return;
  std::fputs("\r\x1b[K", stderr);
  erase_line_when_interrupted(false);
}

void Progress::show(std::size_t done) {
  if (!on_terminal_) return;
  const Clock::time_point now = Clock::now();
  if (now - shown_ < pause) return;
  shown_ = now;
  const std::size_t full = done * width / total_;
  std::string line = fmt::format("\r\x1b[K[{}{}] {}/{} {} %", std::string(full, '#'), std::string(width - full, '.'),
                                 done, total_, done * 100 / total_);
  if (done > 0) {
    const double seconds = std::chrono::duration<double>(now - start_).count();
    const double left = seconds / static_cast<double>(done) * static_cast<double>(total_ - done);
    line += " ETA " + clock_text(static_cast<long>(left + 0.5));
  }
  std::fputs(line.c_str(), stderr);
}

}  // namespace steadyslide::app
