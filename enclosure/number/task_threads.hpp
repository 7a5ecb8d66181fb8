#pragma once
// Runs independent tasks in parallel if a thread is free. The results do not depend on this.

#include <flint/flint.h>

#include <atomic>
#include <cstddef>
#include <future>
#include <iterator>
#include <type_traits>
#include <utility>
#include <vector>

namespace steadyslide::enclosure {

class TaskThreads {
 public:
  /// `most` is the largest number of parallel tasks, including the caller's own.
  explicit TaskThreads(unsigned most) : free_(static_cast<int>(most) - 1) {}

  /// Returns both results. The first task runs on the caller's thread. An exception of a task is thrown when both have
  /// ended.
  template <class First, class Second>
  auto both(First first, Second second) {
    if (!take()) {
      auto one = first();
      return std::pair(std::move(one), second());
    }
    // The tasks have two threads. The one that ends first frees a thread for others. The caller continues when both
    // have ended.
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

  /// Returns make(first), ..., make(last - 1).
  template <class Make>
  std::vector<std::invoke_result_t<Make, std::size_t>> all(std::size_t first, std::size_t last, const Make& make) {
    std::vector<std::invoke_result_t<Make, std::size_t>> made;
    if (first == last) return made;
    if (first + 1 == last) {
      made.push_back(make(first));
      return made;
    }
    const std::size_t middle = first + (last - first) / 2;
    auto halves = both([&] { return all(first, middle, make); }, [&] { return all(middle, last, make); });
    made = std::move(halves.first);
    std::move(halves.second.begin(), halves.second.end(), std::back_inserter(made));
    return made;
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
