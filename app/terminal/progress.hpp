#pragma once
// The progress of a long command: a bar on stderr, only on a terminal, removed at the end.

#include <chrono>
#include <cstddef>

namespace steadyslide::app {

class Progress {
 public:
  explicit Progress(std::size_t total);
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  ~Progress();

  /// Counts one more task as done.
  void next();
  /// Shows the progress of the next task: `part` of `whole`.
  void show(std::size_t part, std::size_t whole);

 private:
  using Clock = std::chrono::steady_clock;

  std::size_t total_;
  std::size_t done_ = 0;
  bool on_terminal_;
  Clock::time_point start_ = Clock::now();
  Clock::time_point shown_{};
};

}  // namespace steadyslide::app
