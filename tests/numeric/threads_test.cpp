// Two threads solve at the same time: each its own problem, and both use the same solution. The values are compared
// here; the thread sanitizer checks for data races (preset tsan).

#include <thread>

#include "numeric/closed_form/closed_form.hpp"
#include "numeric/riemann_hilbert/riemann_hilbert.hpp"
#include "support/numeric_test.hpp"

namespace {

ContactProblem problem(const Rational& friction) {
  const Polynomial left({0, Rational(-1, 4), Rational(1, 2)});
  const Polynomial right({0, Rational(1, 4), Rational(1, 2)});
  return {Elasticity(Solid(0.3_r, 1)), FrictionProfile({friction, 2 * friction}, {0}),
          Indenter(-1, {{0, left}, {1, right}}), Rational(1, 4)};
}

template <Real R>
struct Answer {
  R end;
  R share;
  R residual;

  explicit Answer(const ContactSolution<R>& solution)
      : end(solution.contact().front().left.x.value),
        share(solution.resultants().load_share.front().value),
        residual(solution.residuals().equation) {}
  bool operator==(const Answer&) const = default;
};

}  // namespace

// No code of the library has run before in this program: two threads make its static data at the same time.
TEST_CASE_TEMPLATE("two threads at 50 and 100 digits get what one gets", R, Real50, Real100) {
  const Rational frictions[] = {0.2_r, 0.5_r};
  std::vector<std::optional<Answer<R>>> found(2);
  {
    std::vector<std::thread> threads;
    for (std::size_t i = 0; i < 2; ++i) {
      threads.emplace_back([&, i] { found[i].emplace(*riemann_hilbert<R>(problem(frictions[i])).solution); });
    }
    for (std::thread& thread : threads) thread.join();
  }
  for (std::size_t i = 0; i < 2; ++i) {
    CHECK(*found[i] == Answer<R>(*riemann_hilbert<R>(problem(frictions[i])).solution));
    CHECK(found[i]->residual < pow(R(10), -digits_served<R> + 5));
  }
  CHECK_FALSE(*found[0] == *found[1]);
}

TEST_CASE("two threads ask one solution") {
  const auto solution = riemann_hilbert<Real50>(problem(0.3_r)).solution;
  std::vector<std::optional<Answer<Real50>>> found(2);
  std::thread other([&] { found[0].emplace(*solution); });
  found[1].emplace(*solution);
  other.join();
  CHECK(*found[0] == *found[1]);
}
