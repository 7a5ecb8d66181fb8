// Several threads prove exactly what one thread proves, to the last bit. The thread sanitizer checks for data races
// (preset tsan).

#include <atomic>
#include <chrono>
#include <functional>
#include <thread>

#include "enclosure/contact/enclosed_solution.hpp"
#include "enclosure/found_contact.hpp"
#include "enclosure/loads/load_path.hpp"
#include "enclosure/number/task_threads.hpp"
#include "support/numeric_test.hpp"
#include "support/problems.hpp"

using namespace steadyslide::enclosure;

namespace {

std::vector<LoadStretch> path_in(unsigned threads, const ContactProblem& problem, const Rational& from,
                                 const Rational& to) {
  LoadPathOptions options;
  options.width = 0.001_r;
  options.threads = threads;
  return follow_loads(
      problem, from, to, [&](const Rational& load) { return found_contact<double>(problem.with_load(load)); }, options);
}

std::string told(const std::vector<LoadStretch>& stretches) {
  std::string text;
  for (const LoadStretch& s : stretches) {
    text += to_string(s.from) + " " + to_string(s.to) + " " + s.words + "\n";
    if (!s.interval) continue;
    for (const Ball& h : s.interval->proof.box.log_offsets) text += h.dump() + "\n";
    for (const Ball& q : s.interval->proof.box.q) text += q.dump() + "\n";
  }
  return text;
}

}  // namespace

TEST_CASE("so many threads at a time find the same, to the last bit") {
  const ContactProblem parabola = reduced({0.1_r, 0.6_r}, {0.2_r}, one_piece(-2, 2, {0, 0, 2.5_r}), 1);
  const ContactProblem tilting = reduced({0.1_r, 0.3_r}, {0.1_r}, one_piece(-1, 1, {0, 0, 1}), 1, 0.05_r);
  for (const auto& [problem, from, to] : {std::tuple(parabola, 0.2_r, 0.8_r),  // an end passes the jump
                                          {tilting, 2_r, 5_r}}) {              // both ends come to rest on edges
    const std::string alone = told(path_in(1, problem, from, to));
    for (const unsigned threads : {2U, 5U}) CHECK((told(path_in(threads, problem, from, to)) == alone));
    CHECK((told(path_in(1, problem, from, (from + to) / 2)) != alone));
  }
}

TEST_CASE("the numbers of a proof by several threads are those by one") {
  // Two polynomials in contact; over a notch with a short gap there are many panels, and distant ones are replaced by
  // their moments.
  for (const ContactProblem& problem : {reduced({0.1_r, 0.3_r}, {0.1_r}, roof(-0.05_r, 0.05_r, 0.5_r), 1),
                                        reduced({0.1_r, 0.2_r}, {0}, roof(0.2_r, -0.2_r), 3)}) {
    const auto contact = found_contact<double>(problem);
    REQUIRE(contact);
    const auto numbers = [&](int digits, unsigned threads) {
      const ContactProof proof = prove_contact(problem, *contact, digits);
      REQUIRE_MESSAGE(proof.proved, proof.reason);
      std::string text;
      for (const Ball& share : EnclosedSolution(problem, proof, threads).resultants().load_share) {
        text += share.dump() + "\n";
      }
      return text;
    };
    const std::string alone = numbers(30, 1);
    for (const unsigned threads : {2U, 5U}) CHECK(numbers(30, threads) == alone);
    CHECK(numbers(31, 1) != alone);
  }
}

TEST_CASE("two tasks: at most as many threads as there may be, and what one throws is thrown") {
  for (const int most : {1, 2, 3}) {
    TaskThreads threads(static_cast<unsigned>(most));
    std::atomic<int> running{0};
    std::atomic<int> together{0};
    const std::function<int(int)> leaves = [&](int depth) -> int {
      if (depth > 0) {
        const auto [left, right] = threads.both([&] { return leaves(depth - 1); }, [&] { return leaves(depth - 1); });
        return left + right;
      }
      const int now = ++running;
      for (int seen = together; now > seen && !together.compare_exchange_weak(seen, now);) {
      }
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
      --running;
      return 1;
    };
    CHECK(leaves(5) == 32);
    CHECK(together >= std::min(most, 2));
    CHECK(together <= most);
    const std::vector<int> squares = threads.all(0, 100, [](std::size_t k) { return static_cast<int>(k * k); });
    REQUIRE(squares.size() == 100);
    for (int k = 0; k < 100; ++k) CHECK(squares[static_cast<std::size_t>(k)] == k * k);
    CHECK(threads.all(3, 3, [](std::size_t k) { return k; }).empty());
    const auto throws = []() -> int { throw std::runtime_error("here"); };
    CHECK_THROWS_WITH(threads.both([] { return 1; }, throws), "here");
    CHECK_THROWS_WITH(threads.both(throws, [] { return 1; }), "here");
  }
}
