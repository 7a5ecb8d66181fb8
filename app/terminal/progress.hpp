#pragma once
// How far a long command is: a bar on stderr, on a terminal only, and gone at the end.

#include <chrono>
#include <cstddef>

namespace steadyslide::app {

class Progress {
 public:
  explicit Progress(std::size_t total);
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  ~Progress();

  /// So many of the total are done, and of the next one this part, in [0, 1].
  void show(std::size_t done, double part = 0);

 private:
  using Clock = std::chrono::steady_clock;

  std::size_t total_;
  bool on_terminal_;
  Clock::time_point start_ = Clock::now();
  Clock::time_point shown_{};
};

}  // namespace steadyslide::app
