// The operator with a diagonal, as a step of wear has it.

#include "numeric/variational/certificate.hpp"
#include "numeric/variational/nested_solve.hpp"
#include "support/problems.hpp"

namespace {

using namespace numeric::variational;

/// Diagonals of different sizes on three parts, with 0 on the last one.
std::vector<double> three_parts(std::size_t cells, double size) {
  std::vector<double> result(cells);
  for (std::size_t i = 0; i < cells; ++i) result[i] = i < cells / 3 ? size : i < cells / 2 ? size / 100 : 0;
  return result;
}

}  // namespace

TEST_CASE("a diagonal is in entries, in products, in parts, and on cells of any length") {
  const ContactProblem problem = reduced({0.3_r, 1}, {0.1_r}, one_piece(-1, 1, {0, 0, 1}), 1);
  const std::vector<double> edges{-0.5, -0.2, 0.1, 0.25, 0.5};
  for (const CellMesh& mesh : {CellMesh(problem, 64), CellMesh(problem, 0, edges)}) {
    const std::size_t n = mesh.size();
    const DiscreteProblem plain(problem, mesh);
    const DiscreteProblem stiff(plain, std::vector<double>(n), three_parts(n, 3));
    std::vector<double> p(n), without(n), with(n);
    for (std::size_t i = 0; i < n; ++i) p[i] = 1 + static_cast<double>(i % 5);
    plain.galerkin_operator().multiply(p, without);
    stiff.galerkin_operator().multiply(p, with);
    for (std::size_t i = 0; i < n; ++i) {
      CHECK(with[i] - without[i] == doctest::Approx(three_parts(n, 3)[i] * p[i]));
      CHECK(stiff.galerkin_operator().entry(i, i) - plain.galerkin_operator().entry(i, i) ==
            doctest::Approx(three_parts(n, 3)[i]));
      CHECK(stiff.galerkin_operator().entry(i, 0) - (i == 0 ? 3 : 0) ==
            doctest::Approx(plain.galerkin_operator().entry(i, 0)));
    }
    if (mesh.is_uniform()) CHECK(stiff.galerkin_operator().part(20, 9).diagonal(3) == three_parts(n, 3)[23]);
  }
}

TEST_CASE("Krylov's method takes few products for every diagonal, and finds what LU finds") {
  const ContactProblem problem = reduced({0.3_r, 1}, {0.1_r}, one_piece(-1, 1, {0, 0, 0.25_r}), 1);
  const std::size_t n = 600;
  const DiscreteProblem plain(problem, CellMesh(problem, n));
  for (const double size : {0.0, 0.01, 1.0, 100.0, 1e4}) {
    const auto stiff = std::make_shared<const DiscreteProblem>(plain, std::vector<double>(n), three_parts(n, size));
    ActiveSetOptions options;
    const MeshSolution krylov = solve_on_cells(stiff, CellSet(n, 1), {std::vector<double>(n)}, options);
    options.dense_cells = n;
    const MeshSolution dense = solve_on_cells(stiff, CellSet(n, 1), {std::vector<double>(n)}, options);
    REQUIRE(krylov.found.outcome == ActiveSetResult::Outcome::solved);
    CHECK(krylov.found.contact == dense.found.contact);
    CHECK(krylov.found.products > 0);
    CHECK(krylov.found.products < 16 * krylov.found.steps);
    CHECK(dense.found.products == 0);
    for (std::size_t i = 0; i < n; ++i) {
      CHECK(std::abs(krylov.found.state.pressure[i] - dense.found.state.pressure[i]) < 1e-8);
    }
    CHECK(certify(*stiff, krylov.found.state).natural < 1e-10);
  }
}
