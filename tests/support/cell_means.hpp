#pragma once
// Exact means over cells of the traction that a Riemann-Hilbert form states, and cells spoilt as a variational solver
// spoils them: what fits to cells are tried on.

#include <boost/math/quadrature/gauss.hpp>
#include <random>

#include "numeric/variational/local_fit.hpp"
#include "numeric/variational/nested_solve.hpp"
#include "support/solved_contact.hpp"

namespace steadyslide::testing {

struct CellMeans {
  std::vector<double> edges;
  std::vector<double> mean;
  double length;

  numeric::variational::Cells cells() const { return {edges, mean}; }
};

/// `count` equal cells on the support, in the user's x. Gauss's rule: exact but in the very next cells of a singular
/// point, which no fit looks at.
inline CellMeans cell_means(const ContactProblem& problem, const numeric::RiemannHilbertSolution<double>& solution,
                            std::size_t count) {
  using Rule = boost::math::quadrature::gauss<double, 7>;
  const auto& form = solution.form();
  const auto& set = form.set();
  const double unit = numeric::to_real<double>(form.problem().frame().unit);
  const double origin = numeric::to_real<double>(form.problem().frame().origin);
  const double left = numeric::to_real<double>(problem.indenter().left());
  const double right = numeric::to_real<double>(problem.indenter().right());
  CellMeans result{{}, std::vector<double>(count), (right - left) / static_cast<double>(count)};
  for (std::size_t i = 0; i <= count; ++i) result.edges.push_back(left + result.length * static_cast<double>(i));
  for (std::size_t k = 0; k < set.segments(); ++k) {
    if (!set.in_contact(k)) continue;
    for (std::size_t i = 0; i < count; ++i) {
      const double from = std::max((result.edges[i] - origin) / unit, set.x(k));
      const double to = std::min((result.edges[i + 1] - origin) / unit, set.x(k + 1));
      if (!(from < to)) continue;
      const auto t = [&](double xi) {
        return form.traction(numeric::surface_point(set, k, xi - set.x(k), set.x(k + 1) - xi)).value;
      };
      result.mean[i] += Rule::integrate(t, from, to) * unit / result.length;
    }
  }
  return result;
}

/// The variational solver's cells, in the user's x and units.
inline CellMeans variational_means(const ContactProblem& problem, std::size_t count) {
  using namespace numeric::variational;
  const NestedResult found = solve_nested(problem, {.cells = count});
  REQUIRE(found.certificate.accepted());
  const CellMesh& mesh = found.fine.problem->mesh();
  const double unit = numeric::to_real<double>(mesh.frame().unit);
  const double origin = numeric::to_real<double>(mesh.frame().origin);
  CellMeans result{{}, {}, unit * mesh.length(0)};
  for (const double xi : mesh.edges()) result.edges.push_back(origin + unit * xi);
  const double pressure = numeric::to_real<double>(problem.load()) / unit;
  for (const double p : found.fine.found.state.pressure) result.mean.push_back(-pressure * p);
  return result;
}

/// Where contact that begins or ends near x does so on the cells.
inline double end_on_cells(const CellMeans& cells, double x, Side contact) {
  auto i = static_cast<std::size_t>((x - cells.edges.front()) / cells.length);
  const bool right = contact == Side::right;
  for (i += right ? 5 : -5; cells.mean[i] != 0; i += right ? -1 : 1) {
  }
  return cells.edges[right ? i + 1 : i];
}

/// The next singular points of the contact on either side of point j.
inline numeric::variational::LocalPlace local_place(const std::vector<numeric::SolvedSingularPoint<double>>& points,
                                                    std::size_t j) {
  numeric::variational::LocalPlace result{points[j].x.value};
  if (j > 0) result.left = points[j].x.value - points[j - 1].x.value;
  if (j + 1 < points.size()) result.right = points[j + 1].x.value - points[j].x.value;
  return result;
}

/// Errors of half the value in the four cells next to each singular point that fall with the square of the distance,
/// another error as smooth as the cells' length, and 16 `random`/d^2 at d cells that forgets itself from cell to cell.
inline void spoil(CellMeans& cells, const std::vector<numeric::SolvedSingularPoint<double>>& points, double random) {
  std::mt19937 generator(2016);
  std::uniform_real_distribution<double> sign(-1, 1);
  for (std::size_t i = 0; i < cells.mean.size(); ++i) {
    double error = 1e-3 * cells.length * std::cos(cells.edges[i]);
    for (const auto& point : points) {
      const double distance = std::abs((cells.edges[i] + cells.edges[i + 1]) / 2 - point.x.value) / cells.length;
      error += std::min(1.0, 16 / (distance * distance)) * (0.5 + random * sign(generator));
    }
    cells.mean[i] *= 1 + error;
  }
}

}  // namespace steadyslide::testing
