#include "app/terminal/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "app/terminal/interrupt.hpp"

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
  show(0, 1);
}

Progress::~Progress() {
  if (!on_terminal_) return;
  std::fputs("\r\x1b[K", stderr);
  erase_line_when_interrupted(false);
}

void Progress::next() {
  ++done_;
  show(0, 1);
}

void Progress::show(std::size_t part, std::size_t whole) {
  if (!on_terminal_) return;
  const Clock::time_point now = Clock::now();
  if (now - shown_ < pause) return;
  shown_ = now;
  const double done = static_cast<double>(done_) + static_cast<double>(part) / static_cast<double>(whole);
  const double ratio = std::clamp(done / static_cast<double>(total_), 0.0, 1.0);
  const auto full = static_cast<std::size_t>(ratio * width);
  std::string line = fmt::format("\r\x1b[K[{}{}]", std::string(full, '#'), std::string(width - full, '.'));
  if (total_ > 1) line += fmt::format(" {}/{}", done_, total_);
  line += fmt::format(" {} %", static_cast<int>(ratio * 100));
  if (ratio > 0) {
    const double seconds = std::chrono::duration<double>(now - start_).count();
    const double left = seconds / ratio * (1 - ratio);
    line += " ETA " + clock_text(std::lround(left));
  }
  const TerminalHeld held;
  std::fputs(line.c_str(), stderr);
}

}  // namespace steadyslide::app
