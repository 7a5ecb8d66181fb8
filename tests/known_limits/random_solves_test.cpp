// Whole solves of random problems, from the file's text to the result's: nothing may throw, and every result is
// written. With the sanitizers it is the many-sided run that they want.

#include <array>

#include "app/commands/solver.hpp"
#include "app/problem_file/problem_file.hpp"
#include "app/results/solve_writers.hpp"
#include "support/problem_toml.hpp"
#include "support/random_contact.hpp"
#include "support/test.hpp"

namespace {

/// Method, samples and format go by turns: a solution of every kind meets every writer. Closed forms rarely apply, so
/// that reports of a method that does not apply are made as well.
bool solve_and_write(std::uint64_t seed, app::Output& output) {
  constexpr std::array methods{app::Method::automatic, app::Method::riemann_hilbert, app::Method::variational,
                               app::Method::closed_form};
  const app::Problem problem = app::parse_problem(problem_toml(random_contact(seed)), "random");
  app::Solver::Wanted wanted{methods[seed % methods.size()], {.at = {-1, 0, Rational(1, 3)}, .samples = 5}, {}};
  wanted.variational.cells = 128;
  const app::SolutionText solution = app::Solver(std::move(wanted)).solve(problem);
  if (!solution.reason.empty()) return false;
  switch (seed / methods.size() % 3) {
    case 0: app::write_json(problem, solution, output); break;
    case 1: app::write_csv(solution, output); break;
    default: app::write_text(problem, solution, output); break;
  }
  return solution.is_solved();
}

void solve_the_first(int count) {
  app::Output output("/dev/null");
  int solved = 0;
  for (int i = 0; i < count; ++i) {
    const std::uint64_t seed = first_listed_seed + static_cast<std::uint64_t>(i);
    CAPTURE(seed);
    bool is_solved = false;
    CHECK_NOTHROW(is_solved = solve_and_write(seed, output));
    solved += is_solved ? 1 : 0;
  }
  output.commit();
  MESSAGE("solved ", solved, " of ", count);
  CHECK(2 * solved >= count);
}

}  // namespace

TEST_CASE("the first 48 problems") { solve_the_first(48); }

// Slow: a minute or two, with sanitizers twenty times that.
TEST_CASE("slow: 3000 problems" * doctest::skip()) { solve_the_first(3000); }
