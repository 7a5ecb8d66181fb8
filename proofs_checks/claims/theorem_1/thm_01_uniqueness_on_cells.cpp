#include "proofs_checks/instruments/cells/interior_point.hpp"
#include "proofs_checks/kit/claim_builder.hpp"

namespace steadyslide::proofs_checks::thm_01_uniqueness_on_cells {
namespace {

/// A problem, and contact sets to start from.
struct Started {
  std::string name;
  ProblemOnCells on_cells;
  std::vector<CellSet> starts;
};

CaseList<Started> rising(const Context& context) {
  return random_cases(context, "thm-01-uniqueness-on-cells", 200, 10,
                      "random meshes, rising frictions, profiles and loads, four sets each",
                      [](Random& random, std::size_t k) {
                        const Rational largest = random.between(Rational(1, 5), 3);
                        ProblemOnCells on_cells = random_problem_on_cells(random, k, Trend::rising, largest, false);
                        Started c{"problem " + std::to_string(k) + ": " + text_of(on_cells), on_cells, {}};
                        for (int i = 0; i < 4; ++i)
                          c.starts.push_back(random_contact_set(random, on_cells.mesh.size()));
                        return c;
                      });
}

/// The claim: active sets and interior points find the same forces.
struct SameForces {
  int load = 1;  ///< factor of the load for interior points
  Number forces = 1;
};

void check(Findings& findings, const SameForces& said, const Started& c) {
  const auto& [problem, mesh] = c.on_cells;
  const DiscreteProblem discrete(problem, mesh);
  const std::vector<DiscreteState> found = solutions_from(discrete, c.starts);
  auto other = forces_by_interior_points({problem.with_load(said.load * problem.load()), mesh});
  // If fewer than two starts lead to a solution, this shows nothing about uniqueness: the case counts as one without
  // effect.
  if (found.size() < 2 || !other) findings.skip("forces");
  if (!other) return;
  *other *= static_cast<double>(said.forces);
  for (const DiscreteState& state : found) findings.compare("forces", difference(forces_of(discrete, state), *other));
}

}  // namespace

Claim claim() {
  return formula_claim<Started, SameForces>("thm-01-uniqueness-on-cells")
      .cases(rising)
      .precision(Precision::in_double)
      .checked(check)
      .wrong_beyond("`s` falling by 5: a problem with three solutions",
                    fixed_cases<Started>({{"`s` falling by 5", problem_with_three_solutions(), all_contact_sets(8)}}, 1,
                                         "one problem"))
      .wrong("twice the load for one of the methods", &SameForces::load, 2)
      .near_miss("forces", &SameForces::forces);
}

}  // namespace steadyslide::proofs_checks::thm_01_uniqueness_on_cells
