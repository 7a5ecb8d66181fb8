// Krylov's method on a contact set: the factorisation's solution, from few products whatever the mesh. The number is
// what the preconditioner is for; nothing else shows whether it has the friction's sign right.

#include "support/cells.hpp"

namespace {

/// A parabola under s up to 3/2, on cells of which the middle three quarters are in contact.
DiscreteProblem coated(std::size_t cells, Sliding sliding, const std::optional<Rational>& load_at) {
  return on_cells(reduced({0.5_r, 1.5_r, 1}, {Rational(-1, 3), 0}, one_piece(-1, 1, {0, 0, 1}), 1, load_at, sliding),
                  cells);
}

CellSet middle(std::size_t cells) {
  CellSet contact(cells, 0);
  for (std::size_t i = cells / 8; i < cells - cells / 8; ++i) contact[i] = 1;
  return contact;
}

SystemSolution by_krylov(const DiscreteProblem& problem) {
  return solve(*krylov_system(problem, middle(problem.size()), nothing(problem), 1e-11), problem);
}

}  // namespace

TEST_CASE("Krylov's method and the factorisation solve the same system") {
  for (const Sliding sliding : {Sliding::plus_x, Sliding::minus_x}) {
    for (const auto& load_at : {std::optional<Rational>(), std::optional(0.1_r)}) {
      const DiscreteProblem problem = coated(400, sliding, load_at);
      const DiscreteState dense = solve(*dense_system(problem, middle(400)), problem).state;
      const DiscreteState found = by_krylov(problem).state;
      double highest = 0, worst = 0;
      for (std::size_t i = 0; i < problem.size(); ++i) {
        highest = std::max(highest, std::abs(dense.pressure[i]));
        worst = std::max(worst, std::abs(dense.pressure[i] - found.pressure[i]));
      }
      CHECK(worst <= 1e-8 * highest);
      CHECK(std::abs(found.approach - dense.approach) <= 1e-10);
      CHECK(std::abs(found.tilt - dense.tilt) <= 1e-9);
    }
  }
}

TEST_CASE("Krylov's method takes few products, whatever the mesh and the sense of sliding") {
  for (const Sliding sliding : {Sliding::plus_x, Sliding::minus_x}) {
    for (const std::size_t cells : {500U, 4000U, 32000U}) {
      CAPTURE(cells);
      const SystemSolution found = by_krylov(coated(cells, sliding, std::nullopt));
      CHECK(found.residual <= 1e-11);
      CHECK(found.products <= 22);
    }
  }
}
