#include "proofs_checks/instruments/cells/cells.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "proofs_checks/instruments/cells/dense_algebra.hpp"

namespace steadyslide::proofs_checks {

CellFrictionSteps random_steps(Random& random, Trend trend, const Rational& largest, std::size_t most_jumps) {
  CellFrictionSteps steps;
  const std::size_t jumps = 1 + random.below(most_jumps);
  while (steps.jumps.size() < jumps) {
    const Rational c = random.between(Rational(-3, 4), Rational(3, 4));
    if (std::ranges::find(steps.jumps, c) == steps.jumps.end()) steps.jumps.push_back(c);
  }
  std::ranges::sort(steps.jumps);
  for (std::size_t k = 0; k <= jumps; ++k) steps.s.push_back(random.between(0, largest));
  if (trend != Trend::any) std::ranges::sort(steps.s);
  if (trend == Trend::falling) std::ranges::reverse(steps.s);
  return steps;
}

CellFrictionSteps mirrored(const CellFrictionSteps& steps) {
  CellFrictionSteps result;
  for (std::size_t k = steps.s.size(); k-- > 0;) result.s.push_back(-steps.s[k]);
  for (std::size_t k = steps.jumps.size(); k-- > 0;) result.jumps.push_back(-steps.jumps[k]);
  return result;
}

ContactProblem cell_problem(const CellFrictionSteps& steps, const Polynomial& profile, const Rational& load,
                            std::optional<Rational> load_at) {
  bool forwards = true;
  std::vector<Rational> f;
  for (const Rational& s : steps.s) {
    if (s < 0) forwards = false;
    f.push_back(2 * (s < 0 ? Rational(-s) : s));
  }
  return {Elasticity::reduced(Rational(1, 2)),
          FrictionProfile(f, steps.jumps),
          Indenter(-1, {{1, profile}}),
          load,
          forwards ? Sliding::plus_x : Sliding::minus_x,
          std::move(load_at)};
}

Polynomial random_profile(Random& random, bool convex) {
  const Rational slope = random.between(Rational(-1, 2), Rational(1, 2));
  const Rational curve = convex ? random.between(Rational(1, 2), 2) : random.between(-1, 0);
  return Polynomial({0, slope, curve, convex ? Rational(0) : random.between(Rational(-1, 3), Rational(1, 3)), 1});
}

CellMesh random_cells(Random& random, const ContactProblem& problem, Cells cells, std::size_t count) {
  switch (cells) {
    case Cells::unequal:
    case Cells::alternating: {
      std::vector<double> edges{0};
      for (std::size_t i = 0; i < count; ++i) {
        const Rational turn = i % 2 == 0 ? Rational(1) : Rational(1, 20);
        const Rational length = cells == Cells::unequal ? random.between(Rational(1, 20), 1) : turn;
        edges.push_back(edges.back() + to_real<double>(length));
      }
      const double length = edges.back();
      for (double& edge : edges) edge = edge / length - 0.5;
      edges.back() = 0.5;
      return {problem, Rational(0), std::move(edges)};
    }
    case Cells::graded: {
      const std::vector<Rational>& jumps = problem.friction().jumps();
      const Rational c = jumps[random.below(jumps.size())];
      const double smallest = std::pow(10.0, -3.0 - static_cast<double>(random.below(5)));
      const auto left = to_real<double>((-1 - c) / 2);
      return {problem, c, numeric::variational::graded_edges(left, left + 1, smallest, 3, 0.2)};
    }
    default: return {problem, count};
  }
}

ProblemOnCells random_problem_on_cells(Random& random, std::size_t k, Trend trend, const Rational& largest,
                                       bool may_tilt) {
  constexpr std::array<Cells, 3> kinds{Cells::equal, Cells::unequal, Cells::graded};
  CellFrictionSteps steps = random_steps(random, trend, largest, 4);
  if (random.below(2) == 0) steps = mirrored(steps);
  const Rational load = random.between(Rational(1, 5), 4);
  std::optional<Rational> load_at;
  if (may_tilt && random.below(4) == 0) load_at = random.between(Rational(-1, 2), Rational(1, 2));
  const ContactProblem problem = cell_problem(steps, random_profile(random, k % 2 == 0), load, load_at);
  return {problem, random_cells(random, problem, kinds[k % 3], 16 + random.below(24))};
}

std::string text_of(const ProblemOnCells& on_cells) {
  return std::to_string(on_cells.mesh.size()) + " cells" + (on_cells.problem.load_at() ? ", tilting" : "");
}

GalerkinOperator operator_of(const CellFrictionSteps& steps, const CellMesh& mesh) {
  return {mesh, numeric::variational::cell_friction(cell_problem(steps), mesh)};
}

Eigen::MatrixXd symmetric_part(const CellMesh& mesh, const GalerkinOperator& b, bool slip) {
  return matrix_of(b.size(), b.size(), [&](std::size_t row, std::size_t column) {
    // This makes the rounding equal on both sides of the diagonal.
    const auto [i, j] = std::minmax(row, column);
    const double value = b.kernel_entry(i, j) / mesh.length(j);
    return slip ? value + (b.friction_entry(i, j) / mesh.length(j) + b.friction_entry(j, i) / mesh.length(i)) / 2
                : value;
  });
}

Eigen::MatrixXd gap_of_forces(const GalerkinOperator& b, const CellMesh& mesh) {
  return matrix_of(b.size(), b.size(), [&](std::size_t i, std::size_t j) { return b.entry(i, j) / mesh.length(j); });
}

Eigen::MatrixXd on_zero_mean(const Eigen::MatrixXd& form) {
  const Eigen::Index n = form.rows() - 1;
  const Eigen::MatrixXd rows = form.topRows(n) - form.bottomRows(n);
  return rows.leftCols(n) - rows.rightCols(n);
}

Eigen::VectorXd weights_of(const CellMesh& mesh, double c) {
  return vector_of(mesh.size(),
                   [&](std::size_t i) { return std::clamp((c - mesh.left(i)) / mesh.length(i), 0.0, 1.0); });
}

std::string text_of(const CellFrictionSteps& steps) {
  std::string text = "s =";
  for (const Rational& s : steps.s) text += " " + to_string(s);
  text += ", jumps at";
  for (const Rational& c : steps.jumps) text += " " + to_string(c);
  return text;
}

}  // namespace steadyslide::proofs_checks
