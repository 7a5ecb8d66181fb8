// The certificate of a state on cells: a solution is accepted, and each state with a single fault is refused for that
// fault.

#include "numeric/variational/certificate.hpp"
#include "numeric/variational/nested_solve.hpp"
#include "support/cells.hpp"

namespace {

/// A parabola on two coatings. With `load_at` it may tilt.
DiscreteProblem parabola(const std::optional<Rational>& load_at = std::nullopt) {
  return on_cells(reduced({0.25_r, 0.5_r}, {0}, one_piece(-1, 1, {0, 0, 4}), 1, load_at), 120);
}

ActiveSetResult solved_cells(const DiscreteProblem& problem) {
  const ActiveSetResult result = active_set(problem, CellSet(problem.size(), 1), nothing(problem), {});
  REQUIRE(result.outcome == ActiveSetResult::Outcome::solved);
  return result;
}

/// The same contact under another load or moment.
DiscreteState under(const DiscreteProblem& problem, const CellSet& contact, std::array<double, 2> loads) {
  std::vector<double> rhs = problem.profile();
  for (double& value : rhs) value = -value;
  return dense_system(problem, contact)->solve(rhs, loads).state;
}

}  // namespace

TEST_CASE("certificate: solutions are accepted, with and without a place of the load") {
  for (const auto& load_at : {std::optional<Rational>(), std::optional(0.1_r)}) {
    const DiscreteProblem problem = parabola(load_at);
    const Certificate certificate = certify(problem, solved_cells(problem).state);
    CHECK(certificate.accepted());
    CHECK(certificate.rows == problem.size());
    CHECK(certificate.allowed >= 1e-10);
    CHECK(certificate.allowed < 1e-9);
  }
}

TEST_CASE("certificate: another load and another moment are refused for these alone") {
  const DiscreteProblem problem = parabola(0.1_r);
  const CellSet contact = solved_cells(problem).contact;
  const double moment = *problem.load_at();

  for (const bool heavier : {true, false}) {
    const double more = heavier ? 1e-7 : 0, turned = 1e-7 - more;
    const Certificate c = certify(problem, under(problem, contact, {1 + more, moment + turned}));
    CHECK((heavier ? c.load : c.moment) * 1e7 == doctest::Approx(1).epsilon(1e-4));
    CHECK(std::max({c.natural, c.equation, heavier ? c.moment : c.load, c.product}) <= c.allowed);
    CHECK_FALSE(c.accepted());
  }
}

TEST_CASE("certificate: a contact too small penetrates beside it, one too large pulls") {
  const DiscreteProblem problem = parabola();
  const ActiveSetResult solution = solved_cells(problem);
  const std::size_t first = cells_of(solution.contact).front();
  for (const bool small : {true, false}) {
    CellSet contact = solution.contact;
    contact[small ? first : first - 1] = small ? 0 : 1;
    const Certificate c = certify(problem, under(problem, contact, {1, 0}));
    const double wrong = small ? c.penetration : c.tension;
    CHECK(wrong > 1e-6);
    CHECK(c.natural == doctest::Approx(wrong));
    CHECK(std::max({c.equation, c.load, small ? c.tension : c.penetration}) <= c.allowed);
    CHECK_FALSE(c.accepted());
  }
}

TEST_CASE("certificate: a pressure across a gap, however small, and what is no number") {
  const DiscreteProblem problem = parabola();
  DiscreteState state = solved_cells(problem).state;
  REQUIRE(state.pressure[0] == 0);
  state.pressure[0] = 1e-13;
  const Certificate across = certify(problem, state);
  CHECK(across.natural <= across.allowed);
  CHECK(across.equation > 1);
  CHECK_FALSE(across.accepted());

  state.pressure[0] = 0;
  state.approach = std::numeric_limits<double>::quiet_NaN();
  CHECK_FALSE(certify(problem, state).accepted());
}
