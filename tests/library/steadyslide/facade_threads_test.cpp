// Four threads solve different problems, and four use one solution, in double and with 50 digits. Their results equal
// those of one thread. The thread sanitizer checks for data races (preset tsan).

#include <functional>
#include <steadyslide/steadyslide.hpp>
#include <thread>
#include <vector>

#include "doctest/doctest.h"

using namespace steadyslide;

namespace {

constexpr int thread_count = 4;

ProblemData problem(int k) {
  const std::vector<Exact> loads{"0.1", "0.2", "0.3", "0.4"};
  const std::vector<std::string> profiles{"0", "x^2/2", "x^4", "x^2/2 + x^3/9"};
  const auto index = static_cast<std::size_t>(k);
  return {.load = loads[index], .friction = {"0.1", "0.5"}, .jumps = {0}, .poisson = "0.3", .profile = profiles[index]};
}

struct Answer {
  std::string friction;
  std::string traction;
  std::string load;
  double stress;

  explicit Answer(const Solution& solution)
      : friction(solution.effective_friction().digits),
        traction(solution.traction("0.05").digits),
        load(solution.at("0.05").cumulative_load.digits),
        stress(solution.stress("0.05", "0.1").xx.value) {}
  bool operator==(const Answer&) const = default;
};

std::vector<std::optional<Answer>> at_once(const std::function<Answer(int)>& answer) {
  std::vector<std::optional<Answer>> found(thread_count);
  std::vector<std::thread> threads;
  for (int k = 0; k < thread_count; ++k) {
    threads.emplace_back([&, k] { found[static_cast<std::size_t>(k)].emplace(answer(k)); });
  }
  for (std::thread& thread : threads) thread.join();
  return found;
}

}  // namespace

// No code of the library has run before in this program: four threads make its static data at the same time.
TEST_CASE("four threads solve four problems") {
  for (const int digits : {50, 16}) {
    const auto answer = [&](int k) { return Answer(solve(problem(k), {.digits = digits})); };
    const auto found = at_once(answer);
    for (int k = 0; k < thread_count; ++k) CHECK(*found[static_cast<std::size_t>(k)] == answer(k));
  }
}

TEST_CASE("four threads ask one solution") {
  for (const int digits : {50, 16}) {
    const Solution solution = solve(problem(1), {.digits = digits});
    for (const auto& found : at_once([&](int) { return Answer(solution); })) CHECK(*found == Answer(solution));
  }
}
