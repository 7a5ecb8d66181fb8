#pragma once
// Exact means over cells of the traction that a Riemann-Hilbert form states, and cells spoilt as a variational solver
// spoils them: what fits to cells are tried on.

#include <boost/math/quadrature/gauss.hpp>
#include <random>

#include "numeric/variational/local_fit.hpp"
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

/// The next singular points of the contact on either side of point j.
inline numeric::variational::LocalPlace local_place(const std::vector<numeric::SolvedSingularPoint<double>>& points,
                                                    std::size_t j) {
  numeric::variational::LocalPlace result{points[j].x.value};
  if (j > 0) result.left = points[j].x.value - points[j - 1].x.value;
  if (j + 1 < points.size()) result.right = points[j + 1].x.value - points[j].x.value;
  return result;
}

/// Errors as large as the values themselves in the four cells next to each singular point, falling with the square of
/// the distance: a random half that forgets from cell to cell, and a half of one sign.
inline void spoil(CellMeans& cells, const std::vector<numeric::SolvedSingularPoint<double>>& points, double random,
                  double steady) {
  std::mt19937 generator(2016);
  std::uniform_real_distribution<double> sign(-1, 1);
  for (std::size_t i = 0; i < cells.mean.size(); ++i) {
    double error = 1e-3 * cells.length * std::cos(cells.edges[i]);
    for (const auto& point : points) {
      const double distance = std::abs((cells.edges[i] + cells.edges[i + 1]) / 2 - point.x.value) / cells.length;
      const double size = std::min(1.0, 16 / (distance * distance));
      error += size * (random * sign(generator) + steady);
    }
    cells.mean[i] *= 1 + error;
  }
}

}  // namespace steadyslide::testing
