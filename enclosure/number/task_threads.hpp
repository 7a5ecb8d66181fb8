#pragma once
// Tasks that know nothing of each other, side by side where a thread is free. What they give does not depend on that.

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

  /// make(first), ..., make(last - 1).
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
