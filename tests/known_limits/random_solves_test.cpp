// The generator makes problems as promised, and writing a problem file and reading it back does not change a problem.
// Whole solves from the file's text to the result's: nothing throws, and every result is written. The sanitizers use
// this test because it covers much code.

#include <array>

#include "app/commands/solver.hpp"
#include "app/results/solve_writers.hpp"
#include "library/problem_file/problem_file.hpp"
#include "support/problem_toml.hpp"
#include "support/random_contact.hpp"
#include "support/test.hpp"

namespace {

/// Method, samples and format take turns, so that every kind of solution meets every writer. Closed forms rarely apply,
/// so reports of a method that does not apply occur as well.
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
    case 1: app::write_csv(problem, solution, output); break;
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

// Slow: one or two minutes, with sanitizers twenty times as long.
TEST_CASE("slow: 3000 problems" * doctest::skip()) { solve_the_first(3000); }

TEST_CASE("files say the same problem") {
  for (int i = 0; i < listed_problems; i += 5) {
    const std::string text = problem_toml(random_contact(first_listed_seed + static_cast<std::uint64_t>(i)));
    CHECK(problem_toml(app::parse_problem(text, "random").contact) == text);
  }
}

TEST_CASE("ranges") {
  Rational highest_friction = 0;
  int tilting = 0, with_steps = 0;
  for (int i = 0; i < listed_problems; ++i) {
    const ContactProblem p = random_contact(first_listed_seed + static_cast<std::uint64_t>(i));
    const std::vector<Rational>& f = p.friction().values();
    const std::vector<Indenter::Break> breaks = p.indenter().breaks();
    CHECK(2 <= f.size());
    CHECK(f.size() <= 7);
    highest_friction = std::max(highest_friction, *std::max_element(f.begin(), f.end()));
    CHECK(highest_friction <= 20);
    CHECK(breaks.size() <= 4);
    for (const Indenter::Piece& piece : p.indenter().pieces()) CHECK(piece.profile.degree() <= 6);
    tilting += p.load_at() ? 1 : 0;
    with_steps += std::any_of(breaks.begin(), breaks.end(), [](const auto& b) { return b.step != 0; }) ? 1 : 0;
  }
  CHECK(highest_friction == 20);
  CHECK(tilting >= listed_problems / 50);
  CHECK(with_steps >= listed_problems / 20);
}

TEST_CASE("the same problem on every platform") {
  CHECK(problem_toml(random_contact(first_listed_seed)) == R"(load = "4.375"
sliding = "+x"

[half_space]
poisson = "0.2"
young = "70"
plane = "stress"

[friction]
values = ["0", "1.9", "12", "0", "0", "0"]
jumps = ["-2.5", "-0.01953125", "0", "3.125", "4.140625"]

[indenter]
support = ["-5", "5"]
pieces = [
  {to = "0", profile = "0.04*x^2 + 0.2*x + 0.255859375"},
  {to = "5", profile = "0.04*x^2 - 0.2*x + 0.25"},
]
)");
}
