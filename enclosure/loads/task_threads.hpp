#pragma once
// Tasks that know nothing of each other, side by side where a thread is free. What they give does not depend on that.

#include <flint/flint.h>

#include <atomic>
#include <future>
#include <utility>

namespace steadyslide::enclosure {

class TaskThreads {
 public:
  /// So many tasks at a time, the caller's own among them.
  explicit TaskThreads(unsigned most) : free_(static_cast<int>(most) - 1) {}

  /// What both give; the first one runs on the caller's thread. Throws what they throw, when both have ended.
  template <class First, class Second>
  auto both(First first, Second second) {
    if (!take()) {
      auto one = first();
      return std::pair(std::move(one), second());
    }
    auto other = std::async(std::launch::async, [&] {
      const Leaving leaving{free_};
      return second();
    });
    auto one = first();
    ++free_;  // who waits needs none
    auto two = other.get();
    --free_;
    return std::pair(std::move(one), std::move(two));
  }

 private:
  /// The end of a thread: the next task may have one, and Flint's tables of this one go.
  struct Leaving {
    std::atomic<int>& free;
    ~Leaving() {
      ++free;
      flint_cleanup();
    }
  };

  bool take() {
    int free = free_;
    while (free > 0) {
      if (free_.compare_exchange_weak(free, free - 1)) return true;
    }
    return false;
  }

  std::atomic<int> free_;
};

}  // namespace steadyslide::enclosure
