#include "numeric/coarse/coarse_equilibrium.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include "numeric/number/complementary_tableau.hpp"
#include "numeric/number/dense_lu.hpp"

namespace steadyslide::numeric::coarse {
namespace {

constexpr int most_rounds = 40;

/// Signs are decided up to this multiple of the load: what rounding of the forces and of the profile leaves open.
double sign_tolerance(const Mesh& mesh, const Load& load, const std::vector<char>& active) {
  double highest = 0;
  for (std::size_t i = 0; i < active.size(); ++i) {
    if (active[i]) highest = std::max(highest, std::abs(mesh.profile(i)));
  }
  return 1e-13 + 1e-15 * highest / load.force;
}

std::vector<std::size_t> indices(const std::vector<char>& active) {
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i < active.size(); ++i) {
    if (active[i]) result.push_back(i);
  }
  return result;
}

/// Contact leaves where it pulls and begins where bodies overlap; cells that carry the most stay if too few are left.
std::vector<char> corrected(const Mesh& mesh, const Equilibrium& state, const Load& load) {
  const double tolerance = sign_tolerance(mesh, load, state.active) * load.force;
  const std::size_t least = load.at ? 2 : 1;
  std::vector<char> active(state.active.size());
  for (std::size_t i = 0; i < active.size(); ++i) {
    active[i] = state.active[i] ? state.force[i] >= -tolerance : state.gap[i] < -tolerance;
  }
  auto count = static_cast<std::size_t>(std::count(active.begin(), active.end(), 1));
  for (; count < std::min(least, active.size()); ++count) {
    std::size_t best = active.size();
    for (std::size_t i = 0; i < active.size(); ++i) {
      if (!active[i] &&
          (best == active.size() || state.force[i] - state.gap[i] > state.force[best] - state.gap[best])) {
        best = i;
      }
    }
    active[best] = 1;
  }
  return active;
}

}  // namespace

Equilibrium with_contact_on(const Mesh& mesh, const Load& load, const std::vector<char>& active) {
  const Eigen::Index rest = load.at ? 2 : 1;  // unknowns C and tilt
  const std::vector<std::size_t> cells = indices(active);
  const auto count = static_cast<Eigen::Index>(cells.size());
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(count + rest, count + rest);
  Eigen::VectorXd right(count + rest);
  for (Eigen::Index k = 0; k < count; ++k) {
    const std::size_t j = cells[static_cast<std::size_t>(k)];
    const double* column = mesh.column(j);
    for (Eigen::Index i = 0; i < count; ++i) matrix(i, k) = column[cells[static_cast<std::size_t>(i)]];
    matrix(k, count) = -1;
    matrix(count, k) = 1;
    right(k) = -mesh.profile(j);
    if (load.at) {
      matrix(k, count + 1) = mesh.point(j);
      matrix(count + 1, k) = mesh.centre(j) - *load.at;
    }
  }
  right(count) = load.force;
  if (load.at) right(count + 1) = 0;
  const Eigen::VectorXd solution = DenseLu(matrix).solve(right);

  Equilibrium state;
  state.active = active;
  state.force.assign(active.size(), 0);
  state.tilt = load.at ? solution(count + 1) : 0;
  Eigen::VectorXd gap(static_cast<Eigen::Index>(active.size()));
  for (std::size_t i = 0; i < active.size(); ++i) {
    gap(static_cast<Eigen::Index>(i)) = mesh.profile(i) - solution(count) + state.tilt * mesh.point(i);
  }
  for (Eigen::Index k = 0; k < count; ++k) {
    const std::size_t j = cells[static_cast<std::size_t>(k)];
    state.force[j] = solution(k);
    gap += solution(k) * Eigen::Map<const Eigen::VectorXd>(mesh.column(j), gap.size());
  }
  for (std::size_t j : cells) gap(static_cast<Eigen::Index>(j)) = 0;
  state.gap.assign(gap.begin(), gap.end());
  if (!solution.allFinite() || !gap.allFinite()) {
    state.violation = HUGE_VAL;
    return state;
  }
  const double worst = std::min(*std::min_element(state.force.begin(), state.force.end()), gap.minCoeff());
  state.violation = std::max(0.0, -worst / load.force);
  state.converged = state.violation <= sign_tolerance(mesh, load, active);
  return state;
}

Equilibrium equilibrium(const Mesh& mesh, const Load& load, std::vector<char> guess) {
  if (guess.empty()) guess.assign(mesh.size(), 1);
  Equilibrium best;
  best.violation = HUGE_VAL;
  std::set<std::vector<char>> seen;
  const auto settle = [&](std::vector<char> active) {
    for (int round = 0; round < most_rounds && seen.insert(active).second; ++round) {
      Equilibrium state = with_contact_on(mesh, load, active);
      if (state.violation < best.violation || best.active.empty()) best = state;
      if (state.converged || !std::isfinite(state.violation)) return;
      active = corrected(mesh, state, load);
    }
  };
  settle(std::move(guess));
  if (best.converged) return best;
  if (std::vector<char> reached = load_path(mesh, load); !reached.empty()) {
    seen.clear();
    settle(std::move(reached));
  }
  return best;
}

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
