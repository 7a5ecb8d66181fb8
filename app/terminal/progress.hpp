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

  /// One more of the total is done.
  void next();
  /// Of the next one, `part` of `whole` is done.
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
