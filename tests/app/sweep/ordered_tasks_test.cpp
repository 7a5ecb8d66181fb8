// Tasks in threads: each is made once and taken in order, whatever order they end in.

#include "app/sweep/ordered_tasks.hpp"

#include <atomic>
#include <chrono>
#include <stdexcept>
#include <thread>

#include "support/test.hpp"

using namespace steadyslide::app;

TEST_CASE("texts are taken in order, one at a time, though later tasks end earlier") {
  for (const int jobs : {1, 3}) {
    std::atomic<int> made = 0;
    std::atomic<int> taking = 0;
    std::vector<std::size_t> taken;
    in_order(
        {5, 30, 3}, jobs,
        [&](std::size_t n) {
          ++made;
          std::this_thread::sleep_for(std::chrono::milliseconds(n == 5 ? 20 : 0));
          return std::to_string(n);
        },
        [&](std::size_t n, const std::string& text) {
          CHECK(++taking == 1);
          CHECK(text == std::to_string(n));
          taken.push_back(n);
          --taking;
        });
    CHECK(made == 9);
    CHECK(taken == std::vector<std::size_t>{5, 8, 11, 14, 17, 20, 23, 26, 29});
  }
  in_order(
      {3, 3}, 2, [](std::size_t) { return ""; }, [](std::size_t, const std::string&) { FAIL("none to take"); });
}

TEST_CASE("an exception of a task, or of the function that takes its text, ends all tasks and is thrown") {
  const auto make = [](std::size_t n) -> std::string {
    if (n == 700) throw std::runtime_error("made");
    return "";
  };
  CHECK(thrown_by([&] { in_order({0, 1000}, 2, make, [](std::size_t, const std::string&) {}); }) == "made");
  const auto take = [](std::size_t n, const std::string&) {
    if (n == 50) throw std::runtime_error("taken");
  };
  CHECK(thrown_by([&] { in_order({0, 1000}, 2, make, take); }) == "taken");
}
