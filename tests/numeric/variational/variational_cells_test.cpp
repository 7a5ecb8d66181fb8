// Integrals of friction and profile over cells, compared with exact rational integrals.

#include "numeric/number/real.hpp"
#include "numeric/variational/cell_data.hpp"
#include "support/numeric_test.hpp"

using namespace steadyslide::numeric::variational;

namespace {

// Support [1, 5] with four cells, which meet at 2, 3, 4. Jumps inside cells, at a cell's end, two in one cell; a
// profile with a wedge inside a cell and a step at a cell's end, in other cells than the jumps and in the same.
const Indenter indenter(1, {{1.5_r, Polynomial({1, 2, Rational(1, 3)})},
                            {3, Polynomial({0, -1, 0, 0, 0.2_r})},
                            {3.8_r, Polynomial({7})},
                            {5, Polynomial({2, 0, 0, 0, 0, 0, 0.01_r})}});
const FrictionProfile friction({0.5_r, 3, 0, 1, Rational(1, 7)}, {1.4_r, 3, 3.1_r, 3.6_r});

ContactProblem problem_with(Sliding sliding) {
  return {Elasticity(Solid(0.2_r, 3)), friction, indenter, 3.5_r, sliding};
}

/// Returns s at a place at which friction does not change.
Rational s_at(const ContactProblem& problem, const Rational& x) {
  return problem.coupled_friction(problem.friction().piece(x, Side::left));
}

/// Returns the sum of f(from, to) over the parts of [left, right] on which friction and profile are one function each.
template <class F>
Rational sum_of(const ContactProblem& problem, const Rational& left, const Rational& right, const F& f) {
  std::set<Rational> ends{left, right};
  for (const Rational& c : problem.friction().jumps()) ends.insert(c);
  for (const Indenter::Break& b : problem.indenter().breaks()) ends.insert(b.x);
  Rational sum = 0;
  for (auto end = ends.find(left); *end < right; ++end) sum += f(*end, *std::next(end));
  return sum;
}

/// Returns int s from one place to a later one, in the user's x.
Rational integral_of_s(const ContactProblem& problem, const Rational& from, const Rational& to) {
  const auto over = [&](const Rational& a, const Rational& b) {
    return Rational(s_at(problem, (a + b) / 2) * (b - a));
  };
  return sum_of(problem, from, to, over);
}

/// The mean over the cell of int s from its left end, or to its right end with the sign of -s. The integral is linear
/// between the nodes.
Rational own_by_trapezia(const ContactProblem& problem, const Rational& left, const Rational& right, int sign) {
  const auto felt = [&](const Rational& at) -> Rational {
    return sign > 0 ? integral_of_s(problem, left, at) : Rational(-integral_of_s(problem, at, right));
  };
  const auto over = [&](const Rational& a, const Rational& b) { return Rational((felt(a) + felt(b)) / 2 * (b - a)); };
  return sum_of(problem, left, right, over) / (right - left);
}

Rational height(const Rational& x) { return indenter.profile(x, Side::left)(x); }

/// The mean of the profile over the cell, by its antiderivative.
Rational mean_height(const ContactProblem& problem, const Rational& left, const Rational& right) {
  const auto over = [](const Rational& a, const Rational& b) {
    std::vector<Rational> raised{0};
    for (const Rational& c : indenter.profile((a + b) / 2, Side::left).coefficients()) {
      raised.push_back(c / Rational(raised.size()));
    }
    const Polynomial antiderivative(raised);
    return Rational(antiderivative(b) - antiderivative(a));
  };
  return sum_of(problem, left, right, over) / (right - left);
}

}  // namespace

TEST_CASE("friction within cells, whichever way the indenter slides") {
  for (const Sliding sliding : {Sliding::plus_x, Sliding::minus_x}) {
    const ContactProblem problem = problem_with(sliding);
    const int sign = sliding == Sliding::plus_x ? 1 : -1;
    for (int cells : {1, 2, 4, 7, 40, 41}) {
      CAPTURE(cells);
      const CellMesh mesh(problem, static_cast<std::size_t>(cells));
      const CellFriction found = cell_friction(problem, mesh);
      CHECK(found.sign == sign);
      bool differs = false;
      for (int i = 0; i < cells; ++i) {
        const Rational left = 1 + Rational(4 * i, cells), right = 1 + Rational(4 * (i + 1), cells);
        const auto at = static_cast<std::size_t>(i);
        const auto whole = to_real<double>(integral_of_s(problem, left, right) / 4);
        const auto own = to_real<double>(own_by_trapezia(problem, left, right, sign) / 4);
        CHECK(std::abs(found.whole[at] - whole) <= 1e-15);
        CHECK(std::abs(found.own[at] - own) <= 1e-15);
        CHECK(own >= 0);
        // Control: half of the whole is the mean only for constant s. With 40 cells all jumps are at cells' ends.
        differs = differs || std::abs(sign * whole / 2 - own) > 1e-5;
      }
      CHECK(differs == (cells != 40));
    }
  }
}

TEST_CASE("the profile's means over cells, with wedges and steps anywhere") {
  const ContactProblem problem = problem_with(Sliding::plus_x);
  const Rational scale = problem.elasticity().compliance() * problem.load();
  for (int cells : {1, 2, 4, 7, 40, 41}) {
    CAPTURE(cells);
    const CellMesh mesh(problem, static_cast<std::size_t>(cells));
    const std::vector<double> found = CellProfile(problem, mesh.frame()).means(mesh);
    bool differs = false;
    for (int i = 0; i < cells; ++i) {
      const Rational left = 1 + Rational(4 * i, cells), right = 1 + Rational(4 * (i + 1), cells);
      const auto mean = to_real<double>((mean_height(problem, left, right) - height(3)) / scale);
      CHECK(found[static_cast<std::size_t>(i)] == doctest::Approx(mean).epsilon(1e-13));
      // Control: the height at the cell's middle is not the mean.
      const auto middle = to_real<double>((height((left + right) / 2) - height(3)) / scale);
      differs = differs || std::abs(middle - mean) > 1e-6 * std::abs(mean);
    }
    CHECK(differs);
  }
}

TEST_CASE("graded edges: the smallest at the origin, none above the largest, the ends met") {
  const std::vector<double> edges = graded_edges(-0.3, 0.7, 1e-9, 1.5, 0.05);
  CHECK(edges.front() == -0.3);
  CHECK(edges.back() == 0.7);
  CHECK(std::is_sorted(edges.begin(), edges.end()));
  const auto zero = std::find(edges.begin(), edges.end(), 0.0);
  REQUIRE(zero != edges.end());
  CHECK(*(zero + 1) == 1e-9);
  CHECK(*(zero - 1) == -1e-9);
  for (auto edge = edges.begin(); edge + 1 != edges.end(); ++edge) CHECK(*(edge + 1) - *edge <= 0.05 * 1.5);
  const CellMesh mesh(problem_with(Sliding::plus_x), 2.2_r, edges);
  CHECK(mesh.left(mesh.cell_at(0)) == 0);
  CHECK(mesh.cell_at(-1) == 0);
  CHECK(mesh.cell_at(1) == mesh.size() - 1);
  CHECK_THROWS_AS(CellMesh(problem_with(Sliding::plus_x), 3, {0, 1, 1}), std::invalid_argument);
}
