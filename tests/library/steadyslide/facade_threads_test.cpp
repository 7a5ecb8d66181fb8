// Four threads solve different problems, and four use one solution. Their results equal those of one thread. The thread
// sanitizer checks for data races (preset tsan).

#include <optional>
#include <steadyslide/steadyslide.hpp>
#include <thread>
#include <vector>

#include "doctest/doctest.h"

using namespace steadyslide;

namespace {

ProblemData problem(int k) {
  const std::vector<Exact> loads{"0.1", "0.2", "0.3", "0.4"};
  const std::vector<std::string> profiles{"0", "x^2/2", "x^4", "x^2/2 + x^3/9"};
  const auto index = static_cast<std::size_t>(k);
  return {.load = loads[index], .friction = {"0.1", "0.5"}, .jumps = {0}, .poisson = "0.3", .profile = profiles[index]};
}

ProblemData on_layer() {
  ProblemData data = problem(1);
  data.young = 1;
  data.layers = {{.thickness = 1, .young = "0.5", .poisson = "0.4"}};
  return data;
}

ProblemData periodic() {
  ProblemData data = problem(1);
  data.period = 4;
  return data;
}

ProblemData worn(int k) {
  ProblemData data = problem(k);
  data.wear = {.coefficients = {1}};
  return data;
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

template <class Make>
void check_four_threads(const Make& answer) {
  constexpr int count = 4;
  std::vector<std::optional<decltype(answer(0))>> found(count);
  std::vector<std::thread> threads;
  for (int k = 0; k < count; ++k) {
    threads.emplace_back([&, k] { found[static_cast<std::size_t>(k)].emplace(answer(k)); });
  }
  for (std::thread& thread : threads) thread.join();
  for (int k = 0; k < count; ++k) CHECK(*found[static_cast<std::size_t>(k)] == answer(k));
}

}  // namespace

// No code of the library has run before in this program: four threads make its static data at the same time.
TEST_CASE("four threads solve four problems") {
  for (const int digits : {50, 16}) {
    check_four_threads([&](int k) { return Answer(solve(problem(k), {.digits = digits})); });
  }
}

TEST_CASE("four threads solve on cells, wear, prove and derive") {
  check_four_threads([](int k) { return Answer(solve(problem(k), {.method = "variational", .cells = 256})); });
  check_four_threads([](int k) { return wear(worn(k), {.distance = "0.01", .steps = 2, .cells = 256}).pressure; });
  check_four_threads([](int k) { return solve(problem(k)).certify().certificate; });
  check_four_threads([](int k) { return derivation(problem(k)); });
}

TEST_CASE("four threads ask one solution") {
  for (const auto& [data, digits] : {std::pair(problem(1), 50), {problem(1), 16}, {on_layer(), 16}, {periodic(), 16}}) {
    const Solution solution = solve(data, {.digits = digits});
    check_four_threads([&](int) { return Answer(solution); });
  }
}
