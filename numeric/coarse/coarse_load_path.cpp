#include <algorithm>
#include <cmath>
#include <numeric>

#include "numeric/coarse/coarse_equilibrium.hpp"
#include "numeric/number/complementary_tableau.hpp"

namespace steadyslide::numeric::coarse {
namespace {

/// Cells that touch when there is no load yet: the lowest one, or the two that span the load line on the lower hull.
std::vector<std::size_t> first_contact(const Mesh& mesh, const Load& load, const std::vector<double>& psi) {
  if (!load.at) return {static_cast<std::size_t>(std::min_element(psi.begin(), psi.end()) - psi.begin())};
  std::vector<std::size_t> hull;
  for (std::size_t i = 0; i < psi.size(); ++i) {
    const auto above = [&](std::size_t a, std::size_t b) {
      return (psi[b] - psi[a]) * (mesh.point(i) - mesh.point(a)) >= (psi[i] - psi[a]) * (mesh.point(b) - mesh.point(a));
    };
    while (hull.size() >= 2 && above(hull[hull.size() - 2], hull.back())) hull.pop_back();
    hull.push_back(i);
  }
  std::size_t k = 1;
  while (k + 1 < hull.size() && mesh.centre(hull[k]) < *load.at) ++k;
  return {hull[k - 1], hull[k]};
}

/// Flat faces and equal minima touch everywhere at once; a slight curvature, the same every time, gives them an order.
std::vector<double> with_order(const Mesh& mesh, const Load& load) {
  const std::vector<double>& edges = mesh.edges();
  const double width = edges.back() - edges.front();
  std::vector<double> psi(mesh.size());
  for (std::size_t i = 0; i < psi.size(); ++i) {
    const double x = (mesh.point(i) - edges.front()) / width - 0.4142135;
    psi[i] = mesh.profile(i) + 1e-8 * load.force * x * x;
  }
  return psi;
}

}  // namespace

std::vector<char> load_path(const Mesh& mesh, const Load& load) {
  // Variables: forces, as parts of the load (0..n-1), gaps in its unit (n..2n-1), C, the load, the tilt over the whole
  // support and the moment about the load line, which is on the right once and for all: it stays zero.
  using Eigen::Index;
  const auto n = static_cast<Index>(mesh.size());
  const Index rigid = 2 * n, load_sum = rigid + 1, tilt = rigid + 2, moment = rigid + 3;
  const Index rest = load.at ? 2 : 1;
  const double width = mesh.edges().back() - mesh.edges().front();
  const std::vector<double> psi = with_order(mesh, load);
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(n + rest, n + rest);
  Eigen::VectorXd constants = Eigen::VectorXd::Zero(n + rest);
  for (Index j = 0; j < n; ++j) {
    const auto cell = static_cast<std::size_t>(j);
    matrix.col(j).head(n) = Eigen::Map<const Eigen::VectorXd>(mesh.column(cell), n);
    matrix(n, j) = 1;
    matrix(j, n) = -1;
    constants(j) = psi[cell] / load.force;
    if (!load.at) continue;
    matrix(n + 1, j) = (mesh.centre(cell) - *load.at) / width;
    matrix(j, n + 1) = mesh.point(cell) / width;
  }
  std::vector<Index> left(static_cast<std::size_t>(n));
  std::vector<Index> right(left.size());
  std::iota(left.begin(), left.end(), n);
  std::iota(right.begin(), right.end(), Index(0));
  left.push_back(load_sum);
  right.push_back(rigid);
  if (load.at) {
    left.push_back(moment);
    right.push_back(tilt);
  }
  ComplementaryTableau tableau(n, left, right, std::move(matrix), std::move(constants));

  const std::vector<std::size_t> first = first_contact(mesh, load, psi);
  auto growing = static_cast<Index>(first.front());
  tableau.exchange(n + growing, rigid);
  if (first.size() > 1) {
    // The force farther from the load line follows from the other one.
    auto held = static_cast<Index>(first.back());
    tableau.exchange(n + held, tilt);
    const auto arm = [&](Index cell) { return std::abs(mesh.centre(static_cast<std::size_t>(cell)) - *load.at); };
    if (arm(growing) > arm(held)) std::swap(growing, held);
    tableau.exchange(moment, held);
  }
  const int most_pivots = 20 * static_cast<int>(n) + 100;
  if (tableau.follow(growing, load_sum, 1, most_pivots) != ComplementaryTableau::End::reached) return {};
  std::vector<char> active(mesh.size());
  for (Index i = 0; i < n; ++i) active[static_cast<std::size_t>(i)] = tableau.is_positive(i);
  return active;
}

}  // namespace steadyslide::numeric::coarse
