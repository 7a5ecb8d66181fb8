#include <algorithm>

#include "numeric/variational/active_set.hpp"
#include "proofs_checks/instruments/cells/cells.hpp"
#include "proofs_checks/instruments/cells/interior_point.hpp"
#include "proofs_checks/kit/findings.hpp"

namespace steadyslide::proofs_checks {
namespace {

using numeric::variational::ActiveSetResult;
using numeric::variational::CellMesh;
using numeric::variational::CellSet;
using numeric::variational::DiscreteProblem;
using numeric::variational::DiscreteState;

CellSet random_set(Random& random, std::size_t cells) {
  CellSet set(cells, 0);
  for (char& cell : set) cell = random.below(2) == 0;
  set[random.below(cells)] = 1;
  return set;
}

/// The solutions that active sets find from these sets, where they do.
std::vector<DiscreteState> solutions(const DiscreteProblem& problem, const std::vector<CellSet>& starts) {
  std::vector<DiscreteState> result;
  for (const CellSet& start : starts) {
    const ActiveSetResult found =
        active_set(problem, start, {std::vector<double>(problem.size(), 0)}, numeric::variational::ActiveSetOptions{});
    if (found.outcome == ActiveSetResult::Outcome::solved) result.push_back(found.state);
  }
  return result;
}

struct Variant {
  bool rising = true;    ///< else a fall of s under a parabola on eight cells, from every contact set
  bool doubled = false;  ///< the load, for interior points
  double moved = 0;
};

/// s falls by 5: complementary are the contacts of the first cell, of the first and the fifth, and of these and the
/// fourth.
ProblemOnCells falling() {
  const ContactProblem problem = cell_problem({{5, 0}, {0}}, Polynomial({0, 0, 1}), Rational(1, 2));
  return {problem, CellMesh(problem, 8)};
}

std::vector<Evidence> check(const Context& context, const Variant& variant) {
  const Quantity forces{
      "forces on all cells", {"active sets, from random sets of cells", "interior points"}, tolerance<double>(), 0.5};
  return gather([&] {
    Random random(context.seed, "thm-01-uniqueness-on-cells");
    Findings findings;
    const std::size_t count = context.quick ? 10 : 200;
    for (std::size_t k = 0; k < count; ++k) {
      const Rational largest = random.between(Rational(1, 5), 3);
      const ProblemOnCells on_cells =
          variant.rising ? random_problem_on_cells(random, k, Trend::rising, largest, false) : falling();
      const DiscreteProblem problem(on_cells.problem, on_cells.mesh);
      std::vector<CellSet> starts;
      for (unsigned bits = 1; bits < 256 && !variant.rising; ++bits) {
        starts.emplace_back(8, 0);
        for (unsigned i = 0; i < 8; ++i) starts.back()[i] = static_cast<char>(bits >> i & 1U);
      }
      for (int i = 0; i < 4 && variant.rising; ++i) starts.push_back(random_set(random, problem.size()));
      const std::vector<DiscreteState> found = solutions(problem, starts);
      findings.begin_case("problem " + std::to_string(k) + ": " + text_of(on_cells), found.size() > 1);
      const Rational& load = on_cells.problem.load();
      auto other = forces_by_interior_points(
          {variant.doubled ? on_cells.problem.with_load(2 * load) : on_cells.problem, on_cells.mesh});
      if (found.empty() || !other) {
        findings.skip(forces);
        continue;
      }
      *other *= 1 + variant.moved;
      for (const DiscreteState& state : found) findings.compare(forces, difference(forces_of(problem, state), *other));
    }
    return findings.evidence("random meshes, rising frictions, profiles and loads, four sets each, seed " +
                             std::to_string(context.seed));
  });
}

}  // namespace

Claim thm_01_uniqueness_on_cells() {
  // Plain: a case counts by how many of its starts lead to a solution, which only the measurement knows.
  return make_claim<Variant>(claim_text("thm-01-uniqueness-on-cells"), check, {},
                             {{"s falling by 5: a problem with three solutions", {.rising = false}},
                              {"twice the load for one of the methods", {.doubled = true}},
                              {"near miss: forces moved by ten times the tolerance", {.moved = near_miss<double>()}}});
}

}  // namespace steadyslide::proofs_checks
