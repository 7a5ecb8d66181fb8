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
    // They have two threads. Who ends first leaves one to others, and the caller goes on when both have.
    std::atomic<bool> has_one_ended = false;
    const auto run = [&](auto& task) {
      const AtEnd leave([&] {
        if (!has_one_ended.exchange(true)) ++free_;
      });
      return task();
    };
    auto other = std::async(std::launch::async, [&] {
      const AtEnd clean_up(&flint_cleanup);
      return run(second);
    });
    auto one = run(first);
    return std::pair(std::move(one), other.get());
  }

 private:
  template <class Call>
  struct AtEnd {
    explicit AtEnd(Call to_call) : call(std::move(to_call)) {}
    AtEnd(const AtEnd&) = delete;
    AtEnd& operator=(const AtEnd&) = delete;
    ~AtEnd() { call(); }
    Call call;
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
